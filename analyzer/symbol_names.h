#pragma once
// Names for the symbols of a grammar that a person would give: Window, Row, Ring (docs/analysis.md, 7).

#include <string>
#include <vector>

#include "analyzer/instancing.h"
#include "analyzer/rule_use.h"
#include "scene/element.h"

namespace rinceau {

/// "A" .. "Z", then "A1" .. "Z1", "A2" ..
std::string terminal_letter(int index);

/// By look: what the drawing calls it, if all its elements have ids of one stem that is a word ("window-1", "window-2":
/// Window); a letter otherwise. No two alike, none a command or a word of the language.
std::vector<std::string> look_names(const Instancing& instancing, const Scene& scene);

/// Looks, those twice or more whose elements the drawing calls by as many words: what it calls disc and pearl are two things
/// to whoever drew it, though both be circles.
int named_kinds(const Instancing& instancing, const Scene& scene);

/// By part, "" for parts that are not in use (in_use[part]): looks by their names, rules by rule_name(), numbered where several
/// share a word (Row, Row2), in the order of parts_top_down(). Parts of a rule with different counts share a symbol, except linear ones.
/// No two alike, also with "_count" behind them.
std::vector<std::string> symbol_names(const RuleSet& rules, const std::vector<bool>& in_use,
                                      const std::vector<int>& top_down, const std::vector<RuleUse>& uses,
                                      const std::vector<std::string>& look_names);

}  // namespace rinceau
