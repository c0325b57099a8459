#include "editor/model/rule_sheet.h"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/index.h"
#include "lsystem/grammar_names.h"
#include "lsystem/grammar_text.h"

namespace rinceau {

namespace {

/// Titles as string_name of the numbers: "Row", "Row.case2".
std::vector<std::string> production_titles(const Grammar& grammar) {
    std::map<std::string, int> seen;
    std::vector<std::string> titles;
    for (const Production& production : grammar.productions) {
        const int which = ++seen[production.symbol];
        titles.push_back(which == 1 ? production.symbol : production.symbol + ".case" + std::to_string(which));
    }
    return titles;
}

std::string exception_title(const Exception& exception) {
    std::string title = "except";
    for (const int number : exception.address) title += '.' + std::to_string(number);
    return title;
}

void add_cards(const Grammar& grammar, RuleSheet& sheet) {
    sheet.rules.push_back({RuleCard::Kind::axiom, 0, "axiom", {}, axiom_text(grammar), {}});
    const auto titles = production_titles(grammar);
    for (std::size_t i = 0; i < grammar.productions.size(); ++i) {
        const Production& production = grammar.productions[i];
        sheet.rules.push_back({RuleCard::Kind::production,
                               static_cast<int>(i),
                               titles[i],
                               production.comment,
                               statement_text(production),
                               {}});
    }
    for (std::size_t i = 0; i < grammar.exceptions.size(); ++i) {
        const Exception& exception = grammar.exceptions[i];
        sheet.exceptions.push_back({RuleCard::Kind::exception,
                                    static_cast<int>(i),
                                    exception_title(exception),
                                    exception.comment,
                                    statement_text(exception),
                                    {}});
    }
    for (std::size_t i = 0; i < grammar.styles.size(); ++i) {
        const NumberedStyle& style = grammar.styles[i];
        sheet.styles.push_back(
            {RuleCard::Kind::style, static_cast<int>(i), "style" + std::to_string(style.number), style.comment, {}, {}});
    }
}

void add_to_card(RuleSheet& sheet, const ExpressionPlace& place, int number) {
    if (place.in != ExpressionPlace::In::module) {
        sheet.rules[at(place.index) + 1].numbers.push_back(number);
    } else if (place.string.in == StringPlace::In::exception) {
        sheet.exceptions[at(place.string.index)].numbers.push_back(number);
    } else {
        const std::size_t card = place.string.in == StringPlace::In::axiom ? 0 : at(place.string.index) + 1;
        sheet.rules[card].numbers.push_back(number);
    }
}

/// Where a person looks for the number.
void place_number(RuleSheet& sheet, int index) {
    const GrammarNumber& number = sheet.numbers[at(index)];
    if (number.rank == NumberRank::hidden && number.constant < 0) return;
    if (!number.parts.empty() || number.slots.empty()) return;
    const NumberSlot& slot = number.slots.front();
    if (slot.in == NumberSlot::In::canvas || slot.in == NumberSlot::In::seed) {
        sheet.picture.push_back(index);
    } else if (slot.in != NumberSlot::In::expression) {
        sheet.styles[at(slot.index)].numbers.push_back(index);
    } else if (number.kind == NumberKind::count) {
        if (number.rank != NumberRank::hidden) sheet.counts.push_back(index);
    } else if (number.alias) {
        add_to_card(sheet, *number.alias, index);
    } else if (slot.place.in == ExpressionPlace::In::constant) {
        sheet.constants.push_back(index);
    } else {
        add_to_card(sheet, slot.place, index);
    }
}

}  // namespace

RuleSheet rule_sheet(std::shared_ptr<const Grammar> grammar) {
    RuleSheet sheet;
    sheet.numbers = grammar_numbers(*grammar);
    sheet.random = draws_random_numbers(*grammar);
    add_cards(*grammar, sheet);
    for (std::size_t i = 0; i < sheet.numbers.size(); ++i) place_number(sheet, static_cast<int>(i));
    sheet.grammar = std::move(grammar);
    return sheet;
}

int find_number(const RuleSheet& sheet, const std::string& name) {
    const auto found = std::ranges::find(sheet.numbers, name, &GrammarNumber::name);
    return found == sheet.numbers.end() ? -1 : static_cast<int>(found - sheet.numbers.begin());
}

bool is_listed(const GrammarNumber& number) {
    return number.rank != NumberRank::detail && (number.rank != NumberRank::hidden || number.constant >= 0);
}

std::string name_on_card(const RuleCard& card, const std::string& name) {
    return name.starts_with(card.title + '.') ? name.substr(card.title.size() + 1) : name;
}

}  // namespace rinceau
