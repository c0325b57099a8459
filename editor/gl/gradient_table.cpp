#include "editor/gl/gradient_table.h"

#include <algorithm>
#include <cmath>

namespace rinceau {
namespace {

constexpr double full = 255;

std::uint8_t byte(double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, full))); }

std::array<std::uint8_t, 4> stop_color(const GradientStop& stop) {
    return {stop.color.red, stop.color.green, stop.color.blue, byte(full * stop.opacity)};
}

std::array<std::uint8_t, 4> mixed(const GradientStop& a, const GradientStop& b, double t) {
    const auto mix = [t](double x, double y) { return byte(x + t * (y - x)); };
    return {mix(a.color.red, b.color.red), mix(a.color.green, b.color.green), mix(a.color.blue, b.color.blue),
            mix(full * a.opacity, full * b.opacity)};
}

std::array<std::uint8_t, 4> color_at(const std::vector<GradientStop>& stops, double t) {
    // Of stops at one place the last one counts to its right.
    const auto after = std::ranges::upper_bound(stops, t, {}, &GradientStop::offset);
    if (after == stops.begin()) return stop_color(stops.front());
    if (after == stops.end()) return stop_color(stops.back());
    const GradientStop& before = *std::prev(after);
    return mixed(before, *after, (t - before.offset) / (after->offset - before.offset));
}

}  // namespace

GradientRamp gradient_ramp(const std::vector<GradientStop>& stops) {
    GradientRamp ramp{};
    if (stops.empty()) return ramp;
    ramp.front() = stop_color(stops.front());
    ramp.back() = stop_color(stops.back());
    for (int k = 0; k < ramp_colors; ++k)
        ramp[static_cast<std::size_t>(k) + 1] = color_at(stops, static_cast<double>(k) / (ramp_colors - 1));
    return ramp;
}

int GradientTable::ramp(const std::vector<GradientStop>& stops) {
    StopKey key;
    for (const GradientStop& stop : stops) {
        key.push_back(stop.offset);
        key.push_back(stop.opacity);
        for (const std::uint8_t channel : {stop.color.red, stop.color.green, stop.color.blue}) key.push_back(channel);
    }
    const auto known = ramp_numbers_.find(key);
    if (known != ramp_numbers_.end()) return known->second;
    if (ramps_.size() == most_ramps) {
        overflows_ = true;
        return static_cast<int>(most_ramps) - 1;
    }
    const int row = static_cast<int>(ramps_.size());
    ramps_.push_back(gradient_ramp(stops));
    ramp_numbers_.emplace(std::move(key), row);
    return row;
}

std::uint32_t GradientTable::number(const Gradient& gradient) {
    const int row = ramp(gradient.stops);
    const bool radial = gradient.kind == GradientKind::radial;
    const std::array<double, 6> key{static_cast<double>(row),
                                    radial ? 1.0 : 0.0,
                                    static_cast<double>(gradient.spread),
                                    radial ? gradient.focus.x : 0,
                                    radial ? gradient.focus.y : 0,
                                    radial ? gradient.focal_radius : 0};
    const auto [place, is_new] = entry_numbers_.try_emplace(key, static_cast<std::uint32_t>(entries_.size()) + 1);
    if (is_new) entries_.push_back({row, gradient.kind, gradient.spread, gradient.focus, gradient.focal_radius});
    return place->second;
}

}  // namespace rinceau
