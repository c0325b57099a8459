#pragma once
// Which items of a picture are seen in a region, and by which mesh each is drawn. Pure.

#include <cstdint>
#include <memory>
#include <vector>

#include "editor/gl/look_table.h"
#include "editor/gl/shape_store.h"
#include "geometry/box.h"

namespace rinceau {

/// Items that one mesh draws.
struct SeenGroup {
    std::int32_t look = 0;
    MeshLevel level;
    std::shared_ptr<const ShapeMesh> mesh;  ///< null until `give_meshes`, or if there is none
    std::uint32_t count = 0;
    std::int32_t next_of_look = -1;  ///< in a list of the look's groups
};

struct SeenItem {
    std::uint32_t item = 0;   ///< index into DerivedPicture::items
    std::int32_t group = -1;  ///< -1 = a verbatim fragment
};

struct SeenItems {
    std::vector<SeenItem> items;  ///< in paint order
    std::vector<SeenGroup> groups;
    std::size_t left_out = 0;  ///< beyond the number that can be drawn
};

struct SeenRequest {
    Box region;                               ///< scene
    double zoom = 1;                          ///< pixels a scene unit, at the most
    const std::vector<char>* only = nullptr;  ///< items whose flag (by order) is set; null = all
    std::size_t most = 0;                     ///< items that can be drawn
};

/// Items with numbers that are not finite are not seen.
SeenItems seen_items(const LookTable& table, const SeenRequest& request);

/// Where a fragment may draw, in the scene; empty = not known.
Box fragment_box(const LookTable& table, const PictureItem& item);

}  // namespace rinceau
