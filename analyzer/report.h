#pragma once
// What was found, for people and for other programs.

#include "analyzer/analyze.h"
#include "analyzer/to_grammar.h"

namespace rinceau {

/// Fills terminals, productions, axiom and counts.
void fill_report(AnalysisReport& report, const OrderedRules& ordered, const WrittenGrammar& written, const Grammar& grammar,
                 const Instancing& instancing);

}  // namespace rinceau
