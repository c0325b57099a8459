#include "exports/export_formats.h"

#include <algorithm>
#include <array>

#include "exports/cfdg.h"
#include "exports/cpfg.h"
#include "exports/fractint.h"
#include "exports/houdini.h"
#include "exports/json_grammar.h"
#include "exports/json_placements.h"
#include "exports/lindenmayer.h"
#include "exports/lpy.h"
#include "exports/svg_clones.h"
#include "lsystem/grammar_text.h"

namespace rinceau {

namespace {

/// The grammar's own text: the way back from JSON.
Export to_lsys(const Grammar& grammar, const ExportOptions&) { return {.bytes = to_text(grammar)}; }

constexpr std::array formats{
    ExportFormat{"cfdg", ".cfdg", "Context Free", to_cfdg},
    ExportFormat{"svg", ".svg", "SVG with live clones, for Inkscape", to_svg_clones},
    ExportFormat{"lpy", ".lpy", "L-Py", to_lpy},
    ExportFormat{"cpfg", ".l", "cpfg of the Virtual Laboratory, with .v and .map", to_cpfg},
    ExportFormat{"houdini", ".txt", "premise and rules for Houdini's L-System SOP", to_houdini},
    ExportFormat{"fractint", ".l", "Fractint and Iterated Dynamics, with .map", to_fractint},
    ExportFormat{"lindenmayer", ".mjs", "JavaScript for npm's lindenmayer", to_lindenmayer},
    ExportFormat{"json", ".json", "the whole grammar as JSON, which every command reads, too", to_json, true},
    ExportFormat{"lsys", ".lsys", "the grammar's own text, back from JSON", to_lsys, true},
    ExportFormat{"placements", ".json", "JSON list of what is drawn where, for programs of your own", to_placements},
};

}  // namespace

std::span<const ExportFormat> export_formats() { return formats; }

const ExportFormat* find_export_format(std::string_view name) {
    const auto* found = std::ranges::find(formats, name, &ExportFormat::name);
    return found == formats.end() ? nullptr : found;
}

}  // namespace rinceau
