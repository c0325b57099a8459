#include "analyzer/ring_arrangement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "analyzer/even_places.h"

namespace rinceau {

namespace {

constexpr std::size_t least_bodies = 4;
constexpr double clearly_apart = 0.3;  // spread over spacing, at most
constexpr double ring_bits = 4 * 14;   // centre, radius, phase
constexpr std::array split_shares{0.2, 0.35, 0.5, 0.7};  // of the spacing

struct Ring {
    std::vector<int> bodies;  // counter-clockwise
    Point centre;
    Complex first;  // centre to the place of the first body
};

/// Bodies by their direction from the centre; the circle that fits them evenly: with p_k = c + w exp(2 pi i k / n), c and w
/// are the first two Fourier coefficients of the places.
Ring fitted_ring(std::span<const Body> bodies, std::vector<int> members, Point about) {
    const auto place = [&](int b) { return bodies[static_cast<std::size_t>(b)].pose.translation; };
    std::ranges::sort(members, {}, [&](int b) { return std::pair{arg(place(b) - about), b}; });
    Ring ring;
    const auto n = static_cast<double>(members.size());
    for (std::size_t k = 0; k < members.size(); ++k) {
        ring.centre += place(members[k]) / n;
        ring.first += place(members[k]) * polar(1 / n, -two_pi * static_cast<double>(k) / n);
    }
    ring.bodies = std::move(members);
    return ring;
}

Point place_in(const Ring& ring, std::size_t k) {
    return ring.centre + ring.first * polar(1, two_pi * static_cast<double>(k) / static_cast<double>(ring.bodies.size()));
}

/// How the members of a ring stand: turned with it, each facing the centre as the others do, or all facing one way.
struct Heading {
    CommonLinear common;  ///< against the way from the centre to the member, or in the scene
    bool upright = false;
};

std::optional<Heading> heading_of(std::span<const Complex> turning, std::span<const Complex> upright, const BodyForm& form) {
    const auto with_ring = common_linear(turning, form);
    const auto one_way = form.fold > 0 ? common_linear(upright, form) : std::nullopt;
    if (one_way && (!with_ring || one_way->turned < with_ring->turned)) return Heading{*one_way, true};
    if (with_ring) return Heading{*with_ring, false};
    return std::nullopt;
}

/// The same ring beginning with the member whose place is nearest to the right of the centre, so that rings alike begin
/// alike.
Ring begun_at_right(Ring ring) {
    const auto n = static_cast<double>(ring.bodies.size());
    const int places = static_cast<int>(std::lround(-arg(ring.first) / two_pi * n));
    const auto size = static_cast<int>(ring.bodies.size());
    std::rotate(ring.bodies.begin(), ring.bodies.begin() + ((places % size) + size) % size, ring.bodies.end());
    ring.first = ring.first * polar(1, two_pi * places / n);
    return ring;
}

/// All members face one way: the ring's frame is that of the scene, turning it changes it.
Arrangement upright_ring(std::span<const Body> bodies, const Ring& given, const CommonLinear& common, double error,
                         Arrangement result) {
    constexpr int upright_mark = 3;
    Ring ring = begun_at_right(given);
    const auto n = static_cast<double>(ring.bodies.size());
    const double unit = pi / static_cast<double>(std::lcm(std::size_t{2}, ring.bodies.size()));
    ring.first = ring.first * polar(1, -off_natural(arg(ring.first), unit, error));
    const bool mirrored = bodies[static_cast<std::size_t>(ring.bodies.front())].pose.mirrored;
    for (std::size_t k = 0; k < ring.bodies.size(); ++k)
        result.slots.push_back({common.linear, Point(ring.first * polar(1, two_pi * static_cast<double>(k) / n)), mirrored});
    result.whole = {{1, 0}, ring.centre, false};
    result.signature = {upright_mark, static_cast<int>(ring.bodies.size())};
    result.bodies = std::move(ring.bodies);
    return result;
}

std::optional<Arrangement> arranged(std::span<const Body> bodies, const Ring& ring, const BodyForm& form, const ArrangementScale& scale) {
    const auto n = static_cast<double>(ring.bodies.size());
    const double radius = abs(ring.first);
    const double spacing = 2 * radius * std::sin(pi / n);
    std::vector<Complex> turning, upright;
    std::vector<Point> shifts;
    std::vector<std::pair<int, int>> neighbours;
    double radial = 0, tangential = 0;
    for (std::size_t k = 0; k < ring.bodies.size(); ++k) {
        const Similarity& pose = bodies[static_cast<std::size_t>(ring.bodies[k])].pose;
        const Complex outward = ring.first / radius * polar(1, two_pi * static_cast<double>(k) / n);
        const Point off = (pose.translation - place_in(ring, k)) / outward;
        radial += off.x * off.x / n;
        tangential += off.y * off.y / n;
        turning.push_back(pose.linear / outward);
        upright.push_back(pose.linear);
        shifts.push_back(off);
        neighbours.emplace_back(static_cast<int>(k), static_cast<int>((k + 1) % ring.bodies.size()));
    }
    const auto heading = heading_of(turning, upright, form);
    if (!heading) return std::nullopt;
    Arrangement result;
    result.spacing = spacing;
    result.spread = std::sqrt((radial + tangential) / 2);
    if (result.spread > scale.precision && is_smooth(shifts, neighbours)) return std::nullopt;
    if (!(result.spread <= clearly_apart * spacing)) return std::nullopt;
    double chance = (n - 3) * log2_hit(std::sqrt(radial), radius) + (n - 2) * log2_hit(std::sqrt(tangential), spacing);
    if (form.fold > 0) chance += (n - 1) * log2_hit(heading->common.turned, two_pi / form.fold);
    if (chance > arrangement_chance_bits) return std::nullopt;
    result.bits_saved = 2 * n * std::log2(scale.extent / scale.precision) - ring_bits -
                        2 * n * std::log2(1 + result.spread / scale.precision);
    result.turned = heading->common.turned;
    if (heading->upright)
        return upright_ring(bodies, ring, heading->common, result.spread / (std::sqrt(n) * radius), std::move(result));
    result.is_ring = true;
    result.bodies = ring.bodies;
    result.whole = {ring.first / radius, ring.centre, false};
    constexpr int ring_mark = 2;
    result.form.fold = static_cast<int>(ring.bodies.size());
    result.signature = {ring_mark, result.form.fold};
    const bool mirrored = bodies[static_cast<std::size_t>(ring.bodies.front())].pose.mirrored;
    for (std::size_t k = 0; k < ring.bodies.size(); ++k) {
        const Complex turned = polar(1, two_pi * static_cast<double>(k) / n);
        result.slots.push_back({heading->common.linear * turned, radius * turned, mirrored});
    }
    return result;
}

/// Bodies by their distance from the centre.
std::map<int, std::vector<int>> by_radius(std::span<const Body> bodies, std::span<const int> chosen, Point centre,
                                          double split) {
    std::vector<double> radii;
    for (const int b : chosen) radii.push_back(abs(bodies[static_cast<std::size_t>(b)].pose.translation - centre));
    const EvenPlaces crowds = even_places(radii, split, split);
    std::map<int, std::vector<int>> sorted;
    for (std::size_t i = 0; i < crowds.place_of.size(); ++i) sorted[crowds.place_of[i]].push_back(chosen[i]);
    return sorted;
}

/// All rings about one centre, or nothing if a body is in none.
std::vector<Arrangement> rings_about(std::span<const Body> bodies, std::span<const int> chosen, Point centre, double split,
                                     const BodyForm& form, const ArrangementScale& scale) {
    constexpr int rounds = 2;  // the centre, once more with what the first round has sorted
    for (int round = 0;; ++round) {
        std::vector<Ring> rings;
        Point mean{};
        for (auto& [unused, members] : by_radius(bodies, chosen, centre, split)) {
            if (members.size() < least_bodies) return {};
            const double weight = static_cast<double>(members.size()) / static_cast<double>(chosen.size());
            rings.push_back(fitted_ring(bodies, std::move(members), centre));
            mean += weight * rings.back().centre;
        }
        centre = mean;
        if (round + 1 < rounds) continue;
        std::vector<Arrangement> arrangements;
        for (Ring& ring : rings) {
            ring.centre = centre;
            auto arrangement = arranged(bodies, ring, form, scale);
            if (!arrangement) return {};
            arrangements.push_back(std::move(*arrangement));
        }
        return arrangements;
    }
}

}  // namespace

std::vector<Arrangement> arrange_in_rings(std::span<const Body> bodies, std::span<const int> chosen, const BodyForm& form,
                                          const ArrangementScale& scale) {
    if (chosen.size() < least_bodies) return {};
    std::vector<Point> places;
    Point middle{};
    for (const int b : chosen) {
        places.push_back(bodies[static_cast<std::size_t>(b)].pose.translation);
        middle += places.back() / static_cast<double>(chosen.size());
    }
    const double spacing = median_spacing(places);
    if (!(spacing > 0)) return {};
    std::vector<Arrangement> best;
    double best_bits = 0;
    for (const double share : split_shares) {
        auto rings = rings_about(bodies, chosen, middle, share * spacing, form, scale);
        double bits = 0;
        for (const Arrangement& ring : rings) bits += ring.bits_saved;
        if (bits > best_bits) {
            best = std::move(rings);
            best_bits = bits;
        }
    }
    return best;
}

}  // namespace rinceau
