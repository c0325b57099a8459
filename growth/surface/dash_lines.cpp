#include "growth/surface/dash_lines.h"

#include <cmath>
#include <numeric>

namespace rinceau {
namespace {

constexpr double most_dashes = 100'000;

/// Where in the pattern a line begins: which dash or gap, and what is left of it.
struct DashPlace {
    std::size_t index = 0;
    double rest = 0;
};

DashPlace place_in_pattern(const std::vector<double>& dashes, double period, double offset) {
    double along = std::fmod(offset, period);
    if (along < 0) along += period;
    DashPlace place{0, dashes[0]};
    while (along >= place.rest && place.index + 1 < dashes.size()) {
        along -= place.rest;
        place.rest = dashes[++place.index];
    }
    place.rest -= std::min(along, place.rest);
    return place;
}

/// Cuts one polyline.
void add_dashes(std::vector<Path>& cut, const std::vector<Point>& line, const std::vector<double>& dashes, DashPlace place) {
    Path dash{line.front(), {}, false};
    const auto is_drawn = [&] { return place.index % 2 == 0; };
    const auto finish = [&] {
        if (is_drawn() && !dash.segments.empty()) cut.push_back(dash);
        dash.segments.clear();
    };
    for (std::size_t k = 1; k < line.size(); ++k) {
        const double length = abs(line[k] - line[k - 1]);
        double done = 0;
        while (length - done > place.rest) {
            done += place.rest;
            const Point at = line[k - 1] + (done / length) * (line[k] - line[k - 1]);
            if (is_drawn()) dash.segments.push_back(line_to(at));
            finish();
            dash.start = at;
            place.index = (place.index + 1) % dashes.size();
            place.rest = dashes[place.index];
        }
        place.rest -= length - done;
        if (is_drawn()) dash.segments.push_back(line_to(line[k]));
    }
    finish();
}

}  // namespace

std::vector<Path> dash_lines(const std::vector<Path>& paths, const Stroke& stroke, double deviation) {
    const double period = std::accumulate(stroke.dashes.begin(), stroke.dashes.end(), 0.0);
    if (!(period > 0) || static_cast<double>(stroke.dashes.size()) * length(paths) > most_dashes * period) return paths;
    std::vector<Path> cut;
    for (const Path& path : paths) {
        std::vector<Point> line = flattened(path, deviation);
        if (path.closed) line.push_back(line.front());
        add_dashes(cut, line, stroke.dashes, place_in_pattern(stroke.dashes, period, stroke.dash_offset));
    }
    return cut;
}

}  // namespace rinceau
