#pragma once
// The meshes of shapes, kept from picture to picture: shapes are known by what they look like, not by where they are kept.

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "editor/gl/look_paint.h"
#include "geometry/box.h"
#include "scene/path.h"
#include "scene/style.h"

namespace rinceau {

struct ShapeVertex {
    float x = 0, y = 0;  ///< about the shape's origin
    float part = 0;      ///< number of the LookPart
};

/// Both parts in one list of triangles, in an order in which they can be drawn at once (see ShapeOrder).
struct ShapeMesh {
    std::vector<ShapeVertex> vertices;
    std::vector<std::uint32_t> indices;
};

/// Which part comes first in a mesh. What is drawn later never covers what was drawn before at the same or a lesser depth,
/// so that the upper part may come first; it must, where both are faded together, and must not, where it is translucent
/// itself.
enum class ShapeOrder : std::uint8_t { upper_first, lower_first };

/// A mesh of a shape: fine enough where a unit of the frame is up to 2^level pixels long.
struct MeshLevel {
    int level = 0;
    int stroke_bucket = 0;  ///< of the scale, for strokes of fixed width; 0 for others
    friend constexpr auto operator<=>(const MeshLevel&, const MeshLevel&) = default;
};

/// An outline with what of a style shapes its meshes.
struct Shape {
    std::vector<Path> paths;
    Style style;
    ShapeOrder order = ShapeOrder::upper_first;
    Point origin;             ///< middle of the paths; meshes are about it, so that floats suffice
    double radius = 0;        ///< about the origin, of the paths and of strokes that follow the scale
    double fixed_margin = 0;  ///< scene units that a stroke of fixed width adds
    std::map<MeshLevel, std::shared_ptr<const ShapeMesh>> meshes;
    std::uint64_t last_use = 0;
};

/// The bucket of a scale, and the scale that the meshes of a bucket are made for: 0.02 % apart.
int stroke_bucket(double scale);
double bucket_scale(int bucket);

class ShapeStore {
  public:
    /// The shape of paths in a style, found or new. Holds until `forget_unused`.
    std::shared_ptr<Shape> shape(const std::vector<Path>& paths, const Style& style, const LookPaint& paint);

    /// The same text, kept once: equal texts have one address as long as somebody holds them.
    std::shared_ptr<const std::string> text(const std::string& text);

    /// Makes the meshes that are not there yet, on all processors, until the time is up.
    void make_meshes(const std::vector<std::pair<std::shared_ptr<Shape>, MeshLevel>>& wanted,
                     std::chrono::steady_clock::time_point deadline);

    /// Lets go of the shapes that none of the last few tables of looks had, once there are many.
    void forget_unused();

  private:
    std::unordered_multimap<std::uint64_t, std::shared_ptr<Shape>> shapes_;
    std::unordered_multimap<std::size_t, std::shared_ptr<const std::string>> texts_;
    std::uint64_t now_ = 0;
};

/// The mesh, or the nearest of the same stroke that there is; null if there is none.
std::shared_ptr<const ShapeMesh> nearest_mesh(const Shape& shape, const MeshLevel& level);

}  // namespace rinceau
