// Numbers: dragged, typed, reset, locked.

#include <algorithm>

#include "editor/model/number_feel.h"
#include "editor/model/update_rules.h"
#include "geometry/index.h"
#include "lsystem/set_numbers.h"

namespace rinceau {
namespace {

const GrammarNumber* number_named(const std::shared_ptr<const RuleSheet>& sheet, const std::string& name) {
    const int index = sheet ? find_number(*sheet, name) : -1;
    return index < 0 ? nullptr : &sheet->numbers[at(index)];
}

EditResult with_number(const Grammar& grammar, const std::string& name, double value, const SetOptions& options = {}) {
    const NumberEdit edit{.name = name, .value = number_expression(value)};
    return set_numbers(grammar, {&edit, 1}, options);
}

std::string set_label(const std::string& name) { return "set " + name; }

void drag(Update& update, const SetNumber& action) {
    RulesState& rules = update.state.rules;
    const GrammarNumber* number = number_named(rules.sheet, action.name);
    if (number == nullptr) return;
    if (!rules.dragged || rules.dragged->name != action.name) {
        rules.dragged = {.name = action.name, .start = number->value, .set = number->value};
        update.state.preview.reset();
    }
    if (rules.dragged->dropped) return;
    rules.dragged->wanted = action.value;
    const double value = felt_value(number_feel(*number, rules.dragged->start), action.value);
    if (value == rules.dragged->set) return;
    const auto revision = update.state.revision;
    preview_grammar(update, set_label(action.name), [&](const Grammar& grammar) {
        return with_number(grammar, action.name, value, {.nearest_ring = true, .say_changes = false});
    });
    if (update.state.revision != revision) rules.dragged->set = value;
}

std::string edit_text(const TypedNumber& typed) {
    std::string text = typed.text;
    text.erase(0, text.find_first_not_of(" \t"));
    const bool says_how = text.starts_with("=") || (text.size() > 1 && text[1] == '=');
    return typed.name + (says_how ? "" : "=") + text;
}

}  // namespace

bool commit_drag(Update& update) {
    EditorState& state = update.state;
    if (!state.rules.dragged) return false;
    const DraggedNumber dragged = *state.rules.dragged;
    state.rules.dragged.reset();
    if (!state.preview || state.preview_label != set_label(dragged.name)) return false;
    const bool recorded = edit_grammar(update, set_label(dragged.name), [&](const Grammar& grammar) {
        return with_number(grammar, dragged.name, dragged.set, {.nearest_ring = true});
    });
    if (!recorded) drop_preview(update);
    return true;
}

void perform_one(Update& update, const SetNumber& action) {
    if (action.preview) return drag(update, action);
    edit_grammar(update, set_label(action.name),
                 [&](const Grammar& grammar) { return with_number(grammar, action.name, action.value); });
}

void perform_one(Update& update, const TypeNumber& action) {
    update.state.rules.typed = {.name = action.name, .text = action.text};
}

void perform_one(Update& update, const EnterTyped&) {
    RulesState& rules = update.state.rules;
    if (!rules.typed) return;
    try {
        const NumberEdit edit = parse_number_edit(edit_text(*rules.typed));
        EditResult result = set_numbers(*update.state.document.grammar, {&edit, 1});
        const std::string label = "set " + rules.typed->name;
        rules.typed.reset();
        if (!result.changes.empty()) edit_grammar(update, label, [&](const Grammar&) { return result; });
    } catch (const InputError& error) {
        rules.typed->mistake = error.what();
        tell(update, MessageKind::mistake, error.what());
    }
}

void perform_one(Update& update, const StopTyping&) { update.state.rules.typed.reset(); }

void perform_one(Update& update, const ResetNumber& action) {
    const GrammarNumber* then = number_named(update.state.rules.origin, action.name);
    if (then == nullptr) {
        tell(update, MessageKind::mistake,
             action.name + " has no value to go back to: the grammar had no such number when it was opened or analysed");
        return;
    }
    const double value = then->value;
    edit_grammar(update, "reset " + action.name,
                 [&](const Grammar& grammar) { return with_number(grammar, action.name, value); });
}

void perform_one(Update& update, const LockNumber& action) {
    Document after = update.state.document;
    const bool known = number_named(update.state.rules.sheet, action.name) != nullptr;
    const bool changes =
        action.locked ? known && after.locked.insert(action.name).second : after.locked.erase(action.name) > 0;
    if (changes) record_edit(update, std::move(after), (action.locked ? "lock " : "unlock ") + action.name);
}

void perform_one(Update& update, const SetDepth& action) {
    EditorState& state = update.state;
    Document after = state.document;
    after.derive.depth = std::max(action.depth, -1);
    if (action.preview) {
        state.preview = std::move(after);
        state.preview_label = "set the depth";
        show_anew(update);
    } else if (after.derive.depth != state.document.derive.depth) {
        record_edit(update, std::move(after), "set the depth");
    }
}

void perform_one(Update& update, const SetSeed& action) {
    const std::string seed = std::to_string(action.seed);
    const auto set_seed = [&](const Grammar& grammar) -> EditResult {
        Grammar seeded = grammar;
        seeded.seed = action.seed;
        return {std::move(seeded), {}};
    };
    edit_document(update,
                  {.label = "set the seed to " + seed, .grammar = set_seed, .locked = {}, .rest = [](Document& after) {
                       after.derive.seed.reset();  // the grammar's own holds
                   }});
}

void perform_one(Update& update, const FilterRules& action) { update.state.rules.filter = action.text; }

void perform_one(Update& update, const ShowRuleDetails& action) { update.state.rules.details = action.shown; }

}  // namespace rinceau
