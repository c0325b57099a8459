#pragma once
// Windows that stand before the others.

#include <optional>
#include <string>

#include "editor/model/file_dialog.h"
#include "editor/model/pick_list.h"

namespace rinceau {

struct DialogState {
    std::optional<FileDialog> file;
    std::optional<PickList> list;
    ExportChoices export_choices;               ///< of the last export
    std::string export_format = "picture-svg";  ///< of the last export
};

}  // namespace rinceau
