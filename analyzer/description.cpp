#include "analyzer/description.h"

#include <algorithm>
#include <cmath>

#include "analyzer/colouring.h"
#include "analyzer/fill_gaps.h"
#include "analyzer/group_residuals.h"
#include "analyzer/inline_groups.h"
#include "analyzer/mirrored_halves.h"
#include "analyzer/order_rules.h"

namespace rinceau {

namespace {

// Shares of the diagonal. A picture 900 pixels wide has a diagonal of some 1100 pixels: the first is a tenth of a pixel.
constexpr double exact_share = 8e-5;     // an element may miss its place by this before it gets an exception
constexpr double digits_share = 1.5e-5;  // one number of the grammar may move what follows it by this

/// How far one number of the grammar may move what follows it, a scene length: neither visible nor more than a part of what an
/// element's place is measured to (grammar_bits).
double digits_slack(const Drawing& drawing) {
    constexpr double share_of_size = 5e-4;
    constexpr double finest_share = 1e-7;
    double log_size = 0, count = 0;
    for (const Instance& instance : drawing.instancing.instances) {
        const double size = scale_of(instance.pose);
        if (!(size > 0)) continue;
        log_size += std::log(size);
        ++count;
    }
    const double size = count > 0 ? std::exp(log_size / count) : drawing.diagonal;
    return std::clamp(share_of_size * size, finest_share * drawing.diagonal, digits_share * drawing.diagonal);
}

/// Bits, and for each production and each kind of thing what it costs a reader to take in one more. (Two rules that fit
/// loosely read better than four that fit to the last bit.)
double reading_cost(const Description& description) {
    constexpr double production_bits = 40;
    constexpr double kind_bits = 20;  // readings differ in how many there are
    return description.bits.grammar + production_bits * static_cast<double>(description.exact.productions.size()) +
           kind_bits * description.reading->kinds;
}

RuleSet no_rules(const Drawing& drawing) {
    RuleSet rules = starting_state(drawing.instancing, {}, drawing.diagonal).rules;
    RuleSet flat;
    for (const Part& part : rules.parts) {
        if (part.look >= 0) flat.parts.push_back(part);
    }
    for (Item& item : rules.items) {
        if (item.element < 0) continue;
        item.alive = true;
        flat.items.push_back(std::move(item));
    }
    return flat;
}

}  // namespace

double exact_tolerance(const Drawing& drawing) { return exact_share * drawing.diagonal; }

DescriptionBits bits_of(const Description& description, const Grammar& grammar) {
    const Drawing& drawing = *description.reading;
    DescriptionBits bits =
        description_bits(description.ordered, description.written, grammar, drawing.instancing,
                         {description.left_over, description.groups}, drawing.diagonal, exact_share * drawing.diagonal);
    bits.drawing = drawing.flat_bits;
    return bits;
}

std::optional<Description> describe(const Drawing& drawing, RuleSet rules, double tolerance) {
    Description description;
    description.reading = &drawing;
    description.tolerance = tolerance;
    description.ordered = ordered_for_painting(with_mirrored_halves(with_inlined_groups(with_filled_gaps(std::move(rules)))),
                                               drawing.overlaps);
    std::optional<WrittenGrammar> written =
        with_colours(to_grammar(description.ordered, drawing.instancing, drawing.scene, digits_slack(drawing)),
                     drawing.instancing);
    if (!written) return std::nullopt;
    description.written = std::move(*written);
    Residuals exact = with_residuals(description.written, drawing.instancing, exact_tolerance(drawing));
    description.exact = std::move(exact.grammar);
    description.deviation = std::move(exact.deviation);
    description.left_over = std::move(exact.left_over);
    description.groups = std::move(exact.groups);
    description.bits = bits_of(description, description.exact);
    description.cost = reading_cost(description);
    return description;
}

Description flat_description(const Drawing& drawing) { return *describe(drawing, no_rules(drawing), 0); }

}  // namespace rinceau
