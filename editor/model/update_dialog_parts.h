#pragma once
// What update_dialog.cpp shares with update_dialog_pick.cpp. Internal to the folder.

#include "editor/model/update_parts.h"

namespace rinceau {

// update_dialog_pick.cpp
void perform_pick(Update& update, const ShowPickList& action);
void perform_pick(Update& update, const SamplesListed& action);
void perform_pick(Update& update, const MoveInPickList& action);
void perform_pick(Update& update, const PickItemAt& action);
void perform_pick(Update& update, const ClosePickList& action);

}  // namespace rinceau
