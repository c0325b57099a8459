#include "analyzer/spaces_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>
#include <tuple>

#include "geometry/angle.h"
#include "scene/svg_number.h"

namespace rinceau {

namespace {

constexpr int digits = 9;  // of printed numbers: more are rounding

std::string text(double number) { return svg_number(number, digits); }

const std::string& name_of(const std::vector<std::string>& names, int look) { return names[static_cast<std::size_t>(look)]; }

// Pictures: lengths in px.
constexpr double plot_width = 320;
constexpr double plot_height = 200;
constexpr double margin = 40;
constexpr double row_height = plot_height + 2 * margin;
constexpr double page_width = 2 * plot_width + 3 * margin;

/// Colours that are far apart for the ten largest clusters; grey for the rest.
std::string cluster_color(int cluster) {
    constexpr std::array<const char*, 10> colors = {"#1b6ca8", "#d1495b", "#2a9d55", "#e09f3e", "#7b4fa3",
                                                    "#00a6a6", "#a0522d", "#e377c2", "#6b8e23", "#334155"};
    return cluster < static_cast<int>(colors.size()) ? colors[static_cast<std::size_t>(cluster)] : "#b8bcc2";
}

std::string escaped(const std::string& plain) {
    std::string result;
    for (const char c : plain) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else
            result += c;
    }
    return result;
}

std::string label(double x, double y, const char* anchor, const std::string& content) {
    return "<text x=\"" + text(x) + "\" y=\"" + text(y) + "\" text-anchor=\"" + anchor + "\">" + escaped(content) +
           "</text>\n";
}

/// A range of values on a side of a plot.
struct Axis {
    double low = 0, high = 1;
    double share(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

Axis axis_of(const std::vector<double>& values) {
    constexpr double air = 0.05;  // of the range, on both ends
    const auto [low, high] = std::ranges::minmax(values);
    const double range = high > low ? high - low : std::max(1.0, std::abs(high));
    return {low - air * range, high + air * range};
}

/// One scatter plot: angles (radians) from -180 to 180 degrees along x, `values` along y.
struct Plot {
    std::string angle_name, value_name;
    std::vector<double> angles, values;
    bool log_values = false;  ///< values are logarithms; ticks print their exponentials
};

std::string draw(const Plot& plot, const ClusteredSpace& clustered, double left, double top) {
    const Axis across{-pi, pi};
    const Axis up = axis_of(plot.values);
    const auto printed = [&](double value) { return svg_number(plot.log_values ? std::exp(value) : value, 3); };
    std::string svg = "<rect x=\"" + text(left) + "\" y=\"" + text(top) + "\" width=\"" + text(plot_width) + "\" height=\"" +
                      text(plot_height) + "\" fill=\"none\" stroke=\"#888\"/>\n";
    svg += label(left, top + plot_height + 14, "middle", "-180");
    svg += label(left + plot_width / 2, top + plot_height + 14, "middle", plot.angle_name + " [degrees]");
    svg += label(left + plot_width, top + plot_height + 14, "middle", "180");
    svg += label(left - 4, top + plot_height, "end", printed(up.low));
    svg += label(left - 4, top + plot_height / 2, "end", plot.value_name);
    svg += label(left - 4, top + 10, "end", printed(up.high));
    std::set<std::tuple<long, long, int, bool>> drawn;  // equal dots once, to a tenth of a pixel
    for (std::size_t i = 0; i < plot.angles.size(); ++i) {
        const double x = left + plot_width * across.share(plot.angles[i]);
        const double y = top + plot_height * (1 - up.share(plot.values[i]));
        const int cluster = clustered.clusters.cluster_of[i];
        const bool mirrored = clustered.space.points[i].mirrored;
        if (!drawn.emplace(std::lround(10 * x), std::lround(10 * y), cluster, mirrored).second) continue;
        const std::string color = cluster_color(cluster);
        svg += "<circle cx=\"" + svg_number(x, 6) + "\" cy=\"" + svg_number(y, 6) + "\" r=\"2.5\" " +
               (mirrored ? "fill=\"none\" stroke=\"" + color : "fill=\"" + color) + "\"/>\n";
    }
    return svg;
}

std::string draw(const ClusteredSpace& clustered, const std::vector<std::string>& names, double top) {
    Plot place{"alpha", "d", {}, {}, false};
    Plot shape{"beta", "s", {}, {}, true};
    for (const TransformationPoint& p : clustered.space.points) {
        place.angles.push_back(p.alpha);
        place.values.push_back(p.d);
        shape.angles.push_back(p.beta);
        shape.values.push_back(std::log(p.s));
    }
    const std::string title = name_of(names, clustered.space.from) + " to " + name_of(names, clustered.space.to) + ": " +
                              std::to_string(clustered.space.points.size()) + " pairs, " +
                              std::to_string(clustered.clusters.clusters.size()) + " clusters";
    return label(margin, top + margin - 10, "start", title) + draw(place, clustered, margin, top + margin) +
           draw(shape, clustered, 2 * margin + plot_width, top + margin);
}

}  // namespace

std::vector<ClusteredSpace> cluster_spaces(std::vector<TransformationSpace> spaces, const MeanShiftBandwidths& bandwidths) {
    std::vector<ClusteredSpace> result;
    for (TransformationSpace& space : spaces) {
        TransformationClusters clusters = mean_shift(space.points, bandwidths);
        result.push_back({std::move(space), std::move(clusters)});
    }
    return result;
}

std::string spaces_csv(const std::vector<ClusteredSpace>& spaces, const std::vector<std::string>& names) {
    std::string csv = "from,to,from_element,to_element,alpha,d,s,beta,mirrored,cluster\n";
    for (const ClusteredSpace& clustered : spaces)
        for (std::size_t i = 0; i < clustered.space.points.size(); ++i) {
            const TransformationPoint& p = clustered.space.points[i];
            csv += name_of(names, clustered.space.from) + ',' + name_of(names, clustered.space.to) + ',' +
                   std::to_string(p.from) + ',' + std::to_string(p.to) + ',' + text(degrees(p.alpha)) + ',' + text(p.d) +
                   ',' + text(p.s) + ',' + text(degrees(p.beta)) + ',' + (p.mirrored ? '1' : '0') + ',' +
                   std::to_string(clustered.clusters.cluster_of[i]) + '\n';
        }
    return csv;
}

std::string spaces_svg(const std::vector<ClusteredSpace>& spaces, const std::vector<std::string>& names,
                       std::size_t most_spaces) {
    // The spaces with the most points, in the order of the table.
    std::vector<std::size_t> shown(spaces.size());
    std::iota(shown.begin(), shown.end(), std::size_t{0});
    std::ranges::stable_sort(shown, std::greater{}, [&](std::size_t s) { return spaces[s].space.points.size(); });
    if (shown.size() > most_spaces) shown.resize(most_spaces);
    std::ranges::sort(shown);
    const double height = std::max<double>(1, static_cast<double>(shown.size())) * row_height;
    std::string svg =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + text(page_width) + "\" height=\"" + text(height) +
        "\" font-family=\"sans-serif\" font-size=\"11\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    for (std::size_t row = 0; row < shown.size(); ++row)
        svg += draw(spaces[shown[row]], names, static_cast<double>(row) * row_height);
    return svg + "</svg>\n";
}

}  // namespace rinceau
