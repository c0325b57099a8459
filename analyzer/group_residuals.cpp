#include "analyzer/group_residuals.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>

#include "analyzer/derivation_tree.h"
#include "analyzer/group_frame.h"
#include "analyzer/module_writer.h"
#include "lsystem/interpret.h"

namespace rinceau {

namespace {

/// A group that shall be moved.
struct GroupMove {
    int node = 0;     ///< of the derivation tree
    Similarity move;  ///< in the scene
    double deviation = 0;
    double reach = 0;  ///< of the leaves from their middle, scene length
};

class GroupMover {
  public:
    GroupMover(const Grammar& grammar, const std::vector<LeafResidual>& residuals, double tolerance)
        : grammar_(grammar), residuals_(residuals), tolerance_(tolerance) {
        std::vector<Placement> leaves;
        for (const LeafResidual& residual : residuals) {
            leaves.push_back(residual.placement);
            standing_.push_back(residual.placement.pose);
            drawn_.push_back(residual.placement.pose * residual.move);
        }
        tree_ = derivation_tree(grammar, leaves);
        leaves_below_.resize(tree_.nodes.size());
        for (std::size_t leaf = 0; leaf < residuals.size(); ++leaf) {
            for (int node = tree_.node_of_leaf[leaf]; node > 0; node = tree_.nodes[static_cast<std::size_t>(node)].parent)
                leaves_below_[static_cast<std::size_t>(node)].push_back(leaf);
        }
        for (const Exception& exception : grammar.exceptions) taken_.insert(exception.address);
    }

    GroupResiduals run() {
        GroupResiduals result{grammar_, {}};
        std::map<int, std::vector<GroupMove>> by_depth;
        for (std::size_t node = 1; node < tree_.nodes.size(); ++node) {  // parents come first
            const auto move = move_of(static_cast<int>(node));
            if (!move) continue;
            for (const std::size_t leaf : leaves_below_[node]) standing_[leaf] = move->move * standing_[leaf];
            by_depth[tree_.nodes[node].depth].push_back(*move);
        }
        for (auto& [unused, moves] : by_depth) write(moves, result);
        return result;
    }

  private:
    const DerivedModule& node_at(int node) const { return tree_.nodes[static_cast<std::size_t>(node)]; }
    const std::vector<std::size_t>& leaves_of(int node) const { return leaves_below_[static_cast<std::size_t>(node)]; }
    const ModuleTemplate& module_at(int node) const {
        const ModuleSite& site = tree_.sites[static_cast<std::size_t>(node_at(node).site)];
        return string_at(grammar_, site)[static_cast<std::size_t>(site.position)];
    }
    std::vector<int> address_of(int node) const {
        const std::vector<int>& address = residuals_[static_cast<std::size_t>(node_at(node).leaf)].placement.address;
        return {address.begin(), address.begin() + node_at(node).address_length};
    }

    /// In a production's successor, with arguments that mean the same in an exception, and none yet.
    bool may_move(int node) const {
        const ModuleSite& site = tree_.sites[static_cast<std::size_t>(node_at(node).site)];
        if (site.string < 0 || taken_.contains(address_of(node))) return false;
        const std::vector<std::string>& parameters = grammar_.productions[static_cast<std::size_t>(site.string)].parameters;
        for (const Expression& argument : module_at(node).arguments) {
            for (const Expression::Node& part : argument.postfix) {
                const bool own =
                    part.op == Expression::Op::name && std::ranges::find(parameters, part.name) != parameters.end();
                if (own || part.op == Expression::Op::call) return false;
            }
        }
        return true;
    }

    double deviation(std::size_t leaf, const Similarity& move) const {
        const Similarity moved = move * standing_[leaf];
        const Similarity& drawn = drawn_[leaf];
        if (moved.mirrored != drawn.mirrored) return HUGE_VAL;
        return abs(moved.translation - drawn.translation) +
               residuals_[leaf].reach * abs(moved.linear - drawn.linear) / scale_of(drawn);
    }
    std::size_t beyond(int node, const Similarity& move) const {
        const auto far = [&](std::size_t leaf) { return deviation(leaf, move) > tolerance_; };
        return static_cast<std::size_t>(std::ranges::count_if(leaves_of(node), far));
    }

    Similarity common_shift(int node) const {
        Point sum{};
        for (const std::size_t leaf : leaves_of(node)) sum += drawn_[leaf].translation - standing_[leaf].translation;
        return translate(sum / static_cast<double>(leaves_of(node).size()));
    }
    Similarity common_move(int node) const {
        std::vector<Similarity> standing, drawn;
        std::vector<double> radii;
        for (const std::size_t leaf : leaves_of(node)) {
            standing.push_back(standing_[leaf]);
            drawn.push_back(drawn_[leaf]);
            radii.push_back(residuals_[leaf].reach / scale_of(drawn_[leaf]));
        }
        return group_pose(standing, drawn, radii);
    }

    std::optional<GroupMove> move_of(int node) const {
        constexpr std::size_t least_beyond = 2;
        constexpr std::size_t share = 4;  // at most one of so many stays beyond the tolerance
        if (leaves_of(node).size() < least_beyond || !may_move(node)) return std::nullopt;
        const std::size_t before = beyond(node, {});
        if (before < least_beyond) return std::nullopt;
        GroupMove best{node, common_shift(node), 0, 0};
        std::size_t after = beyond(node, best.move);
        const Similarity turned = common_move(node);
        if (const std::size_t left = beyond(node, turned); left < after && !turned.mirrored) {
            best.move = turned;
            after = left;
        }
        if (after * share > before) return std::nullopt;
        Point middle{};
        for (const std::size_t leaf : leaves_of(node))
            middle += standing_[leaf].translation / static_cast<double>(leaves_of(node).size());
        for (const std::size_t leaf : leaves_of(node)) {
            best.deviation =
                std::max(best.deviation, abs(apply(best.move, standing_[leaf].translation) - standing_[leaf].translation));
            best.reach = std::max(best.reach, abs(standing_[leaf].translation - middle) + residuals_[leaf].reach);
        }
        return best;
    }

    /// Exceptions for groups none of which lies in another one.
    void write(const std::vector<GroupMove>& moves, GroupResiduals& result) const {
        const std::vector<Similarity> frames = frames_of(moves, result.grammar);
        if (frames.size() != moves.size()) return;
        constexpr double share = 0.3;  // of the tolerance, that a number may move the group by
        for (std::size_t k = 0; k < moves.size(); ++k) {
            const GroupMove& move = moves[k];
            const Similarity& turtle = frames[k];
            const double fine = share * tolerance_;
            const double far = abs(middle_of(move.node) - turtle.translation) + move.reach;
            Exception exception;
            exception.address = address_of(move.node);
            append_move(exception.successor, inverse(turtle) * move.move * turtle,
                        {fine / scale_of(turtle), fine / far, fine / far, fine / far});
            if (exception.successor.empty()) continue;
            exception.successor.push_back(module_at(move.node));
            result.grammar.exceptions.push_back(std::move(exception));
            const bool shifted = move.move.linear == Complex{1, 0};
            result.groups.push_back({leaves_of(move.node).front(), leaves_of(move.node).size(), move.deviation, !shifted});
        }
    }

    Point middle_of(int node) const {
        Point middle{};
        for (const std::size_t leaf : leaves_of(node))
            middle += residuals_[leaf].placement.pose.translation / static_cast<double>(leaves_of(node).size());
        return middle;
    }

    /// Where the turtle stands at the modules, in order of derivation: each is replaced by a mark.
    std::vector<Similarity> frames_of(const std::vector<GroupMove>& moves, const Grammar& grammar) const {
        Grammar probed = grammar;
        Terminal mark;
        mark.symbol = "Mark";
        const auto is_mark = [&](const auto& named) { return named.symbol == mark.symbol; };
        while (std::ranges::any_of(grammar.terminals, is_mark) || std::ranges::any_of(grammar.productions, is_mark))
            mark.symbol += '_';
        const auto index = static_cast<int>(probed.terminals.size());
        probed.terminals.push_back(mark);
        for (const GroupMove& move : moves)
            probed.exceptions.push_back({address_of(move.node), {command(mark.symbol)}, "", {}});
        std::vector<Similarity> frames;
        visit_placements(probed, {}, [&](const Placement& placement) {
            if (placement.terminal == index) frames.push_back(placement.pose);
        });
        return frames;
    }

    const Grammar& grammar_;
    const std::vector<LeafResidual>& residuals_;
    double tolerance_;
    std::vector<Similarity> standing_;  ///< by leaf: as the rules and the moves so far draw it
    std::vector<Similarity> drawn_;     ///< by leaf: as the drawing has it
    DerivationTree tree_;
    std::vector<std::vector<std::size_t>> leaves_below_;  ///< by node
    std::set<std::vector<int>> taken_;                    ///< addresses of exceptions
};

}  // namespace

GroupResiduals with_moved_groups(const Grammar& grammar, const std::vector<LeafResidual>& residuals, double tolerance) {
    const bool all_right = std::ranges::all_of(residuals, [&](const LeafResidual& r) { return r.deviation <= tolerance; });
    if (all_right) return {grammar, {}};
    return GroupMover(grammar, residuals, tolerance).run();
}

Residuals with_residuals(const WrittenGrammar& written, const Instancing& instancing, double tolerance) {
    const std::vector<LeafResidual> residuals = leaf_residuals(written, instancing);
    GroupResiduals moved = with_moved_groups(written.grammar, residuals, tolerance);
    if (moved.groups.empty()) return with_residuals(written.grammar, residuals, tolerance);
    WrittenGrammar rest = written;
    rest.grammar = std::move(moved.grammar);
    const auto first = rest.grammar.exceptions.begin() + static_cast<std::ptrdiff_t>(written.grammar.exceptions.size());
    first->comment = residuals_comment;
    Residuals result = with_residuals(rest.grammar, leaf_residuals(rest, instancing), tolerance);
    result.exceptions += static_cast<int>(moved.groups.size());
    result.groups = std::move(moved.groups);
    for (std::size_t leaf = 0; leaf < residuals.size(); ++leaf) result.deviation[leaf] = residuals[leaf].deviation;
    return result;
}

}  // namespace rinceau
