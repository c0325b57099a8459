#include "analyzer/residuals.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "analyzer/module_writer.h"
#include "lsystem/interpret.h"

namespace rinceau {

namespace {

constexpr double residual_share = 0.3;  // of the tolerance, that a number of an exception may be off by
constexpr const char* residuals_comment =
    "from here on: where elements stand in the drawing; without these lines they stand regularly";

/// Distance of the farthest outline point from the origin, unit frame.
double outline_reach(const Look& look) {
    const Box box = bounds(look.paths);
    if (is_empty(box)) return 1;
    return std::max(
        {1.0, abs(box.low), abs(box.high), abs(Point{box.low.x, box.high.y}), abs(Point{box.high.x, box.low.y})});
}

struct Nearest {
    Similarity pose;  ///< of the terminal, in the gauge that is nearest to the derived pose
    double deviation = 0;
};

/// The drawn pose, in the gauge nearest to `derived`.
Nearest nearest_gauge(const Look& look, double reach, const Similarity& drawn, const Similarity& anchor,
                      const Similarity& derived) {
    Nearest best;
    best.deviation = HUGE_VAL;
    const Similarity derived_unit = derived * inverse(anchor);
    const double shift = abs(drawn.translation - derived_unit.translation);
    if (look.symmetry.continuous) {
        const double scale = scale_of(drawn);
        Similarity turned = derived_unit;
        turned.linear = turned.linear * (scale / scale_of(turned));
        turned.translation = drawn.translation;
        return {turned * anchor, shift + reach * std::abs(scale - scale_of(derived_unit))};
    }
    for (const Similarity& gauge : look.symmetry.elements) {
        const Similarity unit = drawn * gauge;
        if (unit.mirrored != derived_unit.mirrored) continue;
        const double deviation = shift + reach * abs(unit.linear - derived_unit.linear);
        if (deviation < best.deviation) best = {unit * anchor, deviation};
    }
    if (best.deviation == HUGE_VAL) best = {drawn * anchor, shift + 2 * reach * scale_of(drawn)};
    return best;
}

}  // namespace

Residuals with_residuals(const WrittenGrammar& written, const Instancing& instancing, double tolerance) {
    Residuals result;
    result.grammar = written.grammar;
    bool commented = false;
    InterpretOptions options;
    options.addresses = true;
    const std::vector<Placement> placements = interpret(written.grammar, options);
    std::map<std::vector<int>, std::size_t> exception_at;  // of stand-ins and other styles
    for (std::size_t e = 0; e < written.grammar.exceptions.size(); ++e) {
        if (!written.grammar.exceptions[e].successor.empty()) exception_at[written.grammar.exceptions[e].address] = e;
    }
    std::vector<double> reaches;
    for (const Look& look : instancing.looks) reaches.push_back(look.verbatim.empty() ? outline_reach(look) : 1);
    result.deviation.resize(placements.size());
    std::vector<const Placement*> by_order(placements.size());
    for (const Placement& placement : placements) by_order[static_cast<std::size_t>(placement.order)] = &placement;
    for (std::size_t leaf = 0; leaf < by_order.size() && leaf < written.element_of_leaf.size(); ++leaf) {
        const Placement& placement = *by_order[leaf];
        const Instance& instance = instancing.instances[static_cast<std::size_t>(written.element_of_leaf[leaf])];
        const auto at = static_cast<std::size_t>(instance.look);
        const Similarity& anchor = written.terminal_anchor[at];
        const Nearest nearest = nearest_gauge(instancing.looks[at], reaches[at], instance.pose, anchor, placement.pose);
        result.deviation[leaf] = nearest.deviation;
        if (nearest.deviation <= tolerance) continue;
        std::vector<ModuleTemplate> move;
        const double size = scale_of(placement.pose);
        const double reach = reaches[at] * scale_of(instance.pose);
        const double fine = residual_share * tolerance;
        append_move(move, inverse(placement.pose) * nearest.pose,
                    {fine / size, fine / std::max(reach, fine), fine / std::max(reach, fine), fine / std::max(reach, fine)});
        ++result.exceptions;
        const std::string& symbol = written.grammar.terminals[static_cast<std::size_t>(placement.terminal)].symbol;
        const auto known = exception_at.find(placement.address);
        if (known != exception_at.end()) {  // a stand-in, or one of another style: its only symbol is moved
            std::vector<ModuleTemplate>& successor = result.grammar.exceptions[known->second].successor;
            successor.insert(std::ranges::find(successor, symbol, &ModuleTemplate::symbol), move.begin(), move.end());
            continue;
        }
        Exception exception;
        if (!commented) exception.comment = residuals_comment;
        commented = true;
        exception.address = placement.address;
        exception.successor = std::move(move);
        exception.successor.push_back(command(symbol));
        result.grammar.exceptions.push_back(std::move(exception));
    }
    return result;
}

}  // namespace rinceau
