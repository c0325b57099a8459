#include "lsystem/choose_production.h"

#include <cmath>

#include "lsystem/number_text.h"

namespace rinceau {

void ProductionChoice::throw_bad_weight(int production, double weight) const {
    const Production& source = source_of(production);
    throw InputError(source.place, "expected a weight of " + source.symbol + " that is finite and not below 0, found " +
                                       (std::isfinite(weight) ? number_text(weight) : "0/0 or an overflow"));
}

void ProductionChoice::throw_no_weight(int production) const {
    const Production& source = source_of(production);
    throw InputError(source.place, "expected a weight above 0 among the productions of " + source.symbol +
                                       " that apply, found only weights of 0");
}

void ProductionChoice::throw_undefined(int production) const {
    const Production& source = source_of(production);
    throw InputError(source.place, "expected a condition of " + source.symbol + " with a value, found 0/0 or the like");
}

}  // namespace rinceau
