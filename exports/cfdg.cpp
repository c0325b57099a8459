#include "exports/cfdg.h"

#include <algorithm>

#include "exports/cfdg_parts.h"
#include "exports/cfdg_rules.h"
#include "lsystem/flat_grammar.h"
#include "lsystem/plain_rules.h"
#include "lsystem/unfolded_exceptions.h"

namespace rinceau {

namespace {

std::string parts_text(const Grammar& grammar, const DeriveOptions& options, NoteList& notes) {
    if (const auto graph = derivation_graph(grammar, options)) return cfdg_parts(grammar, *graph, notes);
    const Grammar flat = flat_grammar(grammar, options);
    return cfdg_parts(flat, *derivation_graph(flat), notes);
}

std::optional<std::string> rules_text(const Grammar& grammar, const DeriveOptions& options, bool live, NoteList& notes) {
    if (is_context_sensitive(grammar)) return std::nullopt;
    return cfdg_rules(plain_rules(unfolded_exceptions(grammar, options)), options, live, notes);
}

}  // namespace

Export to_cfdg(const Grammar& grammar, const ExportOptions& options) {
    const bool chance = is_stochastic(grammar);
    NoteList notes;
    std::optional<std::string> text;
    if (!chance || options.live_random) {
        NoteList of_rules;
        text = rules_text(grammar, options.derive, chance, of_rules);
        if (text) notes = of_rules;
    }
    if (!text) {
        text = parts_text(grammar, options.derive, notes);
        notes.add(chance ? "what is drawn by chance is frozen as the seed has it"
                         : "Context Free cannot say these rules by shapes with parameters: they are written as what they "
                           "become, with numbers");
    } else if (chance) {
        notes.add(
            "draws by chance are Context Free's own: every variation is another picture, and what overlaps may lie in "
            "another order");
    }
    return {.bytes = *text, .notes = notes.notes()};
}

}  // namespace rinceau
