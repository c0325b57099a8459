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

/// How far a part at `pose` is from standing where `wanted` is: place, size, and angle up to its symmetry.
double mismatch(const Part& part, const Similarity& pose, const Similarity& wanted) {
    const Similarity nearest = nearest_pose(part, pose, wanted);
    const double angle = nearest.mirrored == wanted.mirrored ? abs(nearest.linear - wanted.linear) : 4 * scale_of(wanted);
    return abs(nearest.translation - wanted.translation) + angle;
}

/// A place of a member, and the pose of what belongs there: the member's own, or where the part has it.
struct Slot {
    int member = -1;
    int part = 0;
    Similarity pose;
    bool regular = true;
};

std::vector<Slot> slots_of(const RuleSet& rules, const Item& item) {
    const std::vector<Child>& children = rules.parts[static_cast<std::size_t>(item.part)].children;
    std::vector<Slot> slots;
    slots.reserve(item.members.size());
    for (std::size_t k = 0; k < item.members.size(); ++k) {
        const bool regular = is_regular(rules, item, k);
        const int member = item.members[k];
        slots.push_back({member, children[k].part,
                         regular ? rules.items[static_cast<std::size_t>(member)].pose : item.pose * children[k].pose, regular});
    }
    return slots;
}

}  // namespace

void regauge(RuleSet& rules, int item, const Similarity& frame) {
    Item& at = rules.items[static_cast<std::size_t>(item)];
    if (frame == at.pose) return;
    std::vector<Slot> free = slots_of(rules, at);
    at.pose = frame;
    if (free.empty()) return;
    const std::vector<Child>& children = rules.parts[static_cast<std::size_t>(at.part)].children;
    std::vector<int> ordered;
    for (const Child& child : children) {
        const Similarity wanted = frame * child.pose;
        std::size_t best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < free.size(); ++k) {
            if (free[k].part != child.part) continue;
            const double error = mismatch(rules.parts[static_cast<std::size_t>(child.part)], free[k].pose, wanted);
            if (error < least) {
                least = error;
                best = k;
            }
        }
        const Slot taken = free[best];
        const int member = taken.member;
        free.erase(free.begin() + static_cast<std::ptrdiff_t>(best));
        ordered.push_back(member);
        if (!taken.regular) continue;
        const Item& below = rules.items[static_cast<std::size_t>(member)];
        regauge(rules, member, nearest_pose(rules.parts[static_cast<std::size_t>(below.part)], below.pose, wanted));
    }
    rules.items[static_cast<std::size_t>(item)].members = std::move(ordered);
}

}  // namespace rinceau
