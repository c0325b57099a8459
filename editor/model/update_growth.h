#pragma once
// What the parts of update() for growth share. Internal to the folder.

#include "editor/model/arrange_order.h"
#include "editor/model/fill_order.h"
#include "editor/model/growth_view.h"
#include "editor/model/update_parts.h"

namespace rinceau {

// update_growth_paint.cpp
void perform_one(Update& update, const TakeBrush& action);
void perform_one(Update& update, const PressBrush& action);
void perform_one(Update& update, const DragBrush& action);
void perform_one(Update& update, const ReleaseBrush& action);
void perform_one(Update& update, const DropStroke& action);
void perform_one(Update& update, const EraseStrokes& action);
void perform_one(Update& update, const ForgetFlips& action);

// update_growth_work.cpp
void perform_one(Update& update, const BeginGrowth& action);
void perform_one(Update& update, const GrowMore& action);
void perform_one(Update& update, const FinishGrowth& action);
void perform_one(Update& update, const FillAggregate& action);
void perform_one(Update& update, const GrowOtherSeed& action);
void perform_one(Update& update, const StopGrowth& action);
void perform_one(Update& update, const DropGrowth& action);
void perform_one(Update& update, const BringBackGrowth& action);
void perform_one(Update& update, const UseGrowth& action);
void perform_one(Update& update, const GrowthProgress& action);
void perform_one(Update& update, const PatternGrown& action);
void perform_one(Update& update, const GrowthFailed& action);
void perform_one(Update& update, const GrownDocumentMade& action);

/// The work that runs, if any, ends without a result.
void drop_growth_work(Update& update);

/// What waits is begun, if nothing else runs and the source is there.
void start_waiting_growth(Update& update);

/// These steps are to be done after those that were asked for before.
void ask_for_growth(Update& update, std::vector<ArrangeStep> steps);

/// The panel of growth is brought to the front with this tab.
void open_growth_panel(EditorState& state, GrowthTab tab);

/// What has grown comes to the canvas in the document's place, or goes from it.
void show_growth(Update& update, bool shown);

/// A blank canvas takes the place of what has grown, which can be brought back.
void begin_blank(Update& update);

}  // namespace rinceau
