#include "analyzer/fit_branch.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "analyzer/regauge.h"

namespace rinceau {

namespace {

constexpr std::size_t most_nodes = 20'000;   // of the trees that are fitted; the first ones
constexpr std::size_t most_trees = 6;
constexpr std::size_t most_observed = 2'000;  // items that count
constexpr int iterations = 3;

/// Numbers of a similarity in a vector.
void put(Eigen::VectorXd& values, Eigen::Index at, const Similarity& map) {
    values.segment<4>(at) << map.linear.x, map.linear.y, map.translation.x, map.translation.y;
}
Similarity taken(const Eigen::VectorXd& values, Eigen::Index at, bool mirrored) {
    return {{values(at), values(at + 1)}, {values(at + 2), values(at + 3)}, mirrored};
}

struct Observation {
    std::size_t node = 0;
    Similarity within;  ///< of the item in the node's frame
    int item = 0;
};

class Fit {
  public:
    Fit(const SearchState& state, const Rule& rule, const std::vector<BranchTree>& trees)
        : state_(state), rule_(rule), trees_(trees) {
        std::size_t nodes = 0;
        for (const BranchTree& tree : trees) {
            if (used_ == most_trees || (used_ > 0 && nodes + tree.nodes.size() > most_nodes)) break;
            nodes += tree.nodes.size();
            ++used_;
        }
        const auto steps = static_cast<Eigen::Index>(rule.steps.size());
        values_.resize(4 * (steps + static_cast<Eigen::Index>(used_)));
        for (std::size_t k = 0; k < rule.steps.size(); ++k) put(values_, step_at(k), rule.steps[k]);
        for (std::size_t t = 0; t < used_; ++t) put(values_, root_at(t), trees[t].nodes.front().frame);
        collect_observations();
    }

    FittedBranch run() {
        free_.assign(static_cast<std::size_t>(values_.size()), true);
        minimise();
        settle_on_natural_values();
        FittedBranch fitted;
        for (std::size_t k = 0; k < rule_.steps.size(); ++k) fitted.steps.push_back(step(values_, k));
        for (std::size_t t = 0; t < trees_.size(); ++t) {
            const Similarity& guess = trees_[t].nodes.front().frame;
            fitted.roots.push_back(t < used_ ? taken(values_, root_at(t), guess.mirrored) : guess);
        }
        return fitted;
    }

  private:
    const SearchState& state_;
    const Rule& rule_;
    const std::vector<BranchTree>& trees_;
    std::size_t used_ = 0;
    std::vector<std::vector<Observation>> observations_;  // by tree
    Eigen::VectorXd values_;
    std::vector<bool> free_;

    static Eigen::Index step_at(std::size_t k) { return static_cast<Eigen::Index>(4 * k); }
    Eigen::Index root_at(std::size_t t) const { return static_cast<Eigen::Index>(4 * (rule_.steps.size() + t)); }
    Similarity step(const Eigen::VectorXd& values, std::size_t k) const {
        return taken(values, step_at(k), rule_.steps[k].mirrored);
    }

    void collect_observations() {
        std::size_t total = 0;
        for (std::size_t t = 0; t < used_; ++t) total += trees_[t].nodes.size();
        const std::size_t stride = 1 + total / most_observed;
        for (std::size_t t = 0; t < used_; ++t) {
            const std::vector<BranchNode>& nodes = trees_[t].nodes;
            std::vector<Observation> seen;
            const std::size_t inner = nodes_below(trees_[t].depth);
            for (std::size_t node = 0; node < nodes.size(); ++node) {
                // The low nodes carry all others; of the many high ones some will do.
                constexpr std::size_t low_nodes = 64;
                if (nodes[node].items.empty() || (node >= low_nodes && node % stride != 0)) continue;
                const std::vector<Child>& stands = node < inner ? rule_.members : rule_.leaves;
                if (nodes[node].items.front() < 0) continue;
                seen.push_back({node, stands.front().pose, nodes[node].items.front()});
            }
            observations_.push_back(std::move(seen));
        }
    }

    std::size_t nodes_below(int depth) const {
        std::size_t nodes = 0, row = 1;
        for (int level = 0; level < depth; ++level) {
            nodes += row;
            row *= rule_.steps.size();
        }
        return nodes;
    }

    std::vector<Similarity> frames(const Eigen::VectorXd& values, std::size_t t) const {
        std::vector<Similarity> steps, frames;
        for (std::size_t k = 0; k < rule_.steps.size(); ++k) steps.push_back(step(values, k));
        const std::size_t branches = steps.size(), count = trees_[t].nodes.size();
        frames.reserve(count);
        frames.push_back(taken(values, root_at(t), trees_[t].nodes.front().frame.mirrored));
        for (std::size_t node = 1; node < count; ++node) {
            frames.push_back(frames[(node - 1) / branches] * steps[(node - 1) % branches]);
        }
        return frames;
    }

    /// Where the items are under these values.
    std::vector<Similarity> predicted(const Eigen::VectorXd& values) const {
        std::vector<Similarity> poses;
        for (std::size_t t = 0; t < used_; ++t) {
            const std::vector<Similarity> at = frames(values, t);
            for (const Observation& seen : observations_[t]) poses.push_back(at[seen.node] * seen.within);
        }
        return poses;
    }

    std::vector<Similarity> drawn(const std::vector<Similarity>& wanted) const {
        std::vector<Similarity> poses;
        for (const std::vector<Observation>& tree : observations_) {
            for (const Observation& seen : tree) {
                const Item& item = state_.item(seen.item);
                poses.push_back(nearest_pose(state_.part(item.part), item.pose, wanted[poses.size()]));
            }
        }
        return poses;
    }

    static Eigen::VectorXd difference(const std::vector<Similarity>& a, const std::vector<Similarity>& b) {
        Eigen::VectorXd rows(static_cast<Eigen::Index>(4 * a.size()));
        for (std::size_t k = 0; k < a.size(); ++k) {
            const Point shift = a[k].translation - b[k].translation, turn = a[k].linear - b[k].linear;
            rows.segment<4>(static_cast<Eigen::Index>(4 * k)) << shift.x, shift.y, turn.x, turn.y;
        }
        return rows;
    }

    double error(const Eigen::VectorXd& values) const {
        const std::vector<Similarity> poses = predicted(values);
        return difference(poses, drawn(poses)).norm();
    }

    void minimise() {
        std::vector<Eigen::Index> columns;
        for (Eigen::Index c = 0; c < values_.size(); ++c) {
            if (free_[static_cast<std::size_t>(c)]) columns.push_back(c);
        }
        for (int round = 0; round < iterations; ++round) {
            const std::vector<Similarity> poses = predicted(values_);
            const Eigen::VectorXd rest = difference(drawn(poses), poses);
            Eigen::MatrixXd jacobian(rest.size(), static_cast<Eigen::Index>(columns.size()));
            for (std::size_t c = 0; c < columns.size(); ++c) {
                // Products of the values: a difference quotient is as good as a derivative.
                Eigen::VectorXd moved = values_;
                const double nudge = 1e-7 * std::max(1.0, std::abs(values_(columns[c])));
                moved(columns[c]) += nudge;
                jacobian.col(static_cast<Eigen::Index>(c)) = difference(predicted(moved), poses) / nudge;
            }
            const Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
            // Directions in which nothing changes stay as they are.
            Eigen::MatrixXd damped = normal;
            damped.diagonal() *= 1 + 1e-10;
            damped.diagonal().array() += 1e-12 * normal.diagonal().maxCoeff();
            const Eigen::VectorXd change = damped.ldlt().solve(jacobian.transpose() * rest);
            if (!change.allFinite()) return;
            Eigen::VectorXd next = values_;
            for (std::size_t c = 0; c < columns.size(); ++c) next(columns[c]) += change(static_cast<Eigen::Index>(c));
            if (!(error(next) < error(values_))) return;
            values_ = next;
        }
    }

    /// Angles that are multiples of 15 degrees and scales that are plain, each where all others then fit as well.
    void settle_on_natural_values() {
        constexpr double allowed = 1.2;  // times the least error
        const double tiny = 1e-7 * state_.diagonal;
        for (const bool scales : {true, false}) {
            const Eigen::VectorXd best = values_;
            const double bound = allowed * error(values_) + tiny;
            for (std::size_t k = 0; k < rule_.steps.size(); ++k) {
                Similarity natural = step(values_, k);
                natural.linear = polar(scales ? plain_scale(scale_of(natural)) : scale_of(natural), plain_angle(arg(natural.linear)));
                put(values_, step_at(k), natural);
                const bool changes_scale = scales;
                free_[4 * k] = free_[4 * k + 1] = !changes_scale;
            }
            minimise();
            free_.assign(free_.size(), true);
            if (error(values_) <= bound) return;
            values_ = best;
        }
    }

    static double plain_angle(double angle) {
        constexpr double near = radians(0.2);
        const double natural = radians(15 * std::round(degrees(angle) / 15));
        return std::abs(natural - angle) <= near ? natural : angle;
    }

    /// 1, 1/2, 1/3 .., their square roots, or two digits.
    static double plain_scale(double scale) {
        constexpr double near = 2e-3;
        for (int n = 1; n <= 12; ++n) {
            for (const double plain : {1.0 / n, 1 / std::sqrt(static_cast<double>(n))}) {
                if (std::abs(plain / scale - 1) <= near) return plain;
            }
        }
        const double digits = std::round(scale * 100) / 100;
        return digits > 0 && std::abs(digits / scale - 1) <= near ? digits : scale;
    }
};

}  // namespace

FittedBranch fitted_branch(const SearchState& state, const Rule& rule, const std::vector<BranchTree>& trees) {
    return Fit(state, rule, trees).run();
}

}  // namespace rinceau
