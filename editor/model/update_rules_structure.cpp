// Productions: added, removed, moved, renamed, commented.

#include <numeric>

#include "editor/model/update_rules.h"
#include "geometry/index.h"
#include "lsystem/follow_numbers.h"

namespace rinceau {
namespace {

bool is_production(const EditorState& state, int index) {
    return index >= 0 && at(index) < state.document.grammar->productions.size();
}

std::vector<int> same_indices(const Grammar& grammar) {
    std::vector<int> indices(grammar.productions.size());
    std::iota(indices.begin(), indices.end(), 0);
    return indices;
}

/// An edit that leaves every number's value: locks go along with the productions.
void edit_places(Update& update, const std::string& label, const std::function<EditResult(const Grammar&)>& edit,
                 const std::vector<int>& new_index) {
    const Document before = update.state.document;
    const auto locked = [&](const Document& after) {
        return names_afterwards(*before.grammar, *after.grammar, new_index, before.locked);
    };
    if (edit_document(update, {.label = label, .grammar = edit, .locked = locked, .rest = {}})) {
        update.state.rules.typed.reset();
        update.state.rules.written.reset();
        update.state.rules.removal.reset();
    }
}

}  // namespace

void perform_one(Update& update, const AddProduction& action) {
    const Grammar& grammar = *update.state.document.grammar;
    std::vector<int> new_index = same_indices(grammar);
    for (int& index : new_index)
        if (action.options.before >= 0 && index >= action.options.before) ++index;
    edit_places(
        update, "add a rule", [&](const Grammar& before) { return add_production(before, action.options); }, new_index);
}

void perform_one(Update& update, const RemoveProduction& action) {
    EditorState& state = update.state;
    state.rules.removal.reset();
    if (!is_production(state, action.production)) return;
    const Grammar& grammar = *state.document.grammar;
    const std::string label = "remove " + grammar.productions[at(action.production)].symbol;
    const std::string reason = reason_to_keep(grammar, action.production);
    if (!reason.empty() && !action.uses) {
        state.rules.removal = {action.production, reason};
        return;
    }
    const auto remove = [&](const Grammar& before) {
        ReplaceOptions options;
        options.derive = state.document.derive;
        options.resolve = [&](const Grammar& written) { return *with_grammar(state.document, written).resolved; };
        return remove_production(before, action.production, action.uses, options);
    };
    if (!reason.empty()) {
        edit_grammar(update, label, remove);
        return;
    }
    std::vector<int> new_index = same_indices(grammar);
    for (int& index : new_index) index = index == action.production ? -1 : index - (index > action.production ? 1 : 0);
    edit_places(update, label, remove, new_index);
}

void perform_one(Update& update, const KeepProduction&) { update.state.rules.removal.reset(); }

void perform_one(Update& update, const MoveProduction& action) {
    if (!is_production(update.state, action.production) || !is_production(update.state, action.to)) return;
    const Grammar& grammar = *update.state.document.grammar;
    std::vector<int> order = same_indices(grammar);
    order.erase(order.begin() + action.production);
    order.insert(order.begin() + action.to, action.production);
    std::vector<int> new_index(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) new_index[at(order[i])] = static_cast<int>(i);
    edit_places(
        update, "move " + grammar.productions[at(action.production)].symbol,
        [&](const Grammar& before) { return move_production(before, action.production, action.to); }, new_index);
}

void perform_one(Update& update, const RenameSymbol& action) {
    edit_places(
        update, "rename " + action.from,
        [&](const Grammar& before) { return rename_symbol(before, action.from, action.to); },
        same_indices(*update.state.document.grammar));
}

void perform_one(Update& update, const CommentProduction& action) {
    if (!is_production(update.state, action.production)) return;
    edit_places(
        update, "comment " + update.state.document.grammar->productions[at(action.production)].symbol,
        [&](const Grammar& before) { return comment_production(before, action.production, action.comment); },
        same_indices(*update.state.document.grammar));
}

void perform_one(Update& update, const WriteCard& action) {
    if (!is_production(update.state, action.production)) return;
    update.state.rules.written = {.field = action.field, .production = action.production, .text = action.text};
}

void perform_one(Update& update, const EnterCard&) {
    EditorState& state = update.state;
    if (!state.rules.written || !is_production(state, state.rules.written->production)) return;
    const WrittenCard written = *state.rules.written;
    const Production& production = state.document.grammar->productions[at(written.production)];
    if (written.field == CardField::comment) {
        state.rules.written.reset();
        if (written.text != production.comment) perform_one(update, CommentProduction{written.production, written.text});
        return;
    }
    if (written.text == production.symbol) {
        state.rules.written.reset();
        return;
    }
    perform_one(update, RenameSymbol{production.symbol, written.text});
    if (state.rules.written && !state.messages.empty()) state.rules.written->mistake = state.messages.back().text;
}

void perform_one(Update& update, const StopCard&) { update.state.rules.written.reset(); }

}  // namespace rinceau
