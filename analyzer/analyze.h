#pragma once
// The whole journey: drawing -> grammar, with its own proof (Stava et al. 2010; docs/analysis.md names every deviation).

#include <string>
#include <vector>

#include "analyzer/prepare_drawing.h"
#include "analyzer/verify.h"
#include "geometry/progress.h"
#include "lsystem/grammar.h"
#include "scene/element.h"

namespace rinceau {

struct ProductionReport {
    std::string symbol;
    std::string kind;          ///< "sequence", "ring", "linear", "group"
    std::vector<int> lengths;  ///< numbers of repetitions in use, as a person counts them; {n} for a group of n members
    int instances = 0;         ///< times the symbol is expanded from outside
    std::string body;          ///< the production as printed
};

struct TerminalReport {
    std::string symbol;
    int instances = 0;
    int symmetry = 1;  ///< order of the rotation group of its outline; 0 = continuous
    int mirrored = 0;  ///< instances that are mirror images
};

struct AnalysisSeconds {
    double similarity = 0, clusters = 0, rules = 0, verify = 0;
};

struct AnalysisReport {
    int elements = 0;
    int verbatim = 0;  ///< of the elements, how many are kept verbatim
    std::vector<TerminalReport> terminals;
    std::vector<ProductionReport> productions;
    std::string axiom;
    Verification check;
    double drawing_bits = 0;  ///< docs/analysis.md, "How a drawing and a grammar are measured"
    double grammar_bits = 0;
    double tolerance = 0;  ///< the one that was kept
    Objective objective = Objective::bits;
    bool symmetrized = false;  ///< `check` is verify_layout's
    bool stochastic = false;   ///< so it is here
    std::vector<std::string> warnings;
    AnalysisSeconds seconds;
};

struct Analysis {
    Grammar grammar;  ///< report.check says whether it has passed: if no rules did, this is the list of all elements
    AnalysisReport report;
};

/// Throws LimitError for drawings over 5,000,000 elements. Elements that no list of copies would redraw closely enough are
/// nobody's copies; report.check says whether the grammar has passed.
Analysis analyze(const Scene& scene, const AnalyzeOptions& options = {}, const Progress& progress = {});

/// The same for a drawing that was prepared: with other weights or another objective in much less time. The rest of the
/// options must be what it was prepared with.
Analysis analyze(const PreparedDrawing& prepared, const AnalyzeOptions& options = {}, const Progress& progress = {});

/// The grammar that lists every element in the axiom: no rules, always exact.
Grammar flat_grammar(const Scene& scene, const Instancing& instancing);

}  // namespace rinceau
