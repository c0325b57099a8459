#pragma once
// Looking: changes nothing in the document.

#include <memory>
#include <string>
#include <variant>

#include "editor/model/derived_picture.h"
#include "geometry/point.h"

namespace rinceau {

struct ResizeCanvas {
    Point size;  ///< framebuffer pixels
};
struct FitView {};
struct ZoomView {
    Point at;  ///< canvas, framebuffer pixels
    double factor = 1;
};
struct PanView {
    Point by;  ///< framebuffer pixels
};
/// The picture of a revision of the document has been derived, or could not be.
struct PictureDerived {
    std::uint64_t revision = 0;
    std::shared_ptr<const DerivedPicture> picture;
};
struct PictureFailed {
    std::uint64_t revision = 0;
    std::string message;
};

using CanvasAction = std::variant<ResizeCanvas, FitView, ZoomView, PanView, PictureDerived, PictureFailed>;

}  // namespace rinceau
