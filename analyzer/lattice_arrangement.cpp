#include "analyzer/lattice_arrangement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "analyzer/even_places.h"
#include "geometry/kd_tree.h"

namespace rinceau {

namespace {

constexpr std::size_t least_bodies = 4;
constexpr double least_occupancy = 0.45;  // staggered rows fill every other crossing
constexpr double clearly_apart = 0.3;     // spread over gap, at most
constexpr double hole_bits = 6;
constexpr std::array split_shares{0.2, 0.35, 0.5, 0.7};  // of the spacing

/// Directions of lines worth trying: the axes, and what most neighbours say modulo a right angle.
std::vector<double> line_directions(const std::vector<Point>& places) {
    constexpr double clear_share = 0.35;      // mean resultant length
    const double same_as_axes = radians(4);
    const KdTree tree(places);
    Complex sum{};
    double count = 0;
    for (const Point p : places) {
        for (const Neighbor& near : tree.nearest(p, 5)) {
            const Point way = places[near.index] - p;
            if (near.distance <= 0) continue;
            sum += polar(1, 4 * arg(way));
            ++count;
        }
    }
    std::vector<double> directions{0};
    const double turned = arg(sum) / 4;
    if (abs(sum) > clear_share * count && std::abs(turned) > same_as_axes) directions.push_back(turned);
    return directions;
}

struct Table {
    EvenPlaces columns, rows;
    double direction = 0;
    double bits = HUGE_VAL;
};

bool is_table(const EvenPlaces& columns, const EvenPlaces& rows) {
    const double crossings = static_cast<double>(columns.places.size()) * static_cast<double>(rows.places.size());
    const auto n = static_cast<double>(columns.place_of.size());
    if (n < least_occupancy * crossings) return false;
    for (const EvenPlaces* lines : {&columns, &rows}) {
        if (lines->places.size() > 1 && lines->spread > clearly_apart * lines->least_gap) return false;
    }
    // A single line is one only if what stands on it is farther apart than it is thick.
    const double apart = std::max(columns.least_gap, rows.least_gap);
    if (std::max(columns.spread, rows.spread) > clearly_apart * apart) return false;
    if (columns.chance_bits + rows.chance_bits > arrangement_chance_bits) return false;
    std::set<std::pair<int, int>> taken;
    for (std::size_t i = 0; i < columns.place_of.size(); ++i) {
        if (!taken.insert({columns.place_of[i], rows.place_of[i]}).second) return false;
    }
    return true;
}

Table best_table(const std::vector<Point>& places, double direction, double precision) {
    std::vector<double> across, up;
    for (const Point p : places) {
        const Point turned = p * polar(1, -direction);
        across.push_back(turned.x);
        up.push_back(turned.y);
    }
    const double spacing = median_spacing(places);
    std::vector<EvenPlaces> columns, rows;
    for (const double share : split_shares) {
        columns.push_back(even_places(across, share * spacing, precision));
        rows.push_back(even_places(up, share * spacing, precision));
    }
    Table best;
    for (const EvenPlaces& c : columns) {
        for (const EvenPlaces& r : rows) {
            const auto crossings = static_cast<double>(c.places.size() * r.places.size());
            const double bits = c.bits + r.bits + hole_bits * std::max(0.0, crossings - static_cast<double>(places.size()));
            if (bits < best.bits && is_table(c, r)) best = {c, r, direction, bits};
        }
    }
    return best;
}

std::vector<int> signature_of(const Table& table, const std::vector<int>& cells) {
    constexpr int lattice_mark = 1;
    std::vector<int> signature{lattice_mark, static_cast<int>(table.columns.places.size()),
                               static_cast<int>(table.rows.places.size())};
    signature.insert(signature.end(), table.columns.gap_classes.begin(), table.columns.gap_classes.end());
    signature.insert(signature.end(), table.rows.gap_classes.begin(), table.rows.gap_classes.end());
    signature.insert(signature.end(), cells.begin(), cells.end());
    return signature;
}

Arrangement arrangement_of(const Table& table, std::span<const Body> bodies, std::span<const int> chosen, Complex linear) {
    Arrangement result;
    // In order of the cells, so that arrangements of one form list their bodies alike.
    std::vector<std::pair<int, std::size_t>> order;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const int width = static_cast<int>(table.columns.places.size());
        order.emplace_back(table.rows.place_of[i] * width + table.columns.place_of[i], i);
    }
    std::ranges::sort(order);
    Point middle{};
    std::vector<Point> places;
    for (const auto& [cell, i] : order) {
        const Point along{table.columns.places[static_cast<std::size_t>(table.columns.place_of[i])],
                          table.rows.places[static_cast<std::size_t>(table.rows.place_of[i])]};
        places.push_back(along);
        middle += along / static_cast<double>(order.size());
    }
    const Complex turn = polar(1, table.direction);
    result.whole = {turn, middle * turn, false};
    std::vector<int> cells;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const int body = chosen[order[k].second];
        result.bodies.push_back(body);
        const Similarity pose{linear, places[k] * turn, bodies[static_cast<std::size_t>(body)].pose.mirrored};
        result.slots.push_back(inverse(result.whole) * pose);
        cells.push_back(order[k].first);
    }
    result.signature = signature_of(table, cells);
    result.spread = std::sqrt((table.columns.spread * table.columns.spread + table.rows.spread * table.rows.spread) / 2);
    for (const double gap : {table.columns.least_gap, table.rows.least_gap}) {
        if (gap > 0) result.spacing = result.spacing > 0 ? std::min(result.spacing, gap) : gap;
    }
    return result;
}

/// Slots that follow each other in a row or in a column.
std::vector<std::pair<int, int>> neighbours_in(const Table& table, const Arrangement& arrangement, std::span<const int> chosen) {
    std::map<int, std::size_t> index;
    for (std::size_t i = 0; i < chosen.size(); ++i) index[chosen[i]] = i;
    std::map<std::pair<int, int>, int> by_row, by_column;
    for (std::size_t k = 0; k < arrangement.bodies.size(); ++k) {
        const std::size_t i = index[arrangement.bodies[k]];
        by_row[{table.rows.place_of[i], table.columns.place_of[i]}] = static_cast<int>(k);
        by_column[{table.columns.place_of[i], table.rows.place_of[i]}] = static_cast<int>(k);
    }
    std::vector<std::pair<int, int>> neighbours;
    for (const auto* lines : {&by_row, &by_column}) {
        for (auto here = lines->begin(), next = here; here != lines->end() && ++next != lines->end(); here = next) {
            if (here->first.first == next->first.first) neighbours.emplace_back(here->second, next->second);
        }
    }
    return neighbours;
}

/// Do places or directions change smoothly along rows and columns, by more than rounding?
bool follows_a_curve(const Arrangement& arrangement, std::span<const Body> bodies, const BodyForm& form,
                     std::span<const std::pair<int, int>> neighbours, double precision) {
    constexpr double least_turn = 0.002;  // radians
    std::vector<Point> shifts, turns;
    for (std::size_t k = 0; k < arrangement.bodies.size(); ++k) {
        const Similarity& drawn = bodies[static_cast<std::size_t>(arrangement.bodies[k])].pose;
        const Similarity meant = arrangement.whole * arrangement.slots[k];
        shifts.push_back(drawn.translation - meant.translation);
        turns.push_back({wrap_angle(form.fold * arg(drawn.linear / meant.linear)), 0});
    }
    return (arrangement.spread > precision && is_smooth(shifts, neighbours)) ||
           (arrangement.turned > least_turn && is_smooth(turns, neighbours));
}

}  // namespace

std::optional<Arrangement> arrange_in_lattice(std::span<const Body> bodies, std::span<const int> chosen, const BodyForm& form,
                                              const ArrangementScale& scale) {
    if (chosen.size() < least_bodies) return std::nullopt;
    std::vector<Complex> linears;
    std::vector<Point> places;
    for (const int b : chosen) {
        linears.push_back(bodies[static_cast<std::size_t>(b)].pose.linear);
        places.push_back(bodies[static_cast<std::size_t>(b)].pose.translation);
    }
    const auto linear = common_linear(linears, form);
    if (!linear) return std::nullopt;
    Table best;
    for (const double direction : line_directions(places)) {
        Table table = best_table(places, direction, scale.precision);
        if (table.bits < best.bits) best = std::move(table);
    }
    const double flat = 2 * static_cast<double>(chosen.size()) * std::log2(scale.extent / scale.precision);
    if (!(best.bits < flat)) return std::nullopt;
    Arrangement result = arrangement_of(best, bodies, chosen, linear->linear);
    result.turned = linear->turned;
    if (follows_a_curve(result, bodies, form, neighbours_in(best, result, chosen), scale.precision)) return std::nullopt;
    result.bits_saved = flat - best.bits;
    return result;
}

}  // namespace rinceau
