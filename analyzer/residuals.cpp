#include "analyzer/residuals.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "analyzer/module_writer.h"
#include "lsystem/interpret.h"

namespace rinceau {

namespace {

constexpr double residual_share = 0.3;  // of the tolerance, that a number of an exception may be off by

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

std::vector<LeafResidual> leaf_residuals(const WrittenGrammar& written, const Instancing& instancing) {
    std::vector<Placement> placements = interpret(written.grammar, {.addresses = true, .trails = true});
    std::ranges::sort(placements, {}, &Placement::order);
    std::vector<double> reaches;
    for (const Look& look : instancing.looks) reaches.push_back(look.verbatim.empty() ? outline_reach(look) : 1);
    std::vector<LeafResidual> residuals;
    residuals.reserve(placements.size());
    for (std::size_t leaf = 0; leaf < placements.size() && leaf < written.element_of_leaf.size(); ++leaf) {
        Placement& placement = placements[leaf];
        const Instance& instance = instancing.instances[static_cast<std::size_t>(written.element_of_leaf[leaf])];
        const auto at = static_cast<std::size_t>(instance.look);
        const Nearest nearest =
            nearest_gauge(instancing.looks[at], reaches[at], instance.pose, written.terminal_anchor[at], placement.pose);
        const Similarity move = inverse(placement.pose) * nearest.pose;
        residuals.push_back({std::move(placement), move, nearest.deviation, reaches[at] * scale_of(instance.pose)});
    }
    return residuals;
}

namespace {

/// What moves the turtle to where the drawing has the terminal.
std::vector<ModuleTemplate> move_of(const LeafResidual& residual, double tolerance) {
    std::vector<ModuleTemplate> move;
    const double size = scale_of(residual.placement.pose);
    const double fine = residual_share * tolerance;
    const double turn = fine / std::max(residual.reach, fine);
    append_move(move, residual.move, {fine / size, turn, turn, turn});
    return move;
}

}  // namespace

Residuals with_residuals(const Grammar& grammar, const std::vector<LeafResidual>& residuals, double tolerance,
                         const std::vector<bool>& left) {
    Residuals result;
    result.grammar = grammar;
    bool commented =
        std::ranges::find(grammar.exceptions, residuals_comment, &Exception::comment) != grammar.exceptions.end();
    std::map<std::vector<int>, std::size_t> exception_at;  // of stand-ins and other styles
    for (std::size_t e = 0; e < grammar.exceptions.size(); ++e) {
        if (!grammar.exceptions[e].successor.empty()) exception_at[grammar.exceptions[e].address] = e;
    }
    for (std::size_t leaf = 0; leaf < residuals.size(); ++leaf) {
        const LeafResidual& residual = residuals[leaf];
        const Placement& placement = residual.placement;
        result.deviation.push_back(residual.deviation);
        result.left_over.push_back(residual.deviation);
        if (residual.deviation <= tolerance || (!left.empty() && left[leaf])) continue;
        std::vector<ModuleTemplate> move = move_of(residual, tolerance);
        ++result.exceptions;
        const std::string& symbol = grammar.terminals[static_cast<std::size_t>(placement.terminal)].symbol;
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
