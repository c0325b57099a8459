#include "analyzer/open_with_spirals.h"

#include <algorithm>
#include <cmath>

#include "analyzer/fit_spiral.h"
#include "analyzer/join_items.h"
#include "analyzer/regauge.h"

namespace rinceau {

namespace {

constexpr double most_turn = 0.05;        // radians: members hold their bearing this well
constexpr double most_size_error = 0.05;  // of a member's size against the law of sizes
constexpr double place_slack = 2e-5;      // of the diagonal: what round numbers may cost

struct SizeFit {
    double size = 0, change = 0, power = 0, error = 0;  // error: largest, relative
};

/// Least squares for size + change * index^power.
SizeFit sizes_of_power(const std::vector<double>& indices, const std::vector<double>& sizes, double power) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
        const double x = std::pow(indices[k], power);
        n += 1;
        sx += x;
        sy += sizes[k];
        sxx += x * x;
        sxy += x * sizes[k];
    }
    const double spread = n * sxx - sx * sx;
    SizeFit fit;
    fit.power = power;
    fit.change = spread > 0 ? (n * sxy - sx * sy) / spread : 0;
    fit.size = (sy - fit.change * sx) / n;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
        const double wanted = fit.size + fit.change * std::pow(indices[k], power);
        fit.error = std::max(fit.error, std::abs(wanted - sizes[k]) / sizes[k]);
    }
    return fit;
}

/// The simplest of a constant, the law of the distances and other powers that is hardly worse than the best.
SizeFit fit_sizes(const std::vector<double>& indices, const std::vector<double>& sizes, double power, double slack) {
    SizeFit constant = sizes_of_power(indices, sizes, power);
    constant.size = 0;
    for (const double size : sizes) constant.size += size / static_cast<double>(sizes.size());
    constant.change = constant.error = 0;
    for (const double size : sizes) constant.error = std::max(constant.error, std::abs(constant.size - size) / size);
    std::vector<SizeFit> fits{constant};
    for (const double p : {power, 1.0, 0.5, 2.0, 1.0 / 3}) fits.push_back(sizes_of_power(indices, sizes, p));
    const double least = std::ranges::min_element(fits, {}, &SizeFit::error)->error;
    return *std::ranges::find_if(fits, [&](const SizeFit& fit) { return fit.error <= 2 * least + slack; });
}

/// The members' frames with the bearing that they share, turning with their radius or upright; false if they share none.
bool hold_bearing(const SearchState& state, const Part& part, const std::vector<int>& items, const SpiralFit& fit,
                  SpiralLaw& law, std::vector<Similarity>& frames) {
    const double pivot_turn = arg(fit.pivot.linear);
    const Similarity& first = state.item(items.front()).pose;
    for (const bool upright : {false, true}) {
        for (const Similarity& gauge : part.symmetry.elements) {
            const Similarity start = first * gauge;
            if (start.mirrored) continue;
            const double turn = upright ? 0 : law.angle;
            const double bearing = arg(start.linear) - pivot_turn - turn * spiral_index(law, 0);
            frames.clear();
            double error = 0, excess = 0;
            for (std::size_t k = 0; k < items.size(); ++k) {
                const double wanted = pivot_turn + bearing + turn * spiral_index(law, static_cast<int>(k));
                const Similarity& pose = state.item(items[k]).pose;
                frames.push_back(nearest_pose(part, pose, {polar(scale_of(pose), wanted), {}, false}));
                const double miss = wrap_angle(arg(frames.back().linear) - wanted);
                error = frames.back().mirrored ? pi : std::max(error, std::abs(miss));
                excess += miss / static_cast<double>(items.size());
                if (error > most_turn) break;
            }
            if (error > most_turn) continue;
            law.upright = upright;
            law.bearing = part.symmetry.continuous ? 0 : wrap_angle(bearing + excess);
            return true;
        }
    }
    return false;
}

/// The fit with the members' origins apart from their places, where that explains most of what is left.
SpiralFit seated(const SpiralFit& fit, const std::vector<Point>& points, const std::vector<Similarity>& frames, double slack) {
    constexpr double worth_it = 0.5;
    std::vector<Complex> linear;
    linear.reserve(frames.size());
    for (const Similarity& frame : frames) linear.push_back(frame.linear);
    SpiralFit better = fit_seats(points, linear, fit, slack);
    return better.worst < worth_it * fit.worst ? better : fit;
}

/// Makes the part's spiral an item, if it has one.
bool gather_spiral(SearchState& state, int p) {
    const std::vector<int> living = state.alive(p);
    std::vector<Point> points;
    points.reserve(living.size());
    for (const int i : living) points.push_back(state.item(i).pose.translation);
    const double slack = place_slack * state.diagonal;
    std::optional<SpiralFit> fit = fit_spiral(points, slack);
    if (!fit) return false;
    std::vector<int> items;
    std::vector<double> indices, sizes;
    for (const int k : fit->order) {
        indices.push_back(spiral_index(fit->law, static_cast<int>(items.size())));
        items.push_back(living[static_cast<std::size_t>(k)]);
        sizes.push_back(scale_of(state.item(items.back()).pose));
    }
    const SizeFit size = fit_sizes(indices, sizes, fit->law.power, 0.1 * state.tolerance.size);
    if (size.error > most_size_error) return false;
    Rule rule;
    rule.kind = RuleKind::spiral;
    rule.repeated = p;
    std::vector<Similarity> frames;
    SpiralLaw& law = rule.spiral;
    law = fit->law;
    if (!hold_bearing(state, state.part(p), items, *fit, law, frames)) return false;
    if (!state.part(p).symmetry.continuous && !law.upright && fit->worst > slack) {
        fit = seated(*fit, points, frames, slack);
        law = fit->law;
        if (!hold_bearing(state, state.part(p), items, *fit, law, frames)) return false;
    }
    law.size = size.size;
    law.size_change = size.change;
    law.size_power = size.power;
    state.rules.rules.push_back(rule);
    join_items(state, static_cast<int>(state.rules.rules.size()) - 1, items, frames);
    return true;
}

}  // namespace

std::optional<SearchState> open_with_spirals(const SearchState& start) {
    std::optional<SearchState> opened;
    std::vector<int> touched;
    const auto parts = static_cast<int>(start.members.size());
    for (int p = 0; p < parts; ++p) {
        constexpr std::size_t fewest = 16;
        if (start.alive(p).size() < fewest) continue;
        if (!opened) {
            SearchState trial = start;
            if (!gather_spiral(trial, p)) continue;
            opened = std::move(trial);
        } else if (!gather_spiral(*opened, p)) {
            continue;
        }
        touched.push_back(p);
        touched.push_back(static_cast<int>(opened->rules.parts.size()) - 1);
    }
    if (opened) refresh(*opened, touched);
    return opened;
}

}  // namespace rinceau
