#pragma once
// A grammar as the panel of rules shows it: statements as text, and the numbers that belong to each.

#include <memory>
#include <string>
#include <vector>

#include "lsystem/numbers.h"

namespace rinceau {

/// A statement with the numbers that stand in it.
struct RuleCard {
    enum class Kind : unsigned char { axiom, production, exception, style };
    Kind kind = Kind::axiom;
    int index = 0;             ///< of the production, exception or style
    std::string title;         ///< "axiom", "Row", "Row.case2", "except.1.3", "style4": as names of its numbers begin
    std::string comment;       ///< in one line each
    std::string text;          ///< the statement
    std::vector<int> numbers;  ///< indices into RuleSheet::numbers, in the order of the text
};

struct RuleSheet {
    std::shared_ptr<const Grammar> grammar;  ///< of which all this is said; null = of none yet
    std::vector<GrammarNumber> numbers;      ///< all of them
    std::vector<int> counts;                 ///< indices: how often rules repeat themselves
    std::vector<int> constants;
    std::vector<RuleCard> rules;  ///< the axiom, then the productions
    std::vector<RuleCard> exceptions;
    std::vector<RuleCard> styles;
    std::vector<int> picture;  ///< indices: canvas and seed
    bool random = false;       ///< what it draws may depend on the seed
};

RuleSheet rule_sheet(std::shared_ptr<const Grammar> grammar);

/// The index of the number of that name; -1 = there is none.
int find_number(const RuleSheet& sheet, const std::string& name);

/// Belongs to what is listed at first: neither a detail nor another way to say what others say.
bool is_listed(const GrammarNumber& number);

/// The name without what the card's title says.
std::string name_on_card(const RuleCard& card, const std::string& name);

}  // namespace rinceau
