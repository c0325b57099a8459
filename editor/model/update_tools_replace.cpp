// Replacing a symbol: what takes its place is read first.

#include <utility>

#include "editor/model/tool_view.h"
#include "editor/model/update_tools.h"

namespace rinceau {
namespace {

void replace(Update& update, bool preview) {
    const ToolsState& tools = update.state.tools;
    const ReplaceSettings& settings = tools.settings.replace;
    ReplaceEdit edit{*tools.read, {.fit = settings.fit, .turn = settings.turn, .restyle = settings.restyle}};
    edit.replacement.symbol = symbol_to_replace(update.state);
    ask_for_tool(update, shared_edit(std::move(edit)), preview);
}

}  // namespace

void perform_one(Update& update, const UseReplace& action) {
    ToolsState& tools = update.state.tools;
    const std::string& with = tools.settings.replace.with;
    // what is seen in a preview is what is put in, even if the file has changed since
    const bool known = tools.read && tools.read_with == with && (action.preview || shows_tool_preview(update.state));
    if (known) {
        replace(update, action.preview);
        return;
    }
    tools.reading = action.preview;
    update.requests.push_back(ReadReplacement{symbol_to_replace(update.state), with});
}

void perform_one(Update& update, const ReplacementRead& action) {
    ToolsState& tools = update.state.tools;
    if (!tools.reading || action.with != tools.settings.replace.with) return;
    const bool preview = *std::exchange(tools.reading, std::nullopt);
    for (const std::string& warning : action.warnings) tell(update, MessageKind::warning, warning);
    tools.read = action.replacement;
    tools.read_with = action.with;
    replace(update, preview);
}

void perform_one(Update& update, const ReplacementFailed& action) {
    ToolsState& tools = update.state.tools;
    if (!tools.reading || action.with != tools.settings.replace.with) return;
    tools.reading.reset();
    tools.mistake = action.message;
    tell(update, MessageKind::mistake, action.message);
}

}  // namespace rinceau
