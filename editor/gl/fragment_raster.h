#pragma once
// Verbatim parts of a drawing as pixels, exactly as they fall on the frame. Pure.

#include <memory>
#include <optional>
#include <string>

#include "editor/model/view_transform.h"
#include "geometry/affine.h"
#include "geometry/box.h"
#include "geometry/similarity.h"
#include "scene/picture.h"

namespace rinceau {

/// Pixels of a frame: x right, y down, origin in the upper left corner.
struct PixelRect {
    int left = 0, top = 0, width = 0, height = 0;
    friend constexpr bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// Texts are shared: the same text has one address.
struct FragmentPlace {
    std::shared_ptr<const std::string> text;
    Affine to_pixels;    ///< the fragment's space, y down, -> pixels
    PixelRect rect;      ///< where it may draw, within the frame and some room around
    PixelRect on_frame;  ///< the part of it within the frame itself; may be empty
};

/// Where a fragment falls; nothing if it is not near the frame or its numbers are out of range. `box` is in the terminal's
/// frame, y up; empty = it may draw anywhere.
std::optional<FragmentPlace> fragment_place(const std::shared_ptr<const std::string>& text, const Box& box,
                                            const Similarity& pose, const ViewTransform& view);

/// True if the pixels of `drawn`, moved by whole pixels, are those of `wanted` within the frame.
bool serves(const FragmentPlace& drawn, const FragmentPlace& wanted);

/// The pixels of place.rect by librsvg; nothing if it refuses the fragment.
std::optional<TransparentPicture> fragment_pixels(const FragmentPlace& place);

}  // namespace rinceau
