#include "analyzer/outline_classes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "analyzer/point_symmetry.h"

namespace rinceau {

namespace {

/// Residual under which two outlines are the same but for rounding, so that their alignments may be chained.
constexpr double exact_residual = 1e-9;

/// The cells of the first three key entries that leaders live in.
class KeyGrid {
  public:
    explicit KeyGrid(double cell) : cell_(cell) {}

    void add(const InvariantKey& key, int group) { cells_[code(cell_of(key), 0, 0, 0)].push_back(group); }

    template <class Visit>
    void for_near(const InvariantKey& key, Visit visit) const {
        const Cell cell = cell_of(key);
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j)
                for (int k = -1; k <= 1; ++k)
                    if (const auto found = cells_.find(code(cell, i, j, k)); found != cells_.end())
                        for (const int group : found->second) visit(group);
    }

  private:
    using Cell = std::array<std::int64_t, 3>;

    Cell cell_of(const InvariantKey& key) const {
        Cell cell;
        for (std::size_t i = 0; i < cell.size(); ++i) cell[i] = static_cast<std::int64_t>(std::floor(key[i] / cell_));
        return cell;
    }
    /// Cells that share a code only cost a comparison of keys.
    static std::uint64_t code(const Cell& cell, int i, int j, int k) {
        constexpr std::uint64_t factor = 0x9E3779B97F4A7C15u;
        std::uint64_t sum = static_cast<std::uint64_t>(cell[0] + i);
        sum = sum * factor + static_cast<std::uint64_t>(cell[1] + j);
        return sum * factor + static_cast<std::uint64_t>(cell[2] + k);
    }

    double cell_;
    std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

/// An item whose fine outline is made when it is first needed.
class Candidate {
  public:
    explicit Candidate(const OutlineItem& item) : item_(item) {}
    const OutlineItem& item() const { return item_; }
    const FineOutline& fine() {
        if (!fine_) fine_ = fine_outline_of(item_);
        return *fine_;
    }

  private:
    const OutlineItem& item_;
    std::optional<FineOutline> fine_;
};

/// `from` laid onto `to`; nothing if no alignment passes the geometric check.
std::optional<OutlineMember> match(Candidate& from, Candidate& to, const OutlineClassOptions& options) {
    constexpr std::size_t tries = 4;      // alignments of nearly equal residual: nearly symmetric shapes
    constexpr double worth_refining = 2;  // allowed distances: least squares do not gain more
    const Moments& source = from.item().descriptor.moments;
    const Moments& target = to.item().descriptor.moments;
    for (const bool mirrored : {false, true}) {
        if (mirrored && !options.mirrored_copies) break;
        for (const Alignment& a : alignments(source, target, mirrored, options.moment_residual, tries)) {
            OutlineMember member{-1, to_similarity(a), a.residual};
            if (within_distance(from.fine(), member.map, to.fine(), to.item().distance)) return member;
            if (!within_distance(from.fine(), member.map, to.fine(), worth_refining * to.item().distance)) continue;
            member.map = refined(from.fine(), member.map, to.fine());
            if (within_distance(from.fine(), member.map, to.fine(), to.item().distance)) return member;
        }
    }
    return std::nullopt;
}

class Classifier {
  public:
    Classifier(const std::vector<OutlineItem>& items, const OutlineClassOptions& options)
        : items_(items), options_(options), grid_(options.key_cell), members_(items.size()) {}

    /// Leaders in the order of the items.
    void cluster(const Progress& progress) {
        for (std::size_t i = 0; i < items_.size(); ++i) {
            constexpr std::size_t report_every = 16;
            if (i % report_every == 0)
                report(progress, "similarity", static_cast<double>(i) / static_cast<double>(items_.size()));
            Candidate item(items_[i]);
            if (!join(item, static_cast<int>(i))) lead(static_cast<int>(i));
        }
    }

    /// Members of small groups move to groups at least four times as large that would take them: noise at the border of a
    /// leader's reach leaves such fragments.
    void merge_fragments(const Progress& progress) {
        constexpr int times_larger = 4;
        std::vector<int> order(groups_.size());
        std::iota(order.begin(), order.end(), 0);
        std::ranges::stable_sort(order, {}, [&](int g) { return size_of(g); });
        for (const int small : order) {
            report(progress, "similarity", 1);
            const int size = size_of(small);
            std::vector<int> kept;
            for (const int m : groups_[static_cast<std::size_t>(small)].members) {
                Candidate item(items_[static_cast<std::size_t>(m)]);
                if (!join(item, m, [&](int g) { return g != small && size_of(g) >= times_larger * size; }))
                    kept.push_back(m);
            }
            regroup(small, kept);
        }
    }

    /// Makes the most typical member, of the fewest segments, the representative where all others match it; of circles the
    /// largest, whose coordinates are the least rounded.
    void elect_representatives(const Progress& progress) {
        for (OutlineGroup& group : groups_) {
            report(progress, "similarity", 1);
            if (group.members.size() < 2) continue;
            const int largest = largest_member(group);
            const int elected = is_round(largest) ? largest : typical_member(group);
            if (elected != group.representative) realign(group, elected);
        }
    }

    /// Least squares against the representative for all that are not exact copies.
    void refine(const Progress& progress) {
        for (const OutlineGroup& group : groups_) {
            std::optional<Candidate> representative;
            for (const int m : group.members) {
                report(progress, "similarity", 1);
                OutlineMember& member = members_[static_cast<std::size_t>(m)];
                if (m == group.representative || member.residual <= exact_residual) continue;
                if (!representative) representative.emplace(items_[static_cast<std::size_t>(group.representative)]);
                Candidate item(items_[static_cast<std::size_t>(m)]);
                const Similarity better = refined(representative->fine(), member.map, item.fine());
                if (within_distance(representative->fine(), better, item.fine(), item.item().distance)) member.map = better;
            }
        }
    }

    OutlineClasses result() && {
        OutlineClasses classes;
        std::erase_if(groups_, [](const OutlineGroup& g) { return g.members.empty(); });
        for (OutlineGroup& group : groups_) std::ranges::sort(group.members);
        std::ranges::sort(groups_, {}, [](const OutlineGroup& g) { return g.members.front(); });
        for (std::size_t g = 0; g < groups_.size(); ++g)
            for (const int m : groups_[g].members) members_[static_cast<std::size_t>(m)].group = static_cast<int>(g);
        classes.groups = std::move(groups_);
        classes.members = std::move(members_);
        return classes;
    }

  private:
    int size_of(int g) const {
        int size = 0;
        for (const int m : groups_[static_cast<std::size_t>(g)].members) size += items_[static_cast<std::size_t>(m)].count;
        return size;
    }

    void lead(int item) {
        const int group = static_cast<int>(groups_.size());
        groups_.push_back({item, {item}});
        leaders_.emplace_back(items_[static_cast<std::size_t>(item)]);
        grid_.add(items_[static_cast<std::size_t>(item)].descriptor.key, group);
        members_[static_cast<std::size_t>(item)] = {group, Similarity{}, 0};
    }

    bool join(Candidate& item, int index) {
        return join(item, index, [](int) { return true; });
    }

    /// Joins the first matching group among those that `allowed` lets pass, nearest key first.
    template <class Allowed>
    bool join(Candidate& item, int index, Allowed allowed) {
        std::vector<std::pair<double, int>> near;
        grid_.for_near(item.item().descriptor.key, [&](int g) {
            const OutlineItem& leader = leaders_[static_cast<std::size_t>(g)].item();
            const double distance = key_distance(leader.descriptor.key, item.item().descriptor.key);
            if (distance <= options_.key_cell) near.push_back({distance, g});
        });
        std::ranges::sort(near);
        for (const auto& [distance, g] : near) {
            if (!allowed(g)) continue;
            std::optional<OutlineMember> member = match(leaders_[static_cast<std::size_t>(g)], item, options_);
            if (!member) continue;
            member->group = g;
            members_[static_cast<std::size_t>(index)] = *member;
            groups_[static_cast<std::size_t>(g)].members.push_back(index);
            return true;
        }
        return false;
    }

    /// What is left of a group of which members have moved; without its leader it gets a new one, or none takes the rest.
    void regroup(int g, const std::vector<int>& kept) {
        OutlineGroup& group = groups_[static_cast<std::size_t>(g)];
        if (kept.size() == group.members.size()) return;
        const bool has_leader = std::ranges::find(kept, group.representative) != kept.end();
        group.members.clear();
        if (has_leader) {
            group.members = kept;
            return;
        }
        std::vector<int> own;  // groups that the rest founds
        for (const int m : kept) {
            Candidate item(items_[static_cast<std::size_t>(m)]);
            if (join(item, m, [&](int other) { return std::ranges::find(own, other) != own.end(); })) continue;
            own.push_back(static_cast<int>(groups_.size()));
            lead(m);
        }
    }

    int largest_member(const OutlineGroup& group) const {
        return *std::ranges::max_element(group.members, {},
                                         [&](int m) { return items_[static_cast<std::size_t>(m)].descriptor.rms_radius; });
    }

    bool is_round(int m) const {
        const OutlineItem& item = items_[static_cast<std::size_t>(m)];
        return is_circular(item.descriptor.moments, fine_outline_of(item), item.distance);
    }

    int typical_member(const OutlineGroup& group) const {
        InvariantKey mean{};
        double total = 0;
        for (const int m : group.members) {
            const OutlineItem& item = items_[static_cast<std::size_t>(m)];
            for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += item.count * item.descriptor.key[i];
            total += item.count;
        }
        for (double& entry : mean) entry /= total;
        const auto distance = [&](int m) { return key_distance(items_[static_cast<std::size_t>(m)].descriptor.key, mean); };
        double nearest = std::numeric_limits<double>::infinity();
        for (const int m : group.members) nearest = std::min(nearest, distance(m));
        // As near as the typical one, or nearly: the plainest of them.
        constexpr double nearly = 2;
        constexpr double rounding = 1e-9;
        int best = -1;
        std::size_t fewest = 0;
        for (const int m : group.members) {
            const std::size_t pieces = items_[static_cast<std::size_t>(m)].outline->pieces.size();
            if (distance(m) > nearly * nearest + rounding || (best >= 0 && pieces >= fewest)) continue;
            best = m;
            fewest = pieces;
        }
        return best;
    }

    /// Makes `elected` the representative if every member still matches; alignments of exact copies are chained.
    void realign(OutlineGroup& group, int elected) {
        Candidate representative(items_[static_cast<std::size_t>(elected)]);
        const OutlineMember to_elected = members_[static_cast<std::size_t>(elected)];
        std::vector<OutlineMember> aligned;
        for (const int m : group.members) {
            const OutlineMember& old = members_[static_cast<std::size_t>(m)];
            if (m == elected) {
                aligned.push_back({old.group, Similarity{}, 0});
            } else if (to_elected.residual <= exact_residual && old.residual <= exact_residual) {
                aligned.push_back({old.group, old.map * inverse(to_elected.map), old.residual});
            } else {
                Candidate item(items_[static_cast<std::size_t>(m)]);
                const std::optional<OutlineMember> member = match(representative, item, options_);
                if (!member) return;
                aligned.push_back({old.group, member->map, member->residual});
            }
        }
        for (std::size_t i = 0; i < aligned.size(); ++i) members_[static_cast<std::size_t>(group.members[i])] = aligned[i];
        group.representative = elected;
    }

    const std::vector<OutlineItem>& items_;
    const OutlineClassOptions& options_;
    KeyGrid grid_;
    std::vector<OutlineGroup> groups_;
    std::vector<Candidate> leaders_;  ///< of groups_, as first found
    std::vector<OutlineMember> members_;
};

}  // namespace

FineOutline fine_outline_of(const OutlineItem& item) {
    const Descriptor& d = item.descriptor;
    return fine_outline(*item.outline, d.centroid - item.outline->origin, d.rms_radius);
}

OutlineClasses classify_outlines(const std::vector<OutlineItem>& items, const OutlineClassOptions& options,
                                 const Progress& progress) {
    Classifier classifier(items, options);
    classifier.cluster(progress);
    classifier.merge_fragments(progress);
    classifier.elect_representatives(progress);
    classifier.refine(progress);
    return std::move(classifier).result();
}

}  // namespace rinceau
