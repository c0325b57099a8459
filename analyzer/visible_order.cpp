// The common box is cut in halves until a part has one colour in each picture, or none in one, or is small enough to be
// looked at point by point.

#include "analyzer/visible_order.h"

#include <array>
#include <cmath>

#include "geometry/index.h"

namespace rinceau {
namespace {

/// Squares one pixel wide are compared at every cell, this many to a pixel's width.
constexpr int cells_per_pixel = 3;
constexpr int half_square = cells_per_pixel / 2;
/// Cells by which a square may be moved: two thirds of a pixel.
constexpr int blur = 2;
/// What differs on less than `least_differing` squares of this neighbourhood is a speck: a blot of 2 x 2 cells in black and
/// white makes 16 squares differ, one of 2 x 3 cells 20; a hair across the neighbourhood 21.
constexpr int half_neighborhood = 3;
constexpr int least_differing = 18;
/// Cells beyond a tile that its squares take part in.
constexpr int rim = half_neighborhood + blur + half_square;
/// Cells a side of what is looked at point by point.
constexpr int tile_cells = 24;
/// Cells a side that must be uniform so that enough squares differ for sure.
constexpr int probe_cells = 12;
/// Points a side of a cell, where strokes are thinner than a cell.
constexpr int most_samples_per_cell = 2;
/// Polylines stray less than a point may.
constexpr double deviation_in_pixels = 1.0 / 16;

Box common_part(const Box& a, const Box& b) {
    return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
            {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

struct Comparison {
    const PaintedElement& a;
    const PaintedElement& b;
    Box common;
    double cell = 1;
    int samples_per_cell = 1;
    bool stroked_a = true;
    bool stroked_b = true;
    VisibleOrderOptions options;
    std::size_t samples = 0;
};

/// How far the two orders are apart where the inks are `a` and `b`: over(b, a) - over(a, b), on any ground.
double order_difference(const Ink& a, const Ink& b) {
    return std::max({std::abs(a.alpha * b.red - b.alpha * a.red), std::abs(a.alpha * b.green - b.alpha * a.green),
                     std::abs(a.alpha * b.blue - b.alpha * a.blue)});
}

/// Inks of square cells, row by row.
struct Picture {
    int columns = 0;
    int rows = 0;
    std::vector<Ink> cells;

    const Ink& at(int column, int row) const {
        return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)];
    }
};

/// Means over `size` x `size` cells that begin at every `step`th cell.
Picture means(const Picture& fine, int size, int step) {
    if (size == 1 && step == 1) return fine;
    Picture mean{(fine.columns - size) / step + 1, (fine.rows - size) / step + 1, {}};
    mean.cells.reserve(static_cast<std::size_t>(mean.columns) * static_cast<std::size_t>(mean.rows));
    const double share = 1.0 / (size * size);
    for (int row = 0; row < mean.rows; ++row) {
        for (int column = 0; column < mean.columns; ++column) {
            Ink sum;
            for (int j = 0; j < size; ++j) {
                for (int i = 0; i < size; ++i) sum = sum + fine.at(column * step + i, row * step + j);
            }
            mean.cells.push_back(share * sum);
        }
    }
    return mean;
}

/// Is the square of one picture unlike all squares of the other nearby?
bool unlike_all_near(const Picture& one, const Picture& other, int column, int row, double least) {
    for (int j = -blur; j <= blur; ++j) {
        for (int i = -blur; i <= blur; ++i) {
            if (difference(one.at(column, row), other.at(column + i, row + j)) <= least) return false;
        }
    }
    return true;
}

/// Are enough squares in one neighbourhood marked? Of the marks, those within half a neighbourhood of the border are the
/// rim.
bool more_than_specks(const std::vector<char>& marks, int columns, int rows) {
    for (int row = half_neighborhood; row + half_neighborhood < rows; ++row) {
        for (int column = half_neighborhood; column + half_neighborhood < columns; ++column) {
            int marked = 0;
            for (int j = -half_neighborhood; j <= half_neighborhood; ++j) {
                for (int i = -half_neighborhood; i <= half_neighborhood; ++i) {
                    marked += marks[table_index(row + j, column + i, columns)];
                }
            }
            if (marked >= least_differing) return true;
        }
    }
    return false;
}

/// Compares two pictures in cells; a rim of cells around what is asked for belongs to them.
bool pictures_differ(const Picture& one, const Picture& other, double least) {
    const Picture squares = means(one, cells_per_pixel, 1);
    const Picture other_squares = means(other, cells_per_pixel, 1);
    const int columns = squares.columns - 2 * blur;
    const int rows = squares.rows - 2 * blur;
    std::vector<char> marks(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
    int marked = 0;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const int x = column + blur;
            const int y = row + blur;
            if (difference(squares.at(x, y), other_squares.at(x, y)) <= least) continue;
            if (!unlike_all_near(squares, other_squares, x, y, least) &&
                !unlike_all_near(other_squares, squares, x, y, least))
                continue;
            marks[table_index(row, column, columns)] = 1;
            ++marked;
        }
    }
    return marked >= least_differing && more_than_specks(marks, columns, rows);
}

/// Points in whole cells around the middle of the box, at least covering it.
SampleGrid grid_around(const Comparison& comparison, const Box& box) {
    const int m = comparison.samples_per_cell;
    const auto samples = [&](double length) {
        return m * std::max(1, static_cast<int>(std::ceil(length / comparison.cell)));
    };
    SampleGrid grid{.step = comparison.cell / m, .columns = samples(width(box)), .rows = samples(height(box))};
    grid.origin = center(box) - grid.step / 2 * Point{double(grid.columns - 1), double(grid.rows - 1)};
    return grid;
}

struct TwoInks {
    std::vector<Ink> a;
    std::vector<Ink> b;
};

TwoInks sampled(Comparison& comparison, const SampleGrid& grid) {
    comparison.samples += static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.columns);
    return {painted_samples(comparison.a, grid, comparison.stroked_a),
            painted_samples(comparison.b, grid, comparison.stroked_b)};
}

/// The squares' mean differences add up to those of the cells: are these together too little for `least_differing` squares?
bool too_little_differs(Comparison& comparison, const Box& box) {
    const TwoInks inks = sampled(comparison, grid_around(comparison, box));
    double sum = 0;
    for (std::size_t i = 0; i < inks.a.size(); ++i) sum += order_difference(inks.a[i], inks.b[i]);
    const int m = comparison.samples_per_cell;
    return sum / (m * m) < least_differing * comparison.options.channel_difference;
}

/// Looks at a small box point by point.
bool seen_in_tile(Comparison& comparison, const Box& box) {
    // Nothing differs outside the common box, so its part of the neighbourhoods is a quick look.
    const double near = (half_neighborhood + half_square) * comparison.cell;
    if (too_little_differs(comparison, common_part(grown(box, near), comparison.common))) return false;
    const int m = comparison.samples_per_cell;
    const SampleGrid grid = grid_around(comparison, grown(box, rim * comparison.cell));
    const TwoInks inks = sampled(comparison, grid);
    Picture b_on_a{grid.columns, grid.rows, std::vector<Ink>(inks.a.size())};
    Picture a_on_b = b_on_a;
    for (std::size_t i = 0; i < inks.a.size(); ++i) {
        b_on_a.cells[i] = over(inks.b[i], inks.a[i]);
        a_on_b.cells[i] = over(inks.a[i], inks.b[i]);
    }
    return pictures_differ(means(b_on_a, m, m), means(a_on_b, m, m), comparison.options.channel_difference);
}

/// Nothing if the box must be looked at more closely.
std::optional<bool> seen_at_once(const Comparison& comparison, const Box& box) {
    const std::optional<Ink> a = uniform_ink(comparison.a, box);
    if (a && a->alpha == 0) return false;
    const std::optional<Ink> b = uniform_ink(comparison.b, box);
    if (b && b->alpha == 0) return false;
    if (!a || !b) return std::nullopt;
    const bool differs = order_difference(*a, *b) > comparison.options.channel_difference;
    if (differs && std::min(width(box), height(box)) < probe_cells * comparison.cell) return std::nullopt;
    return differs;
}

std::array<Box, 2> halves(const Box& box) {
    const Point middle = center(box);
    if (width(box) > height(box)) return {{{box.low, {middle.x, box.high.y}}, {{middle.x, box.low.y}, box.high}}};
    return {{{box.low, {box.high.x, middle.y}}, {{box.low.x, middle.y}, box.high}}};
}

bool seen_in_box(Comparison& comparison, const Box& box) {
    if (comparison.samples > comparison.options.max_samples) return true;
    ++comparison.samples;
    if (const std::optional<bool> seen = seen_at_once(comparison, box)) return *seen;
    if (std::max(width(box), height(box)) <= tile_cells * comparison.cell) return seen_in_tile(comparison, box);
    for (const Box& half : halves(box)) {
        if (seen_in_box(comparison, half)) return true;
    }
    return false;
}

/// Enough points for the thinner of the strokes, if it is thinner than a cell.
int samples_per_cell(const PaintedElement& a, const PaintedElement& b, double cell) {
    double width = cell;
    for (const PaintedElement* element : {&a, &b}) {
        if (element->strokes && element->outline.stroke_radius > 0)
            width = std::min(width, 2 * element->outline.stroke_radius);
    }
    const int needed =
        width * most_samples_per_cell <= cell ? most_samples_per_cell : static_cast<int>(std::ceil(cell / width));
    return std::min(needed, most_samples_per_cell);
}

}  // namespace

bool too_thin_to_see(const Box& a, const Box& b, double pixel, const VisibleOrderOptions& options) {
    const Box common = common_part(a, b);
    return is_empty(common) || std::min(width(common), height(common)) < options.channel_difference * pixel;
}

double sampling_deviation(double pixel) { return deviation_in_pixels * pixel; }

VisibleOrder visible_order(const PaintedElement& a, const PaintedElement& b, double pixel,
                           const VisibleOrderOptions& options) {
    if (too_thin_to_see(a.outline.box, b.outline.box, pixel, options)) return {};
    const Box common = common_part(a.outline.box, b.outline.box);
    const double cell = pixel / cells_per_pixel;
    Comparison comparison{.a = a,
                          .b = b,
                          .common = common,
                          .cell = cell,
                          .samples_per_cell = samples_per_cell(a, b, cell),
                          .options = options};
    // 1. The middle decides for most things on a ground.
    const double half_probe = probe_cells * cell / 2;
    if (seen_at_once(comparison, grown({center(common), center(common)}, half_probe)).value_or(false)) return {true, 1};
    // 2. All of it, dashed strokes with and without.
    for (const bool stroked_a : {true, false}) {
        for (const bool stroked_b : {true, false}) {
            if ((!stroked_a && !a.dashed) || (!stroked_b && !b.dashed)) continue;
            comparison.stroked_a = stroked_a;
            comparison.stroked_b = stroked_b;
            if (seen_in_box(comparison, common)) return {true, comparison.samples};
        }
    }
    return {false, comparison.samples};
}

bool order_can_be_seen(const Element& a, const Element& b, double pixel, const VisibleOrderOptions& options) {
    if (!a.verbatim.empty() || !b.verbatim.empty()) return true;
    const auto paints = [](const Element& e) {
        return !e.paths.empty() && (paints_fill(e.style) || paints_stroke(e.style));
    };
    if (!paints(a) || !paints(b)) return false;
    const double deviation = sampling_deviation(pixel);
    return visible_order(painted_element(a, deviation), painted_element(b, deviation), pixel, options).visible;
}

}  // namespace rinceau
