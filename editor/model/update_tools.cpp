// Tools that change the whole grammar. They run outside: one at a time, and of those that were asked for meanwhile the last.

#include <utility>

#include "editor/model/tool_view.h"
#include "editor/model/update_rules.h"
#include "editor/model/update_tools.h"

namespace rinceau {
namespace {

void start(Update& update, ToolRun run) {
    EditorState& state = update.state;
    ToolsState& tools = state.tools;
    const std::size_t elements = state.picture ? state.picture->items.size() : 0;
    const bool quick = is_quick_to_edit(state.document, elements);
    ++tools.job;
    tools.running = std::move(run);
    tools.dropped = false;
    tools.base = state.document.grammar;
    tools.revision = state.revision;
    update.requests.push_back(RunTool{tools.job, state.document, tools.running->edit, quick});
}

void start_waiting(Update& update) {
    std::optional<ToolRun> next = std::exchange(update.state.tools.waiting, std::nullopt);
    if (next) start(update, std::move(*next));
}

Document with_result(const Document& document, const ToolEdit& edit, const ToolResult& result) {
    Document after = document;
    after.grammar = result.grammar;
    after.resolved = result.resolved;
    const auto* random = std::get_if<RandomizeEdit>(&edit);
    if (random != nullptr && random->options.seed) after.derive.seed.reset();  // the grammar's is looked at
    return after;
}

void show_result(Update& update, const std::shared_ptr<const ToolEdit>& edit, ToolResult result) {
    EditorState& state = update.state;
    state.preview = with_result(state.document, *edit, result);
    state.preview_label = tool_label(*edit);
    state.tools.previewed = result.grammar;
    state.tools.edit = edit;
    state.tools.changes = std::move(result.changes);
    state.tools.mistake.clear();
    show_anew(update);
}

void record_result(Update& update, const ToolEdit& edit, ToolResult result) {
    EditorState& state = update.state;
    state.tools.settings.noise = {};  // the grammar has it now
    state.tools.mistake.clear();
    if (result.changes.empty()) {
        tell(update, MessageKind::note, tool_label(edit) + ": nothing is different");
        const bool previewed = std::exchange(state.preview, std::nullopt).has_value();
        if (previewed) show_anew(update);
        return;
    }
    for (std::string& change : result.changes) tell(update, MessageKind::note, std::move(change));
    record_edit(update, with_result(state.document, edit, result), tool_label(edit));
}

void perform_one(Update& update, const OpenTool& action) { update.state.tools.open = action.section; }

void perform_one(Update& update, const SetTools& action) { update.state.tools.settings = action.settings; }

void perform_one(Update& update, const SetNoise& action) {
    EditorState& state = update.state;
    state.tools.settings.noise = action.noise;
    const NoiseInGrammar noise = shown_noise(state);
    const bool random = noise.angle || noise.distance || noise.scale || !action.noise.named.empty() ||
                        draws_random_numbers(*state.document.resolved);
    if (random) ask_for_tool(update, shared_edit(RandomizeEdit{action.noise}), true);
}

void perform_one(Update& update, const NewSeed&) {
    RandomizeOptions noise = update.state.tools.settings.noise;
    noise.seed = shown_seed(update.state) + 1;
    perform_one(update, SetNoise{std::move(noise)});
}

void perform_one(Update& update, const UseTool& action) { ask_for_tool(update, action.edit, action.preview); }

void perform_one(Update& update, const KeepTool&) {
    if (shows_tool_preview(update.state)) ask_for_tool(update, update.state.tools.edit, false);
}

void perform_one(Update& update, const ToolDone& action) {
    EditorState& state = update.state;
    ToolsState& tools = state.tools;
    if (action.job != tools.job || !tools.running) return;
    const ToolRun run = *std::exchange(tools.running, std::nullopt);
    const bool same_document = tools.base == state.document.grammar;
    if (!run.preview && same_document) {
        record_result(update, *run.edit, action.result);
    } else if (!run.preview) {
        tell(update, MessageKind::warning,
             tool_label(*run.edit) + " was not done: something else was edited meanwhile. Do it again");
    } else if (same_document && !tools.dropped && tools.revision == state.revision) {
        show_result(update, run.edit, action.result);
    }
    start_waiting(update);
}

void perform_one(Update& update, const ToolFailed& action) {
    ToolsState& tools = update.state.tools;
    if (action.job != tools.job || !tools.running) return;
    const bool preview = std::exchange(tools.running, std::nullopt)->preview;
    tools.mistake = action.message;
    if (preview && shows_tool_preview(update.state)) drop_preview(update);
    if (!preview) tell(update, MessageKind::mistake, action.message);
    start_waiting(update);
}

}  // namespace

void drop_tool(EditorState& state) {
    if (shows_tool_preview(state)) state.tools.settings.noise = {};  // what is not wanted is not set, either
    state.tools.dropped = true;
    state.tools.waiting.reset();
}

void ask_for_tool(Update& update, std::shared_ptr<const ToolEdit> edit, bool preview) {
    ToolRun run{std::move(edit), preview};
    if (update.state.tools.running) {
        update.state.tools.waiting = std::move(run);
    } else {
        start(update, std::move(run));
    }
}

void perform(Update& update, const ToolsAction& action) {
    std::visit([&](const auto& one) { perform_one(update, one); }, action);
}

}  // namespace rinceau
