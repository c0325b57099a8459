// Steps that many points have in common are found by their votes (mean shift over the offsets to near points). Two of them
// whose cell has the area of a point make a basis; from the middle outward points get the nearest places, and the lattice is
// fitted again to what has one (least squares). What is accepted is strict, because growth on a lattice looks at nothing
// else.

#include "growth/arrangement/lattice_index.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "geometry/box.h"
#include "geometry/kd_tree.h"

namespace rinceau {
namespace {

using Site = std::array<int, 2>;

Site operator+(Site a, Site b) { return {a[0] + b[0], a[1] + b[1]}; }

/// position = origin + u basis[0] + v basis[1].
struct LatticeFrame {
    Point origin;
    std::array<Point, 2> basis;

    Point at(Site site) const {
        return origin + static_cast<double>(site[0]) * basis[0] + static_cast<double>(site[1]) * basis[1];
    }
    /// Column and row as real numbers.
    Point coordinates(Point p) const {
        const Point d = p - origin;
        const double cell = cross(basis[0], basis[1]);
        return {cross(d, basis[1]) / cell, cross(basis[0], d) / cell};
    }
};

bool upper_half(Point p) { return p.y > 0 || (p.y == 0 && p.x > 0); }

/// Offsets to the nearest points, each pair once, turned to the upper half plane.
std::vector<Point> near_offsets(std::span<const Point> points, double reach) {
    constexpr std::size_t most_points = 400;  // votes of more tell nothing new
    const KdTree tree(points);
    const std::size_t step = std::max<std::size_t>(1, points.size() / most_points);
    std::vector<Point> offsets;
    for (std::size_t i = 0; i < points.size(); i += step)
        for (const Neighbor& other : tree.within(points[i], reach)) {
            if (other.index == i) continue;
            const Point offset = points[other.index] - points[i];
            offsets.push_back(upper_half(offset) ? offset : -offset);
        }
    return offsets;
}

struct StepVote {
    Point step;
    std::size_t votes = 0;
};

/// Mean of the offsets near a step, opposite ones turned round.
StepVote mean_near(const std::vector<Point>& offsets, Point step, double bandwidth) {
    StepVote mean;
    for (const Point offset : offsets)
        for (const Point candidate : {offset, -offset})
            if (abs(candidate - step) <= bandwidth) {
                mean.step += candidate;
                ++mean.votes;
            }
    if (mean.votes > 0) mean.step = mean.step / static_cast<double>(mean.votes);
    return mean;
}

/// Where offsets gather, most votes first.
std::vector<StepVote> voted_steps(const std::vector<Point>& offsets, double bandwidth) {
    constexpr int shifts = 8;
    constexpr std::size_t most_starts = 300;
    std::vector<StepVote> steps;
    const std::size_t stride = std::max<std::size_t>(1, offsets.size() / most_starts);
    for (std::size_t i = 0; i < offsets.size(); i += stride) {
        StepVote vote{offsets[i], 0};
        for (int shift = 0; shift < shifts; ++shift) vote = mean_near(offsets, vote.step, bandwidth);
        const auto same = [&](const StepVote& other) {
            return std::min(abs(other.step - vote.step), abs(other.step + vote.step)) < bandwidth;
        };
        const auto known = std::ranges::find_if(steps, same);
        if (known == steps.end())
            steps.push_back(vote);
        else if (vote.votes > known->votes)
            *known = vote;
    }
    std::ranges::stable_sort(steps, std::greater{}, &StepVote::votes);
    return steps;
}

/// Shortest pair of steps of the same lattice (Gauss), the second counter-clockwise of the first.
std::array<Point, 2> reduced(Point a, Point b) {
    constexpr int most_rounds = 64;
    for (int round = 0; round < most_rounds; ++round) {
        if (norm(b) < norm(a)) std::swap(a, b);
        const double times = std::round(dot(a, b) / norm(a));
        if (times == 0) break;
        b -= times * a;
    }
    // one of the ways to say it: the first step to the right, the second upward from it
    if (a.x < 0 || (a.x == 0 && a.y < 0)) a = -a;
    if (cross(a, b) < 0) b = -b;
    return {a, b};
}

/// Least squares of the frame over the points that have a place; nothing if these lie on a line.
std::optional<LatticeFrame> fitted(std::span<const Point> points, const std::vector<std::optional<Site>>& index) {
    double n = 0;
    Point site_mean;
    Point point_mean;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!index[i]) continue;
        n += 1;
        site_mean += Point{static_cast<double>((*index[i])[0]), static_cast<double>((*index[i])[1])};
        point_mean += points[i];
    }
    if (n == 0) return {};
    site_mean = site_mean / n;
    point_mean = point_mean / n;
    double uu = 0;
    double uv = 0;
    double vv = 0;
    Point by_u;
    Point by_v;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!index[i]) continue;
        const Point s = Point{static_cast<double>((*index[i])[0]), static_cast<double>((*index[i])[1])} - site_mean;
        const Point p = points[i] - point_mean;
        uu += s.x * s.x;
        uv += s.x * s.y;
        vv += s.y * s.y;
        by_u += s.x * p;
        by_v += s.y * p;
    }
    const double determinant = uu * vv - uv * uv;
    if (!(determinant > 1e-9 * (uu + vv) * (uu + vv))) return {};
    LatticeFrame frame;
    frame.basis = {(vv * by_u - uv * by_v) / determinant, (uu * by_v - uv * by_u) / determinant};
    frame.origin = point_mean - site_mean.x * frame.basis[0] - site_mean.y * frame.basis[1];
    return frame;
}

struct IndexedPoints {
    LatticeFrame frame;
    std::vector<std::optional<Site>> index;
    double deviation = 1;  ///< root mean square in steps, of columns or rows, whichever is larger
};

/// Nearest places of the points within `reach` of the start; of two points at one place the nearer has it.
IndexedPoints indexed(std::span<const Point> points, const LatticeFrame& frame, Point start, double reach) {
    IndexedPoints result{.frame = frame, .index = std::vector<std::optional<Site>>(points.size())};
    std::map<Site, std::size_t> taken;
    const auto off = [&](std::size_t i, Site site) { return norm(points[i] - frame.at(site)); };
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (abs(points[i] - start) > reach) continue;
        const Point c = frame.coordinates(points[i]);
        const Site site{static_cast<int>(std::lround(c.x)), static_cast<int>(std::lround(c.y))};
        const auto [place, is_new] = taken.try_emplace(site, i);
        if (!is_new && off(i, site) >= off(place->second, site)) continue;
        if (!is_new) result.index[place->second].reset();
        place->second = i;
        result.index[i] = site;
    }
    double columns = 0;
    double rows = 0;
    for (const auto& [site, i] : taken) {
        const Point c = frame.coordinates(points[i]);
        columns += (c.x - site[0]) * (c.x - site[0]);
        rows += (c.y - site[1]) * (c.y - site[1]);
    }
    result.deviation = std::sqrt(std::max(columns, rows) / static_cast<double>(std::max<std::size_t>(1, taken.size())));
    return result;
}

/// From the point nearest to the middle outward, ever further, with a frame that is fitted anew each time.
std::optional<IndexedPoints> grown_index(std::span<const Point> points, const std::array<Point, 2>& basis) {
    Box box;
    for (const Point p : points) box = including(box, p);
    const Point start = *std::ranges::min_element(points, {}, [&](Point p) { return norm(p - center(box)); });
    LatticeFrame frame{start, basis};
    const double whole = diagonal(box);
    constexpr double first_reach = 1.6;  // of the longer step: the first ring
    constexpr double further = 1.4;
    for (double reach = first_reach * std::max(abs(basis[0]), abs(basis[1]));; reach *= further) {
        const IndexedPoints now = indexed(points, frame, start, reach);
        const auto better = fitted(points, now.index);
        if (!better || !(cross(better->basis[0], better->basis[1]) > 0)) return {};
        frame = *better;
        if (reach > whole) break;
    }
    return indexed(points, frame, start, whole);
}

/// Root mean square of columns or rows, in steps, that chance does not reach. Evenly spread points deviate by 0.29 steps, a
/// fifth of jitter makes 0.1 to 0.14; the fewer points, the nearer to them a lattice can be laid that is not there.
double widest_deviation(std::size_t free) {
    struct Limit {
        std::size_t points;
        double deviation;
    };
    // scattered points gave no less than 0.128 for 14, 0.146 for 15 and 0.148 for 20 to 23 (300 random patterns)
    for (const Limit& limit : {Limit{16, 0.1}, {30, 0.14}, {50, 0.16}})
        if (free < limit.points) return limit.deviation;
    return 0.17;
}

/// Is every point there, at a place of its own, and hardly any place empty?
bool is_certain(const IndexedPoints& found, std::size_t free) {
    std::set<Site> sites;
    for (const auto& site : found.index)
        if (site) sites.insert(*site);
    constexpr double nearly_all = 0.95;
    constexpr std::size_t fewest = 9;
    if (sites.size() < fewest || static_cast<double>(sites.size()) < nearly_all * static_cast<double>(found.index.size()))
        return false;
    if (found.deviation > widest_deviation(free)) return false;
    std::set<int> columns;
    std::set<int> rows;
    std::map<Site, int> neighbors_of_empty;
    for (const Site site : sites) {
        columns.insert(site[0]);
        rows.insert(site[1]);
        for (const Site step : {Site{1, 0}, Site{0, 1}, Site{-1, 0}, Site{0, -1}})
            if (!sites.contains(site + step)) ++neighbors_of_empty[site + step];
    }
    constexpr std::size_t fewest_lines = 3;
    if (columns.size() < fewest_lines || rows.size() < fewest_lines) return false;
    constexpr int enclosed = 3;  // of four neighbours
    const auto holes = std::ranges::count_if(neighbors_of_empty, [](const auto& n) { return n.second >= enclosed; });
    return static_cast<double>(holes) <= (1 - nearly_all) * static_cast<double>(sites.size());
}

/// Steps and faces of the exact lattice with this basis.
void add_neighbors(PointLattice& lattice) {
    constexpr int around = 4;  // columns and rows about the middle: beyond them the rim begins
    constexpr double tie = 0.25;
    std::vector<Site> sites;
    std::vector<Point> points;
    for (int v = -around; v <= around; ++v)
        for (int u = -around; u <= around; ++u) {
            sites.push_back({u, v});
            points.push_back(static_cast<double>(u) * lattice.basis[0] + static_cast<double>(v) * lattice.basis[1]);
        }
    const std::size_t middle = sites.size() / 2;
    const Connectivity connectivity = connectivity_of(points, {.tie = tie});
    for (const int other : connectivity.rings[middle]) lattice.steps.push_back(sites[static_cast<std::size_t>(other)]);
    for (const auto& face : connectivity.faces) {
        if (face.front() != static_cast<int>(middle)) continue;
        auto& corners = lattice.faces.emplace_back();
        for (const int corner : face) corners.push_back(sites[static_cast<std::size_t>(corner)]);
    }
}

/// The same places counted in the shortest steps.
PointLattice in_short_steps(std::span<const Point> points, const IndexedPoints& found) {
    PointLattice lattice{
        .index = found.index, .origin = found.frame.origin, .basis = reduced(found.frame.basis[0], found.frame.basis[1])};
    const LatticeFrame frame{lattice.origin, lattice.basis};
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!lattice.index[i]) continue;
        const Point c = frame.coordinates(found.frame.at(*lattice.index[i]));
        lattice.index[i] = {static_cast<int>(std::lround(c.x)), static_cast<int>(std::lround(c.y))};
    }
    add_neighbors(lattice);
    return lattice;
}

}  // namespace

std::optional<PointLattice> find_lattice(std::span<const Point> points, double spacing, std::size_t free) {
    constexpr std::size_t fewest = 9;
    if (points.size() < fewest || !(spacing > 0)) return {};
    constexpr double reach = 2.5;       // of the spacing: long enough for the second step of a narrow lattice
    constexpr double bandwidth = 0.35;  // of the spacing: half of what jitter of a fifth scatters over
    std::vector<StepVote> steps = voted_steps(near_offsets(points, reach * spacing), bandwidth * spacing);
    constexpr std::size_t most_steps = 10;
    if (steps.size() > most_steps) steps.resize(most_steps);
    constexpr double alike = 0.25;  // share by which a cell may differ from the area of a point
    std::optional<IndexedPoints> best;
    for (std::size_t i = 0; i < steps.size(); ++i)
        for (std::size_t j = i + 1; j < steps.size(); ++j) {
            const double cell = std::abs(cross(steps[i].step, steps[j].step)) / (spacing * spacing);
            if (std::abs(cell - 1) > alike) continue;
            const auto found = grown_index(points, reduced(steps[i].step, steps[j].step));
            if (found && is_certain(*found, free) && (!best || found->deviation < best->deviation)) best = found;
        }
    if (!best) return {};
    return in_short_steps(points, *best);
}

Connectivity lattice_connectivity(std::span<const Point> points, const PointLattice& lattice) {
    std::map<Site, int> point_at;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (lattice.index[i]) point_at.try_emplace(*lattice.index[i], static_cast<int>(i));
    std::vector<std::vector<int>> faces;
    for (const auto& [site, first] : point_at)
        for (const auto& corners : lattice.faces) {
            std::vector<int> face;
            for (const Site corner : corners)
                if (const auto found = point_at.find(site + corner); found != point_at.end()) face.push_back(found->second);
            if (face.size() == corners.size()) faces.push_back(std::move(face));
        }
    return connectivity_from_faces(points, std::move(faces));
}

}  // namespace rinceau
