#pragma once
// What an analysis found, in a form that tests compare and print.

#include <string>
#include <vector>

#include "analyzer/analyze.h"
#include "closed_loop/listed_scenes.h"
#include "closed_loop/random_grammar.h"
#include "closed_loop/scenes.h"

namespace rinceau::test {

/// "ring of 12; sequence of 3 5": kinds and lengths of all productions, sorted, whatever their names.
std::string rules_in_words(const AnalysisReport& report);
/// The same for what was put in.
std::string rules_in_words(const KnownGrammar& known);

/// Symbols in the axiom that are no turtle commands.
int axiom_symbols(const Grammar& grammar);

/// Are there as few productions, axiom symbols and terminals as a person would write, and exceptions for one element in five
/// at most (in shaken layouts all miss their places), and does the grammar draw the drawing?
bool is_found(const ListedScene& scene, const Analysis& found);

/// known_scenes() without those of these names.
std::vector<KnownScene> scenes_but(const std::vector<std::string>& names);

/// The drawing carried along by the map, in a viewport that holds it.
Scene carried(const Scene& scene, const Similarity& map);

}  // namespace rinceau::test
