// Commands of the menu Edit: undo, numbers, rules, text.

#include <utility>

#include "editor/model/command.h"

namespace rinceau {
namespace {

constexpr const char* menu_edit = "Edit";
constexpr const char* menu_add = "Edit/Add a Rule";
constexpr const char* menu_rule = "Edit/Selected Rule";

bool has_past(const EditorState& state) { return !state.history.past.empty(); }
bool has_future(const EditorState& state) { return !state.history.future.empty(); }

std::vector<Command> history_commands() {
    return {
        {.name = "edit.undo",
         .menu = menu_edit,
         .label = "Undo",
         .shortcut = "Ctrl+Z",
         .help = "Takes the last edit back.",
         .enabled = has_past,
         .action = [](const EditorState&) -> Action { return RulesAction{UndoEdit{}}; },
         .detail =
             [](const EditorState& state) { return has_past(state) ? "Undo " + state.history.past.back().label : ""; }},
        {.name = "edit.redo",
         .menu = menu_edit,
         .label = "Redo",
         .shortcut = "Ctrl+Y Ctrl+Shift+Z",
         .help = "Does again what was undone.",
         .enabled = has_future,
         .action = [](const EditorState&) -> Action { return RulesAction{RedoEdit{}}; },
         .detail =
             [](const EditorState& state) { return has_future(state) ? "Redo " + state.history.future.back().label : ""; }},
        {.name = "edit.undo_all",
         .menu = menu_edit,
         .label = "Undo All",
         .help = "Goes back to the document as it was opened. Redo brings everything again, step by step.",
         .enabled = has_past,
         .action = [](const EditorState& state) -> Action {
             return RulesAction{GoInHistory{-static_cast<int>(state.history.past.size())}};
         }},
    };
}

/// The number that is listed first; null if none is.
const GrammarNumber* first_number(const EditorState& state) {
    const auto& sheet = state.rules.sheet;
    if (!sheet) return nullptr;
    const auto number = [&](int index) { return &sheet->numbers[static_cast<std::size_t>(index)]; };
    for (const auto* list : {&sheet->counts, &sheet->constants})
        if (!list->empty()) return number(list->front());
    for (const RuleCard& card : sheet->rules)
        for (const int index : card.numbers)
            if (is_listed(*number(index))) return number(index);
    return nullptr;
}

std::uint64_t next_seed(const Document& document) {
    return document.derive.seed.value_or(document.grammar->seed.value_or(1)) + 1;
}

std::vector<Command> number_commands() {
    return {
        {.name = "rules.type",
         .menu = menu_edit,
         .label = "Type Numbers",
         .shortcut = "F2",
         .help = "Begins to type the first number of the rules; Tab goes on to the next.",
         .enabled = [](const EditorState& state) { return first_number(state) != nullptr; },
         .action = [](const EditorState& state) -> Action {
             const GrammarNumber* number = first_number(state);
             if (number == nullptr) return RulesAction{StopTyping{}};
             return RulesAction{TypeNumber{number->name, to_text(number_expression(number->value))}};
         }},
        {.name = "rules.new_seed",
         .menu = menu_edit,
         .label = "New Seed",
         .help = "Draws another relative, where the rules have random numbers.",
         .enabled = [](const EditorState& state) { return state.rules.sheet && state.rules.sheet->random; },
         .action = [](const EditorState& state) -> Action { return RulesAction{SetSeed{next_seed(state.document)}}; }},
        {.name = "rules.details",
         .menu = menu_edit,
         .label = "All Numbers",
         .help = "Lists details, too: conditions, opacities, the canvas.",
         .action = [](const EditorState& state) -> Action { return RulesAction{ShowRuleDetails{!state.rules.details}}; },
         .checked = [](const EditorState& state) { return state.rules.details; }},
    };
}

std::vector<Command> text_commands() {
    return {
        {.name = "rules.text",
         .menu = menu_edit,
         .label = "Rules as Text",
         .shortcut = "Ctrl+T",
         .help = "Shows the rules as text to be written in, or as numbers again.",
         .action = [](const EditorState& state) -> Action {
             return RulesAction{ShowRules{state.rules.view == RulesView::text ? RulesView::rules : RulesView::text}};
         },
         .checked = [](const EditorState& state) { return state.rules.view == RulesView::text; }},
        {.name = "rules.apply_text",
         .menu = menu_edit,
         .label = "Apply Text",
         .help = "The text becomes the rules (Ctrl+Enter in the text).",
         .enabled = [](const EditorState& state) { return state.rules.text.changed; },
         .action = [](const EditorState&) -> Action { return RulesAction{ApplyText{}}; }},
        {.name = "rules.revert_text",
         .menu = menu_edit,
         .label = "Revert Text",
         .help = "The text becomes that of the rules again.",
         .enabled = [](const EditorState& state) { return state.rules.text.changed; },
         .action = [](const EditorState&) -> Action { return RulesAction{RevertText{}}; }},
    };
}

template <ProductionShape shape>
Action add_rule(const EditorState& state) {
    AddProductionOptions options{.shape = shape};
    const std::string symbol = selected_symbol(state);
    if (!symbol.empty()) options.elements = {symbol};
    return RulesAction{AddProduction{options}};
}

template <ProductionShape shape>  // the names are moved, which clang-tidy does not see in a template
// NOLINTNEXTLINE(performance-unnecessary-value-param)
Command add_command(std::string name, std::string label, std::string help) {
    return {.name = "rules.add_" + std::move(name),
            .menu = menu_add,
            .label = std::move(label),
            .help = std::move(help),
            .action = add_rule<shape>};
}

std::vector<Command> add_commands() {
    using enum ProductionShape;
    return {add_command<sequence>("row", "Row", "A rule that sets what is selected side by side."),
            add_command<ring>("ring", "Ring", "A rule that sets what is selected around a point."),
            add_command<branching>("tree", "Tree", "A rule that branches, with what is selected as its limbs."),
            add_command<group>("group", "Group", "A rule that holds what is selected."),
            add_command<empty>("empty", "Empty Rule", "A rule that holds nothing yet.")};
}

bool has_rule(const EditorState& state) { return selected_rule(state) >= 0; }
const Production& rule_of(const EditorState& state) {
    return state.document.grammar->productions[static_cast<std::size_t>(selected_rule(state))];
}
bool is_last_rule(const EditorState& state) {
    return static_cast<std::size_t>(selected_rule(state)) + 1 == state.document.grammar->productions.size();
}

std::vector<Command> rule_commands() {
    return {
        {.name = "rules.rename",
         .menu = menu_rule,
         .label = "Rename",
         .help = "Writes another name of the rule's symbol, which gets it everywhere.",
         .enabled = has_rule,
         .action = [](const EditorState& state) -> Action {
             return RulesAction{WriteCard{CardField::name, selected_rule(state), rule_of(state).symbol}};
         }},
        {.name = "rules.comment",
         .menu = menu_rule,
         .label = "Comment",
         .help = "Writes the comment before the rule.",
         .enabled = has_rule,
         .action = [](const EditorState& state) -> Action {
             return RulesAction{WriteCard{CardField::comment, selected_rule(state), rule_of(state).comment}};
         }},
        {.name = "rules.move_up",
         .menu = menu_rule,
         .label = "Move Up",
         .help = "Writes the rule before the one above it: of several rules of a symbol the first that fits is applied.",
         .enabled = [](const EditorState& state) { return selected_rule(state) > 0; },
         .action = [](const EditorState& state) -> Action {
             return RulesAction{MoveProduction{selected_rule(state), selected_rule(state) - 1}};
         }},
        {.name = "rules.move_down",
         .menu = menu_rule,
         .label = "Move Down",
         .help = "Writes the rule behind the one below it.",
         .enabled = [](const EditorState& state) { return has_rule(state) && !is_last_rule(state); },
         .action = [](const EditorState& state) -> Action {
             return RulesAction{MoveProduction{selected_rule(state), selected_rule(state) + 1}};
         }},
        {.name = "rules.remove",
         .menu = menu_rule,
         .label = "Remove",
         .help = "Removes the rule that the selected element stands in; asks if it is used.",
         .enabled = has_rule,
         .action = [](const EditorState& state) -> Action { return RulesAction{RemoveProduction{selected_rule(state)}}; }},
    };
}

}  // namespace

std::vector<Command> rules_commands() {
    std::vector<Command> all;
    for (const auto part : {history_commands, number_commands, text_commands, add_commands, rule_commands})
        for (Command& command : part()) all.push_back(std::move(command));
    return all;
}

}  // namespace rinceau
