#include "exports/svg_clones.h"

#include "lsystem/interpret.h"
#include "lsystem/to_scene.h"

namespace rinceau {

Export to_svg_clones(const Grammar& grammar, const ExportOptions& options) {
    return {.bytes = grammar_svg(grammar, interpret(grammar, {.derive = options.derive}))};
}

}  // namespace rinceau
