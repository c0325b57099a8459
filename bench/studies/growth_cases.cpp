#include "growth_cases.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "analyzer/analyze.h"
#include "geometry/random.h"
#include "growth/arrangement/tile_of_drawing.h"
#include "growth/figures.h"
#include "scene/svg_read.h"

namespace rinceau::test {
namespace {

namespace fs = std::filesystem;

Region disc(double radius) {
    Region region(1);
    for (int k = 0; k < 24; ++k) region[0].push_back(polar(radius, two_pi * k / 24));
    return region;
}

Region block(double width, double height) {
    return {{{-width / 2, -height / 2}, {width / 2, -height / 2}, {width / 2, height / 2}, {-width / 2, height / 2}}};
}

ExemplarCase made(const std::string& name, Demand demand, const std::vector<ExemplarPoint>& points, int symbols) {
    ExemplarCase one{name, demand, {}, {}};
    std::vector<std::string> names;
    for (int symbol = 0; symbol < symbols; ++symbol) names.emplace_back(1, static_cast<char>('A' + symbol));
    try {
        one.exemplar = make_exemplar(points, names, {}, name);
    } catch (const std::exception& error) {
        one.fault = error.what();
    }
    return one;
}

/// Points of a lattice whose columns and rows step by u and v, turned.
struct LatticePlan {
    Point u{1, 0}, v{0, 1};
    int columns = 9, rows = 9;
    double turned = 0;  // degrees
    double jitter = 0;  // largest, either way
    Region outline = disc(0.3);
    bool staggered = false;  ///< odd rows stand half a step back, so that the exemplar is upright
};

std::vector<ExemplarPoint> planned(const LatticePlan& plan) {
    Random random(17);
    std::vector<ExemplarPoint> points;
    for (int row = 0; row < plan.rows; ++row) {
        for (int column = 0; column < plan.columns; ++column) {
            const int shift = plan.staggered ? -(row / 2) : 0;
            const double x = random.uniform(-plan.jitter, plan.jitter);
            const Point aside{x, random.uniform(-plan.jitter, plan.jitter)};
            const Point p = plan.u * (column + shift) + plan.v * row + aside;
            points.push_back({polar(1, plan.turned * pi / 180) * p, 0, plan.outline, true});
        }
    }
    return points;
}

std::vector<ExemplarPoint> checkerboard() {
    std::vector<ExemplarPoint> points = planned({.outline = block(0.9, 0.9)});
    for (std::size_t i = 0; i < points.size(); ++i) points[i].symbol = static_cast<int>(i % 2);
    return points;
}

/// The corners of hexagons: two points a cell.
std::vector<ExemplarPoint> honeycomb() {
    std::vector<ExemplarPoint> points;
    const double root = std::sqrt(3.0);
    for (const ExemplarPoint& cell :
         planned({.u = {root, 0}, .v = {root / 2, 1.5}, .outline = disc(0.2), .staggered = true})) {
        points.push_back(cell);
        points.push_back(cell);
        points.back().position += Point{0, 1};
    }
    return points;
}

/// Discs strewn one after the other where no other one is nearer than both their reaches.
std::vector<ExemplarPoint> strewn(const std::vector<double>& reaches, const std::vector<double>& shares, double side) {
    Random random(23);
    std::vector<ExemplarPoint> points;
    for (int tries = 0; tries < 20'000; ++tries) {
        double draw = random.uniform();
        std::size_t kind = 0;
        while (kind + 1 < shares.size() && draw > shares[kind]) draw -= shares[kind++];
        const double x = random.uniform(0, side);
        const Point p{x, random.uniform(0, side)};
        const bool free = std::all_of(points.begin(), points.end(), [&](const ExemplarPoint& other) {
            return abs(other.position - p) > reaches[kind] + reaches[static_cast<std::size_t>(other.symbol)];
        });
        if (free) points.push_back({p, static_cast<int>(kind), disc(0.8 * reaches[kind]), true});
    }
    return points;
}

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

FiguredDrawing figured(const fs::path& file) {
    const SvgReadResult drawing = read_svg(text_of(file), {.file_name = file.filename().string()});
    return figures_of(analyze(drawing.scene).grammar);
}

/// As `rinceau arrange` reads it.
ExemplarCase drawn(const fs::path& file, const std::string& name) {
    ExemplarCase one{name, Demand::irregular, {}, {}};
    try {
        FiguredDrawing drawing = figured(file);
        ExemplarOptions options;
        options.tile = sensible_tile(drawing, options);
        if (options.tile) drawing = as_tile(std::move(drawing), *options.tile);
        one.exemplar = make_exemplar(drawing, options, file.filename().string());
        if (options.tile) one.name += ", tiled";
        if (!one.exemplar->irregular) one.demand = Demand::jittered;
    } catch (const std::exception& error) {
        one.fault = error.what();
    }
    return one;
}

struct ShapePlan {
    std::string name;
    std::vector<std::string> files;
    double min_scale = 1;
    double share_tolerance = 1;
    double coverage = 0;
};

/// The square that so many shapes, each kind as often, cover to that share.
double side_for(const ShapeCase& set, double shapes, double coverage) {
    double area = 0;
    for (const ExclusiveRegion& region : set.regions) area += region.area / static_cast<double>(set.regions.size());
    const double a = set.min_scale, b = set.max_scale;
    return std::sqrt(shapes * area * (a * a + a * b + b * b) / 3 / coverage);
}

}  // namespace

std::vector<ExemplarCase> lattice_cases() {
    const double root = std::sqrt(3.0);
    const Demand exact = Demand::exact;
    return {
        made("square grid", exact, planned({}), 1),
        made("square grid turned by 20 degrees", exact, planned({.turned = 20}), 1),
        made("checkerboard", exact, checkerboard(), 2),
        made("honeycomb", exact, honeycomb(), 1),
        made("hexagonal packing", exact, planned({.v = {0.5, root / 2}, .staggered = true}), 1),
        made("bricks", exact, planned({.u = {2, 0}, .v = {1, 1}, .outline = block(1.9, 0.9), .staggered = true}), 1),
        made("diagonal scales", exact, planned({.u = {1, 0}, .v = {0.5, 0.5}, .outline = disc(0.3), .staggered = true}), 1),
        made("jitter 10 %", Demand::jittered, planned({.jitter = 0.1}), 1),
        made("jitter 20 %", Demand::jittered, planned({.jitter = 0.2}), 1),
    };
}

std::vector<ExemplarCase> strewn_cases() {
    return {
        made("strewn, 1 kind", Demand::irregular, strewn({0.5}, {1}, 11), 1),
        made("strewn, 2 kinds", Demand::irregular, strewn({1, 0.5}, {0.5, 0.5}, 13), 2),
        made("strewn, 3 kinds", Demand::irregular, strewn({1, 0.7, 0.4}, {0.4, 0.3, 0.3}, 18), 3),
    };
}

std::vector<ExemplarCase> drawn_cases(const std::string& folder, const std::string& only) {
    std::vector<fs::path> files;
    if (fs::is_directory(folder))
        for (const auto& entry : fs::directory_iterator(folder))
            if (entry.path().extension() == ".svg") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<ExemplarCase> cases;
    for (const fs::path& file : files) {
        const std::string name = file.stem().string();
        if (name.find(only) != std::string::npos) cases.push_back(drawn(file, name));
    }
    return cases;
}

std::vector<ExemplarCase> sample_cases(const std::string& only) {
    std::vector<ExemplarCase> cases;
    for (const std::string file : {"blocks", "bricks", "dots", "feathers", "rows", "scales", "stones"}) {
        const std::string name = "sample " + file;
        if (name.find(only) == std::string::npos) continue;
        cases.push_back(drawn(fs::path(RINCEAU_SAMPLES) / "growth" / (file + ".svg"), name));
    }
    return cases;
}

ExclusiveRegion silhouette(const std::string& file) {
    const SvgReadResult drawing = read_svg(text_of(file), {.file_name = file});
    constexpr double deviation = 1e-3;  // of the drawing's diagonal
    Region outline;
    for (const Element& element : drawing.scene.elements)
        outline = union_of(outline, painted_region(element, deviation * diagonal(drawing.scene.viewport)));
    const ExclusiveRegion natural = exclusive_region(outline, {}, file);
    Region scaled = natural.rings;
    for (auto& ring : scaled)
        for (Point& p : ring) p = p / natural.radius;
    return drawn_exclusive_region(scaled, {}, file);
}

std::vector<ShapeCase> shape_cases(const std::string& folder, double shapes, const std::string& only) {
    std::vector<std::string> all;
    if (fs::is_directory(folder))
        for (const auto& entry : fs::directory_iterator(folder))
            if (entry.path().extension() == ".svg") all.push_back(entry.path().stem().string());
    std::sort(all.begin(), all.end());
    // Coverage that the default method is known to reach (of all: a guess between the others).
    const std::vector<ShapePlan> plans{
        {"boomerang, worm, gecko", {"boomerang", "worm", "gecko"}, 1, 0, 0.34},
        {"two leaves", {"maple-leaf", "oak-leaf"}, 0.2, 1, 0.5},
        {"wrench, saw, feather, snake", {"wrench", "hand-saw", "feather", "snake"}, 1, 1, 0.455},
        {"all silhouettes", all, 1, 0.1, 0.4}};
    std::vector<ShapeCase> sets;
    for (const ShapePlan& plan : plans) {
        if (plan.name.find(only) == std::string::npos) continue;
        ShapeCase set{.name = plan.name, .min_scale = plan.min_scale, .share_tolerance = plan.share_tolerance};
        for (const std::string& file : plan.files)
            set.regions.push_back(silhouette((fs::path(folder) / (file + ".svg")).string()));
        set.side = side_for(set, shapes, plan.coverage);
        sets.push_back(std::move(set));
    }
    return sets;
}

}  // namespace rinceau::test
