// The window itself.

#include "editor/model/update_parts.h"

namespace rinceau {
namespace {

void perform_one(Update& update, const SetDarkTheme& action) { update.state.shell.dark = action.dark; }
void perform_one(Update& update, const ShowHelp& action) { update.state.shell.help = action.shown; }
void perform_one(Update& update, const DismissMessages&) { update.state.messages.clear(); }

}  // namespace

void perform(Update& update, const ShellAction& action) {
    std::visit([&](const auto& one) { perform_one(update, one); }, action);
}

}  // namespace rinceau
