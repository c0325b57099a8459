// Lists from which a document is chosen: samples and recent files.

#include <algorithm>

#include "editor/model/file_kind.h"
#include "editor/model/update_dialog_parts.h"

namespace rinceau {

void perform_pick(Update& update, const ShowPickList& action) {
    PickList list{.of = action.of};
    if (action.of == PickList::Of::samples) {
        list.waiting = true;
        update.requests.push_back(ListSamples{});
    }
    for (const std::string& path : update.state.file.recent)
        if (action.of == PickList::Of::recent) list.items.push_back({file_name_of(path), path});
    update.state.dialog.file.reset();
    update.state.dialog.list = std::move(list);
}

void perform_pick(Update& update, const SamplesListed& action) {
    auto& list = update.state.dialog.list;
    if (!list || list->of != PickList::Of::samples) return;
    list->items = action.samples;
    list->waiting = false;
}

void perform_pick(Update& update, const MoveInPickList& action) {
    auto& list = update.state.dialog.list;
    if (!list || list->items.empty()) return;
    list->selected = std::clamp(list->selected + action.rows, 0, static_cast<int>(list->items.size()) - 1);
}

void perform_pick(Update& update, const PickItemAt& action) {
    auto& list = update.state.dialog.list;
    const int row = action.row < 0 && list ? list->selected : action.row;
    if (!list || row < 0 || row >= static_cast<int>(list->items.size())) return;
    const std::string path = list->items[static_cast<std::size_t>(row)].path;
    const bool sample = list->of == PickList::Of::samples;
    list.reset();
    perform(update, sample ? FileAction{OpenSample{path}} : FileAction{OpenFile{path}});
}

void perform_pick(Update& update, const ClosePickList&) { update.state.dialog.list.reset(); }

}  // namespace rinceau
