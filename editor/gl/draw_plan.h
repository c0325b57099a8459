#pragma once
// What is drawn of a picture, in which order and in how few calls. Pure: the graphics card gets it as it is.
//
// Every item has two ranks, 2 i and 2 i + 1 for its lower and its upper part, i being its place in paint order, which become
// depths. What hides all below it is drawn first, in any order; then, in paint order, what lets through what lies below.

#include <chrono>
#include <cstdint>
#include <memory>
#include <vector>

#include "editor/gl/look_table.h"
#include "editor/gl/shape_store.h"
#include "editor/model/derived_picture.h"
#include "geometry/box.h"

namespace rinceau {

/// The most items whose ranks a depth buffer of floats keeps apart.
constexpr std::size_t most_drawn_items = (std::size_t{1} << 23U) - 1;

/// An item that is drawn as an instance of a mesh.
struct PlanInstance {
    float linear_x = 1, linear_y = 0;  ///< of the pose
    float x = 0, y = 0;                ///< of the shape's origin, about the plan's
    std::uint32_t place = 0;           ///< 2 i, + 1 if mirrored
    PackedColor fill{}, stroke{};
};

/// Vertices of items too few of a kind to be instances.
struct StreamVertex {
    float x = 0, y = 0;      ///< scene, about the plan's origin
    std::uint32_t rank = 0;  ///< 2 i, or 2 i + 1 for the upper part
    PackedColor color{};
};

struct StreamGradient {
    float x = 0, y = 0;        ///< in the unit gradient
    std::uint32_t number = 0;  ///< of the gradient; 0 = solid
};

enum class PlanStepKind : std::uint8_t { instances, stream, fragment };

/// Two parts that are faded together (LookPaint::mixes_within) take three steps: the upper part marks its place by its
/// depth; the lower part is drawn beside it; both are drawn where it is.
enum class PlanStage : std::uint8_t { plain, mark, marked };

struct PlanStep {
    PlanStepKind kind = PlanStepKind::instances;
    std::int32_t look = 0;                  ///< of instances
    std::uint32_t first = 0;                ///< instance; index of the stream; item of a fragment
    std::uint32_t count = 0;                ///< of instances or indices
    std::shared_ptr<const ShapeMesh> mesh;  ///< of instances
    PlanStage stage = PlanStage::plain;
    bool crisp = false;
    bool gradients = false;
};

struct DrawPlan {
    Point origin;  ///< scene point that numbers are relative to
    std::vector<PlanInstance> instances;
    std::vector<StreamVertex> stream;
    std::vector<StreamGradient> stream_gradients;  ///< as many as vertices, or none
    std::vector<std::uint32_t> indices;            ///< of the stream
    std::vector<PlanStep> opaque;                  ///< in any order
    std::vector<PlanStep> translucent;             ///< in this order, after the opaque
    std::size_t left_out = 0;                      ///< items that the bounds on memory leave out
    bool complete = true;                          ///< false: meshes were still missing or coarse; plan again
};

struct PlanRequest {
    Box region;                                        ///< scene: what lies outside is not drawn
    double zoom = 1;                                   ///< pixels a scene unit, at the most
    const std::vector<char>* only = nullptr;           ///< items whose flag (by order) is set; null = all
    std::chrono::steady_clock::time_point deadline{};  ///< until when meshes may be made
};

DrawPlan draw_plan(const LookTable& table, const PlanRequest& request, ShapeStore& store);

}  // namespace rinceau
