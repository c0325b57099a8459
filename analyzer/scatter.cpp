#include "analyzer/scatter.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "analyzer/derivation_tree.h"
#include "analyzer/module_writer.h"
#include "lsystem/number_text.h"

namespace rinceau {

namespace {

constexpr std::size_t least_copies = 4;  // fewer say nothing about a distribution

/// Mean and standard deviation of a number over the copies.
struct Spread {
    double mean = 0;
    double deviation = 0;
};

Spread spread_of(const std::vector<double>& values) {
    const auto count = static_cast<double>(values.size());
    Spread spread;
    for (const double value : values) spread.mean += value / count;
    double squares = 0;
    for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
    spread.deviation = std::sqrt(squares / (count - 1));
    // A mean within three of its own errors is none: the rules are fitted to the copies.
    if (std::abs(spread.mean) < 3 * spread.deviation / std::sqrt(count)) spread.mean = 0;
    return spread;
}

double median_of(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// One number of all copies, as the grammar says it and as a length in the drawing.
struct Column {
    std::vector<double> values;
    double squares = 0;  ///< of the lengths

    void add(double value, double per_unit) {
        values.push_back(value);
        squares += value * per_unit * value * per_unit;
    }
    /// None if the lengths are within the tolerance.
    Spread spread(double tolerance) const {
        if (squares <= tolerance * tolerance * static_cast<double>(values.size())) return {};
        return spread_of(values);
    }
};

/// "normal(0, 1.5)" with two digits, which is more than some copies tell.
std::string normal_text(double mean, double deviation) {
    constexpr double share = 0.05;
    return "normal(" + number_text(tidy(mean, share * deviation)) + ", " + number_text(tidy(deviation, share * deviation)) +
           ")";
}

/// To the place, at right angles and along the heading; a turn; a size. What is 0 is left out.
struct Noise {
    Spread ahead, right;  ///< in the turtle's units
    Spread turn;          ///< radians
    Spread log_scale;
};

std::vector<ModuleTemplate> modules_of(const Noise& noise) {
    std::vector<ModuleTemplate> modules;
    if (noise.ahead.deviation > 0) modules.push_back(command("f", normal_text(noise.ahead.mean, noise.ahead.deviation)));
    double back = 0;
    if (noise.right.deviation > 0) {
        constexpr double quarter = 90;
        modules.push_back(command("-", quarter));
        modules.push_back(command("f", normal_text(noise.right.mean, noise.right.deviation)));
        back = quarter;
    }
    if (noise.turn.deviation > 0) {
        modules.push_back(command("+", normal_text(back + degrees(noise.turn.mean), degrees(noise.turn.deviation))));
    } else if (back > 0) {
        modules.push_back(command("+", back));
    }
    if (noise.log_scale.deviation > 0) {
        modules.push_back(command("*", "exp(" + normal_text(noise.log_scale.mean, noise.log_scale.deviation) + ")"));
    }
    return modules;
}

class ScatterWriter {
  public:
    ScatterWriter(const Grammar& grammar, std::vector<LeafResidual> residuals, double tolerance)
        : grammar_(grammar), residuals_(std::move(residuals)), tolerance_(tolerance), left_(residuals_.size()) {
        std::vector<Placement> leaves;
        for (const LeafResidual& residual : residuals_) {
            leaves.push_back(residual.placement);
            const Similarity& pose = residual.placement.pose;
            missed_.push_back((pose * residual.move).translation - pose.translation);
        }
        tree_ = derivation_tree(grammar, leaves);
        find_members();
    }

    Residuals write() {
        for (const int site : sites_from_above()) {
            if (is_group(site)) scatter_group(site);
        }
        for (std::size_t site = 0; site < tree_.sites.size(); ++site) scatter_leaves(static_cast<int>(site));
        Residuals result = with_residuals(grammar_, residuals_, tolerance_, left_);
        insert_noise(result.grammar);
        return result;
    }

  private:
    const Grammar& grammar_;
    std::vector<LeafResidual> residuals_;
    double tolerance_;
    std::vector<bool> left_;     ///< by leaf: noise stands for what it misses its place by
    std::vector<Point> missed_;  ///< by leaf: what it misses its place by beside the groups around it, scene
    DerivationTree tree_;
    std::vector<std::vector<std::size_t>> leaves_below_;  ///< by node
    std::vector<std::vector<int>> nodes_at_;              ///< by site
    std::vector<std::vector<std::size_t>> leaves_at_;     ///< by site: its copies that are terminals, or stand for one
    std::map<std::pair<int, int>, std::vector<ModuleTemplate>> noise_;  ///< by production and position

    bool is_in_production(int site) const { return tree_.sites[static_cast<std::size_t>(site)].string >= 0; }

    void find_members() {
        leaves_below_.resize(tree_.nodes.size());
        nodes_at_.resize(tree_.sites.size());
        leaves_at_.resize(tree_.sites.size());
        for (std::size_t node = 1; node < tree_.nodes.size(); ++node) {
            nodes_at_[static_cast<std::size_t>(tree_.nodes[node].site)].push_back(static_cast<int>(node));
        }
        for (std::size_t leaf = 0; leaf < residuals_.size(); ++leaf) {
            int slot = tree_.node_of_leaf[leaf];
            for (int node = slot; node > 0; node = tree_.nodes[static_cast<std::size_t>(node)].parent) {
                leaves_below_[static_cast<std::size_t>(node)].push_back(leaf);
            }
            const auto site_of = [&](int node) { return tree_.nodes[static_cast<std::size_t>(node)].site; };
            while (slot > 0 && tree_.sites[static_cast<std::size_t>(site_of(slot))].string <= exception_string) {
                slot = tree_.nodes[static_cast<std::size_t>(slot)].parent;
            }
            if (slot > 0) leaves_at_[static_cast<std::size_t>(site_of(slot))].push_back(leaf);
        }
    }

    std::vector<int> sites_from_above() const {
        std::vector<int> depth(tree_.sites.size()), order;
        for (std::size_t site = 0; site < tree_.sites.size(); ++site) {
            order.push_back(static_cast<int>(site));
            for (const int node : nodes_at_[site]) {
                depth[site] = std::max(depth[site], tree_.nodes[static_cast<std::size_t>(node)].depth);
            }
        }
        std::ranges::stable_sort(order, {}, [&](int site) { return depth[static_cast<std::size_t>(site)]; });
        return order;
    }

    bool is_group(int site) const {
        const std::vector<int>& nodes = nodes_at_[static_cast<std::size_t>(site)];
        return is_in_production(site) && nodes.size() >= least_copies && leaves_at_[static_cast<std::size_t>(site)].empty();
    }

    /// What a group's members miss their places by together.
    Point common_miss(int node) const {
        const std::vector<std::size_t>& leaves = leaves_below_[static_cast<std::size_t>(node)];
        Point sum{};
        for (const std::size_t leaf : leaves) sum += missed_[leaf];
        return sum / static_cast<double>(leaves.size());
    }

    /// Do the groups move as one: by more than the mean of members that move on their own would, in both directions
    /// together?
    bool moves_as_one(const std::vector<int>& nodes) const {
        constexpr double clearly = 4;  // F of as many groups as have to be there: by chance in less than 1 of 100 cases
        double between = 0, within = 0, expected = 0, freedom = 0;
        std::vector<double> distances;
        for (const int node : nodes) {
            const std::vector<std::size_t>& leaves = leaves_below_[static_cast<std::size_t>(node)];
            const Point common = common_miss(node);
            distances.push_back(abs(common));
            between += norm(common);
            for (const std::size_t leaf : leaves) within += norm(missed_[leaf] - common);
            expected += 1 / static_cast<double>(leaves.size());
            freedom += static_cast<double>(leaves.size()) - 1;
        }
        if (freedom < 1 || median_of(distances) <= tolerance_) return false;
        return between > clearly * within / freedom * expected;
    }

    void scatter_group(int site) {
        const std::vector<int>& nodes = nodes_at_[static_cast<std::size_t>(site)];
        if (!moves_as_one(nodes)) return;
        const std::vector<Similarity> frames = frames_of(site);
        if (frames.size() != nodes.size()) return;
        Column ahead, right;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const Point common = common_miss(nodes[i]);
            const Point local = local_miss(frames[i], common);
            ahead.add(local.y, scale_of(frames[i]));
            right.add(local.x, scale_of(frames[i]));
            for (const std::size_t leaf : leaves_below_[static_cast<std::size_t>(nodes[i])]) {
                missed_[leaf] = missed_[leaf] - common;
                left_[leaf] = true;
            }
        }
        add_noise(site, {.ahead = ahead.spread(tolerance_), .right = right.spread(tolerance_)});
    }

    /// Where the turtle stands at the modules of a site, in order of derivation: it is given something to draw there. Other
    /// ones than in the drawing where exceptions erase or replace some.
    std::vector<Similarity> frames_of(int site) const {
        const ModuleSite& place = tree_.sites[static_cast<std::size_t>(site)];
        Grammar probed = grammar_;
        Terminal mark;
        mark.symbol = "Mark";
        const auto taken = [&](const Terminal& terminal) { return terminal.symbol == mark.symbol; };
        while (std::ranges::any_of(grammar_.terminals, taken) ||
               std::ranges::any_of(grammar_.productions, [&](const Production& p) { return p.symbol == mark.symbol; })) {
            mark.symbol += '_';
        }
        const auto index = static_cast<int>(probed.terminals.size());
        probed.terminals.push_back(mark);
        probed.exceptions.clear();  // their addresses would have to count the marks
        std::vector<ModuleTemplate>& successor = probed.productions[static_cast<std::size_t>(place.string)].successor;
        successor.insert(successor.begin() + place.position, command(mark.symbol));
        std::vector<Similarity> frames;
        visit_placements(probed, {}, [&](const Placement& placement) {
            if (placement.terminal == index) frames.push_back(placement.pose);
        });
        return frames;
    }

    static Point local_miss(const Similarity& frame, Point missed) {
        return apply(inverse(Similarity{frame.linear, {}, frame.mirrored}), missed);
    }

    void scatter_leaves(int site) {
        const std::vector<std::size_t>& leaves = leaves_at_[static_cast<std::size_t>(site)];
        if (!is_in_production(site) || leaves.size() < least_copies) return;
        Column ahead, right, turn, log_scale;
        std::vector<double> misses;
        for (const std::size_t leaf : leaves) {
            const LeafResidual& residual = residuals_[leaf];
            if (residual.move.mirrored) return;
            const double size = scale_of(residual.placement.pose);
            const Point local = local_miss(residual.placement.pose, missed_[leaf]);
            const double turned = arg(residual.move.linear), scaled = std::log(scale_of(residual.move));
            ahead.add(local.y, size);
            right.add(local.x, size);
            turn.add(turned, residual.reach);
            log_scale.add(scaled, residual.reach);
            misses.push_back(abs(missed_[leaf]) + residual.reach * (std::abs(turned) + std::abs(scaled)));
        }
        if (median_of(misses) <= tolerance_) return;
        for (const std::size_t leaf : leaves) left_[leaf] = true;
        add_noise(site, {.ahead = ahead.spread(tolerance_),
                         .right = right.spread(tolerance_),
                         .turn = turn.spread(tolerance_),
                         .log_scale = log_scale.spread(tolerance_)});
    }

    void add_noise(int site, const Noise& noise) {
        const ModuleSite& place = tree_.sites[static_cast<std::size_t>(site)];
        std::vector<ModuleTemplate> modules = modules_of(noise);
        if (!modules.empty()) noise_[{place.string, place.position}] = std::move(modules);
    }

    /// From the end of each successor, so that positions hold. What follows the module begins where it did before.
    void insert_noise(Grammar& grammar) const {
        for (auto at = noise_.rbegin(); at != noise_.rend(); ++at) {
            const auto& [place, modules] = *at;
            std::vector<ModuleTemplate>& successor = grammar.productions[static_cast<std::size_t>(place.first)].successor;
            const auto position = static_cast<std::size_t>(place.second);
            std::vector<ModuleTemplate> part = modules;
            part.push_back(successor[position]);
            const bool is_last = position + 1 < successor.size() && successor[position + 1].symbol == "]";
            if (!is_last) part = bracketed(std::move(part));
            const auto here = successor.begin() + place.second;
            successor.insert(successor.erase(here), part.begin(), part.end());
        }
        if (noise_.empty()) return;
        grammar.seed = 1;
        grammar.comments.push_back("The noise is as the drawing has it: each seed draws a relative of it.");
    }
};

}  // namespace

Residuals with_scatter(const WrittenGrammar& written, const Instancing& instancing, double tolerance) {
    return ScatterWriter(written.grammar, leaf_residuals(written, instancing), tolerance).write();
}

}  // namespace rinceau
