#include "analyzer/regauge.h"

#include <cmath>
#include <limits>

namespace rinceau {

Similarity nearest_pose(const Part& part, const Similarity& pose, const Similarity& wanted) {
    if (part.symmetry.continuous) {
        const double scale = scale_of(pose) / scale_of(wanted);
        return {wanted.linear * scale, pose.translation, wanted.mirrored};
    }
    Similarity best = pose;
    double least = std::numeric_limits<double>::infinity();
    for (const Similarity& gauge : part.symmetry.elements) {
        const Similarity candidate = pose * gauge;
        if (candidate.mirrored != wanted.mirrored) continue;
        const double error = norm(candidate.linear - wanted.linear);
        if (error < least) {
            least = error;
            best = candidate;
        }
    }
    return best;
}

namespace {

/// How far an item is from standing where `wanted` is: place, size, and angle up to its symmetry.
double mismatch(const RuleSet& rules, int item, const Similarity& wanted) {
    const Item& at = rules.items[static_cast<std::size_t>(item)];
    const Similarity nearest = nearest_pose(rules.parts[static_cast<std::size_t>(at.part)], at.pose, wanted);
    const double angle = nearest.mirrored == wanted.mirrored ? abs(nearest.linear - wanted.linear) : 4 * scale_of(wanted);
    return abs(nearest.translation - wanted.translation) + angle;
}

}  // namespace

void regauge(RuleSet& rules, int item, const Similarity& frame) {
    Item& at = rules.items[static_cast<std::size_t>(item)];
    if (frame == at.pose) return;
    at.pose = frame;
    const std::vector<Child>& children = rules.parts[static_cast<std::size_t>(at.part)].children;
    std::vector<int> free = at.members;
    std::vector<int> ordered;
    for (const Child& child : children) {
        const Similarity wanted = frame * child.pose;
        std::size_t best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < free.size(); ++k) {
            if (rules.items[static_cast<std::size_t>(free[k])].part != child.part) continue;
            const double error = mismatch(rules, free[k], wanted);
            if (error < least) {
                least = error;
                best = k;
            }
        }
        const int member = free[best];
        free.erase(free.begin() + static_cast<std::ptrdiff_t>(best));
        ordered.push_back(member);
        const Item& below = rules.items[static_cast<std::size_t>(member)];
        regauge(rules, member, nearest_pose(rules.parts[static_cast<std::size_t>(below.part)], below.pose, wanted));
    }
    rules.items[static_cast<std::size_t>(item)].members = std::move(ordered);
}

}  // namespace rinceau
