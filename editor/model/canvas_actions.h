#pragma once
// Looking: changes nothing in the document.

#include <memory>
#include <string>
#include <variant>

#include "editor/model/derived_picture.h"
#include "editor/model/find_selection.h"
#include "editor/model/lit_items.h"
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
    Point at;            ///< scene
    double reach = 0;    ///< how far from an element still hits it, scene units
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
/// What comes after, or before, what is selected in order of derivation, at the same level if it has it.
struct SelectNeighbour {
    bool next = true;
};
struct ClearSelection {};

/// The element under the mouse, if any, is marked.
struct HoverCanvas {
    Point at;          ///< scene
    double reach = 0;  ///< scene units
};
struct LeaveCanvas {};
/// All that a rule draws is lit, the rest fades: a production of the document's grammar, -1 = the axiom.
struct HoverRule {
    int production = no_production;
};
/// All elements of a terminal of the resolved grammar are lit; -1 = none.
struct HoverTerminal {
    int terminal = -1;
};
/// These elements are lit, by order of derivation; null = none.
struct HoverItems {
    LitItems lit;
};
struct RuleLit {
    std::uint64_t revision = 0;
    int production = no_production;
    LitItems lit;
};

/// The drawing as it was opened beside what it is now.
struct ShowOnion {
    OnionMode mode = OnionMode::off;
};
struct BeforeDerived {
    std::shared_ptr<const DerivedPicture> picture;
};

struct ZoomToSelection {};
struct ActualSize {};  ///< a unit of the scene becomes a pixel of a display of scale 1

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

/// What is selected is no more: an exception.
struct EraseSelected {};

struct CanvasAction
    : std::variant<ResizeCanvas, FitView, ZoomView, PanView, PictureDerived, PictureFailed, ClickCanvas, SelectLevel,
                   StepSelection, SelectNeighbour, ClearSelection, SelectionFound, HoverCanvas, LeaveCanvas, HoverRule,
                   HoverTerminal, HoverItems, RuleLit, ShowOnion, BeforeDerived, ZoomToSelection, ActualSize, GrabHandle,
                   DragHandle, ReleaseHandle, DropHandle, EraseSelected> {
    using variant::variant;
    CanvasAction(const CanvasAction&);
    CanvasAction(CanvasAction&&) noexcept;
    CanvasAction& operator=(const CanvasAction&);
    CanvasAction& operator=(CanvasAction&&) noexcept;
    ~CanvasAction();
};

}  // namespace rinceau
