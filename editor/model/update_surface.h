#pragma once
// What the parts of update() for growth on a surface share. Internal to the folder.

#include "editor/model/surface_view.h"
#include "editor/model/update_parts.h"

namespace rinceau {

// update_surface_view.cpp
void perform_one(Update& update, const ResizeSurfaceView& action);
void perform_one(Update& update, const TurnSurface& action);
void perform_one(Update& update, const PanSurface& action);
void perform_one(Update& update, const ZoomSurface& action);
void perform_one(Update& update, const FitSurface& action);
void perform_one(Update& update, const PressSurface& action);
void perform_one(Update& update, const DragSurface& action);
void perform_one(Update& update, const ReleaseSurface& action);
void perform_one(Update& update, const TurnMark& action);
void perform_one(Update& update, const RemoveMark& action);
void perform_one(Update& update, const ClearMarks& action);

/// The surface in the middle of the view, if it waits for that and the view has a size.
void fit_surface_if_pending(SurfaceState& surface);

}  // namespace rinceau
