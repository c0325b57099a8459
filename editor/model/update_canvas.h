#pragma once
// What the parts of update() that concern the canvas share. Internal to the folder.

#include "editor/model/update_parts.h"

namespace rinceau {

// update_canvas_selection.cpp
void select_on_canvas(Update& update, const ClickCanvas& action);
void select_on_canvas(Update& update, const SelectLevel& action);
void select_on_canvas(Update& update, const StepSelection& action);
void select_on_canvas(Update& update, const ClearSelection& action);
void select_on_canvas(Update& update, const SelectionFound& action);

/// There is another picture: what is selected is looked for in it.
void follow_selection(Update& update);

// update_canvas_drag.cpp
void drag_on_canvas(Update& update, const GrabHandle& action);
void drag_on_canvas(Update& update, const DragHandle& action);
void drag_on_canvas(Update& update, const ReleaseHandle& action);
void drag_on_canvas(Update& update, const DropHandle& action);

}  // namespace rinceau
