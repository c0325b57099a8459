#include "analyzer/regular_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "analyzer/concentric_rings.h"
#include "analyzer/lattice_arrangement.h"
#include "analyzer/ring_arrangement.h"
#include "geometry/kd_tree.h"

namespace rinceau {

namespace {

constexpr std::size_t least_copies = 4;
constexpr std::size_t most_copies = 4000;      // irregular drawings are made by hand; keeps the cost bounded
constexpr double precision_share = 0.002;      // of an element's size
constexpr double already_regular = 0.01;       // of an element's size: what the search tolerates anyway
constexpr int most_levels = 4;
constexpr std::array block_cuts{1.3, 1.6, 2.0, 2.6};  // of the spacing

/// Bodies that are copies of each other, and where their elements stand in them.
struct Kind {
    BodyForm form;
    std::vector<Similarity> slots{Similarity{}};
    std::vector<Body> bodies;
    double size = 1;  // geometric mean of the elements' sizes
};

std::vector<Kind> kinds_of(std::span<const PlacedCopy> copies) {
    std::map<std::pair<int, bool>, Kind> kinds;
    for (std::size_t c = 0; c < copies.size(); ++c) {
        const SymmetryGroup& symmetry = *copies[c].symmetry;
        Body body{copies[c].pose, {static_cast<int>(c)}};
        if (symmetry.continuous) body.pose.mirrored = false;
        const auto mirror = std::ranges::find(symmetry.elements, true, &Similarity::mirrored);
        if (body.pose.mirrored && mirror != symmetry.elements.end()) body.pose = body.pose * *mirror;
        Kind& kind = kinds[{copies[c].kind, body.pose.mirrored}];
        const auto turns = std::ranges::count(symmetry.elements, false, &Similarity::mirrored);
        kind.form.fold = symmetry.continuous ? 0 : static_cast<int>(turns);
        if (mirror != symmetry.elements.end()) kind.form.axis = arg(mirror->linear) / 2;
        kind.bodies.push_back(std::move(body));
    }
    std::vector<Kind> list;
    for (auto& [unused, kind] : kinds) {
        double log_size = 0;
        for (const Body& body : kind.bodies) log_size += std::log(scale_of(body.pose));
        kind.size = std::exp(log_size / static_cast<double>(kind.bodies.size()));
        list.push_back(std::move(kind));
    }
    return list;
}

/// Bodies that hang together by distances of at most `reach`.
std::vector<std::vector<int>> blocks_of(const std::vector<Body>& bodies, double reach) {
    std::vector<Point> places;
    for (const Body& body : bodies) places.push_back(body.pose.translation);
    const KdTree tree(places);
    std::vector<int> block(bodies.size(), -1);
    std::vector<std::vector<int>> blocks;
    for (std::size_t seed = 0; seed < bodies.size(); ++seed) {
        if (block[seed] >= 0) continue;
        std::vector<int> members{static_cast<int>(seed)};
        block[seed] = static_cast<int>(blocks.size());
        for (std::size_t at = 0; at < members.size(); ++at) {
            for (const Neighbor& near : tree.within(places[static_cast<std::size_t>(members[at])], reach)) {
                if (block[near.index] >= 0) continue;
                block[near.index] = block[seed];
                members.push_back(static_cast<int>(near.index));
            }
        }
        std::ranges::sort(members);
        blocks.push_back(std::move(members));
    }
    return blocks;
}

double bits_of(const std::vector<Arrangement>& arrangements) {
    return std::accumulate(arrangements.begin(), arrangements.end(), 0.0,
                           [](double sum, const Arrangement& a) { return sum + a.bits_saved; });
}

/// Rows and columns, or rings, whichever say it shorter.
std::vector<Arrangement> arrangements_of(const Kind& kind, std::span<const int> chosen, const ArrangementScale& scale) {
    std::vector<Arrangement> rings = arrange_in_rings(kind.bodies, chosen, kind.form, scale);
    auto lattice = arrange_in_lattice(kind.bodies, chosen, kind.form, scale);
    if (lattice && lattice->bits_saved > bits_of(rings)) return {std::move(*lattice)};
    return rings;
}

/// The whole kind, or its blocks, whichever say it shorter.
std::vector<Arrangement> best_division(const Kind& kind, const ArrangementScale& scale) {
    std::vector<int> all(kind.bodies.size());
    std::iota(all.begin(), all.end(), 0);
    std::vector<Arrangement> best = arrangements_of(kind, all, scale);
    std::vector<Point> places;
    for (const Body& body : kind.bodies) places.push_back(body.pose.translation);
    const double spacing = median_spacing(places);
    std::size_t before = 1;
    for (const double cut : block_cuts) {
        const auto blocks = blocks_of(kind.bodies, cut * spacing);
        if (blocks.size() == before) continue;
        before = blocks.size();
        std::vector<Arrangement> divided;
        for (const std::vector<int>& block : blocks) {
            for (Arrangement& each : arrangements_of(kind, block, scale)) divided.push_back(std::move(each));
        }
        if (bits_of(divided) > bits_of(best)) best = std::move(divided);
    }
    return best;
}

/// Arrangements of one form that differ by no more than their spread are given the same slots.
std::vector<std::vector<std::size_t>> equalized(std::vector<Arrangement>& found) {
    constexpr double as_good_as_equal = 2.5;  // spreads
    std::map<std::vector<int>, std::vector<std::vector<std::size_t>>> groups;
    for (std::size_t f = 0; f < found.size(); ++f) {
        auto& forms = groups[found[f].signature];
        const auto alike = std::ranges::find_if(forms, [&](const std::vector<std::size_t>& form) {
            const Arrangement& a = found[form.front()];
            const Arrangement& b = found[f];
            for (std::size_t k = 0; k < a.slots.size(); ++k) {
                const double allowed = as_good_as_equal * std::max(a.spread, b.spread);
                if (abs(a.slots[k].translation - b.slots[k].translation) > allowed) return false;
            }
            return true;
        });
        if (alike == forms.end()) {
            forms.push_back({f});
        } else {
            alike->push_back(f);
        }
    }
    std::vector<std::vector<std::size_t>> classes;
    for (auto& [unused, forms] : groups) {
        for (auto& form : forms) {
            const auto share = 1 / static_cast<double>(form.size());
            const std::size_t slots = found[form.front()].slots.size();
            for (std::size_t k = 0; k < slots; ++k) {
                Point mean{};
                for (const std::size_t f : form) mean += share * found[f].slots[k].translation;
                for (const std::size_t f : form) found[f].slots[k].translation = mean;
            }
            classes.push_back(std::move(form));
        }
    }
    return classes;
}

/// The body's elements in the order in which the slots of its kind meet them when it stands in `pose`: a ring that is turned
/// by some of its members begins with another one.
std::vector<int> turned_to(const Body& body, const Similarity& pose, int fold) {
    std::vector<int> instances = body.instances;
    if (instances.size() < 2 || fold < 2) return instances;
    const double turn = arg(body.pose.linear / pose.linear) * fold / two_pi;
    const int members = ((static_cast<int>(std::lround(turn)) % fold) + fold) % fold;
    const auto each = static_cast<std::ptrdiff_t>(instances.size()) / fold;
    std::rotate(instances.begin(), instances.end() - members * each, instances.end());
    return instances;
}

/// The kind that these arrangements of one kind of bodies are the bodies of.
Kind kind_above(const Kind& below, const std::vector<const Arrangement*>& arrangements) {
    Kind above;
    above.form = arrangements.front()->form;
    above.size = below.size;
    above.slots.clear();
    std::vector<Similarity> slots = arrangements.front()->slots;
    double turned = 0;
    for (const Arrangement* each : arrangements) turned = std::max(turned, each->turned);
    const double bodies = static_cast<double>(slots.size() * arrangements.size());
    for (std::size_t k = 0; k < slots.size(); ++k) {
        // Directions and sizes of the bodies: their mean over all arrangements, in rings against the way to the centre.
        const Complex outward = arrangements.front()->is_ring ? slots[k].translation / abs(slots[k].translation) : Complex{1, 0};
        Complex sum{};
        for (const Arrangement* each : arrangements) {
            const Complex ratio = each->slots[k].linear / slots[k].linear;
            const double off = below.form.fold > 0 ? std::remainder(arg(ratio), two_pi / below.form.fold) : 0;
            sum += polar(abs(ratio), off);
        }
        const Complex mean = slots[k].linear * (sum / static_cast<double>(arrangements.size())) / outward;
        const double direction = laid_along(arg(mean), below.form, turned / std::sqrt(bodies));
        slots[k].linear = outward * polar(abs(mean), direction);
        if (arrangements.front()->is_ring && lies_along(direction, below.form)) above.form.axis = 0;
        for (const Similarity& inner : below.slots) above.slots.push_back(slots[k] * inner);
    }
    for (const Arrangement* each : arrangements) {
        Body body{each->whole, {}};
        for (std::size_t k = 0; k < slots.size(); ++k) {
            const Body& member = below.bodies[static_cast<std::size_t>(each->bodies[k])];
            const std::vector<int> instances = turned_to(member, each->whole * slots[k], below.form.fold);
            body.instances.insert(body.instances.end(), instances.begin(), instances.end());
        }
        above.bodies.push_back(std::move(body));
    }
    return above;
}

/// One level up: what the bodies of these kinds are arranged in. Places that are found go to `regular`.
std::vector<Kind> arranged(const std::vector<Kind>& kinds, double diagonal, std::vector<Similarity>& regular) {
    std::vector<Arrangement> found;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        if (kinds[k].bodies.size() < least_copies || kinds[k].bodies.size() > most_copies) continue;
        const ArrangementScale scale{precision_share * kinds[k].size, diagonal};
        for (Arrangement& each : best_division(kinds[k], scale)) {
            each.kind = static_cast<int>(k);
            found.push_back(std::move(each));
        }
    }
    std::vector<BodyForm> forms;
    for (const Kind& kind : kinds) forms.push_back(kind.form);
    found = aligned_rings(std::move(found), forms);
    std::vector<Kind> above;
    for (const std::vector<std::size_t>& form : equalized(found)) {
        std::map<int, std::vector<const Arrangement*>> by_kind;
        for (const std::size_t f : form) by_kind[found[f].kind].push_back(&found[f]);
        for (const auto& [kind, arrangements] : by_kind) {
            above.push_back(kind_above(kinds[static_cast<std::size_t>(kind)], arrangements));
            for (const Body& body : above.back().bodies) {
                for (std::size_t k = 0; k < body.instances.size(); ++k) {
                    regular[static_cast<std::size_t>(body.instances[k])] = body.pose * above.back().slots[k];
                }
            }
        }
    }
    return above;
}

}  // namespace

bool stands_elsewhere(const Similarity& drawn, const Similarity& regular) {
    return abs(regular.translation - drawn.translation) > already_regular * scale_of(drawn);
}

std::vector<Similarity> regular_poses(std::span<const PlacedCopy> copies, double diagonal) {
    std::vector<Similarity> regular;
    for (const PlacedCopy& copy : copies) regular.push_back(copy.pose);
    std::vector<Kind> kinds = kinds_of(copies);
    for (int level = 0; level < most_levels && !kinds.empty(); ++level) kinds = arranged(kinds, diagonal, regular);
    return regular;
}

std::optional<Instancing> regular_drawing(const Instancing& instancing, double diagonal) {
    std::vector<PlacedCopy> copies;
    std::vector<std::size_t> elements;
    for (std::size_t e = 0; e < instancing.instances.size(); ++e) {
        const Instance& instance = instancing.instances[e];
        const Look& look = instancing.looks[static_cast<std::size_t>(instance.look)];
        if (!look.verbatim.empty()) continue;
        copies.push_back({instance.look, instance.pose, &look.symmetry});
        elements.push_back(e);
    }
    const std::vector<Similarity> poses = regular_poses(copies, diagonal);
    Instancing regular = instancing;
    bool any = false;
    for (std::size_t c = 0; c < copies.size(); ++c) {
        regular.instances[elements[c]].pose = poses[c];
        any = any || stands_elsewhere(copies[c].pose, poses[c]);
    }
    return any ? std::optional(std::move(regular)) : std::nullopt;
}

}  // namespace rinceau
