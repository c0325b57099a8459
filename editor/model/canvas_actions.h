#pragma once
// Looking: changes nothing in the document.

#include <memory>
#include <string>
#include <variant>

#include "editor/model/derived_picture.h"
#include "editor/model/find_selection.h"
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

/// The element there is selected, or, if it was the one that was clicked before, the level above; nothing is where there is
/// no element.
struct ClickCanvas {
    Point at;          ///< scene
    double reach = 0;  ///< how far from an element still hits it, scene units
    bool below = false;  ///< the element under the one that would be hit
};
/// Of the path of the selection.
struct SelectLevel {
    std::size_t level = 0;
};
/// To the axiom, or back to the element.
struct StepSelection {
    int levels = 0;  ///< > 0: down
};
struct ClearSelection {};

/// One of CanvasState::handles is taken hold of, dragged, let go. What it changes is previewed and recorded once.
struct GrabHandle {
    std::size_t index = 0;
    Point at;  ///< scene
};
struct DragHandle {
    Point to;                ///< scene
    bool only_here = false;  ///< for this one place or element, not for all
};
struct ReleaseHandle {};
struct DropHandle {};  ///< all is as before it was grabbed

using CanvasAction = std::variant<ResizeCanvas, FitView, ZoomView, PanView, PictureDerived, PictureFailed, ClickCanvas,
                                  SelectLevel, StepSelection, ClearSelection, SelectionFound, GrabHandle, DragHandle,
                                  ReleaseHandle, DropHandle>;

}  // namespace rinceau
