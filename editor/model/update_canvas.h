#pragma once
// What the parts of update() that concern the canvas share. Internal to the folder.

#include "editor/model/update_parts.h"

namespace rinceau {

// update_canvas_view.cpp
void show_on_canvas(Update& update, const ShowOnion& action);
void show_on_canvas(Update& update, const BeforeDerived& action);
void show_on_canvas(Update& update, const ZoomToSelection& action);
void show_on_canvas(Update& update, const ActualSize& action);

// update_canvas_hover.cpp
void show_on_canvas(Update& update, const HoverCanvas& action);
void show_on_canvas(Update& update, const LeaveCanvas& action);
void show_on_canvas(Update& update, const HoverRule& action);
void show_on_canvas(Update& update, const HoverTerminal& action);
void show_on_canvas(Update& update, const HoverItems& action);
void show_on_canvas(Update& update, const RuleLit& action);

/// There is another picture: what is hovered is lit in it.
void follow_hover(Update& update);

// update_canvas_selection.cpp
void select_on_canvas(Update& update, const ClickCanvas& action);
void select_on_canvas(Update& update, const SelectLevel& action);
void select_on_canvas(Update& update, const StepSelection& action);
void select_on_canvas(Update& update, const SelectNeighbour& action);
void select_on_canvas(Update& update, const ClearSelection& action);
void select_on_canvas(Update& update, const SelectionFound& action);

/// There is another picture: what is selected is looked for in it.
void follow_selection(Update& update);

// update_canvas_drag.cpp
void drag_on_canvas(Update& update, const GrabHandle& action);
void drag_on_canvas(Update& update, const DragHandle& action);
void drag_on_canvas(Update& update, const ReleaseHandle& action);
void drag_on_canvas(Update& update, const DropHandle& action);
void drag_on_canvas(Update& update, const EraseSelected& action);

}  // namespace rinceau
