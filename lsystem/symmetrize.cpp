#include "lsystem/symmetrize.h"

#include "lsystem/randomize.h"
#include "lsystem/regular_exceptions.h"
#include "lsystem/regular_steps.h"

namespace rinceau {

EditResult symmetrize(const Grammar& grammar, const SymmetrizeOptions& options) {
    if (!(options.tolerance >= 0)) throw InputError({}, "expected a tolerance from 0 up");
    EditResult result = randomize(grammar, {.angle = 0, .distance = 0, .scale = 0});
    const auto go_on = [&](EditResult next) {
        result.grammar = std::move(next.grammar);
        result.changes.insert(result.changes.end(), next.changes.begin(), next.changes.end());
    };
    go_on(with_regular_exceptions(result.grammar, options.all_exceptions));
    go_on(with_regular_steps(result.grammar, options.tolerance));
    return result;
}

}  // namespace rinceau
