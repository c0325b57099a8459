#include "editor/model/document.h"

#include <tuple>
#include <utility>

#include "lsystem/grammar_text.h"
#include "lsystem/resolve_uses.h"

namespace rinceau {
namespace {

bool same_derivation(const DeriveOptions& a, const DeriveOptions& b) { return a.depth == b.depth && a.seed == b.seed; }

}  // namespace

Document empty_document() {
    Document document;
    document.grammar = document.resolved = std::make_shared<const Grammar>();
    return document;
}

Document with_grammar(const Document& document, Grammar grammar) {
    Document changed = document;
    changed.grammar = std::make_shared<const Grammar>(std::move(grammar));
    if (changed.grammar->uses.empty()) {
        changed.resolved = changed.grammar;
        return changed;
    }
    const auto load = [&](const std::string& name) {
        if (document.used) {
            const auto file = document.used->find(name);
            if (file != document.used->end()) return file->second;
        }
        throw InputError({name}, "is used by the grammar but was not there when it was opened; save and open it again");
    };
    changed.resolved = std::make_shared<const Grammar>(resolve_uses(*changed.grammar, load));
    return changed;
}

bool rules_were_edited(const Document& document) { return document.origin && document.grammar != document.origin; }

bool same_analysis(const AnalyzeOptions& a, const AnalyzeOptions& b) {
    const auto values = [](const AnalyzeOptions& o) {
        return std::tuple(o.similarity.tolerance, o.similarity.tolerance_of_diagonal, o.similarity.mirrored_copies,
                          o.tolerance, o.weights.count, o.weights.nearness, o.weights.similarity, o.weights.length,
                          o.objective, o.symmetrize, o.stochastic, o.grouping);
    };
    return values(a) == values(b);
}

bool same_version(const Document& a, const Document& b) {
    return a.grammar == b.grammar && a.drawing == b.drawing && a.used == b.used && same_analysis(a.analysis, b.analysis) &&
           same_derivation(a.derive, b.derive) && a.locked == b.locked;
}

bool same_document(const Document& a, const Document& b) {
    const bool same_grammar = a.grammar == b.grammar || to_text(*a.grammar) == to_text(*b.grammar);
    return same_grammar && a.drawing == b.drawing && a.used == b.used && a.report == b.report &&
           same_analysis(a.analysis, b.analysis) && same_derivation(a.derive, b.derive) && a.locked == b.locked &&
           a.origin == b.origin;
}

}  // namespace rinceau
