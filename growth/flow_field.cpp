// Ijiri et al. 2008, section 3: the flow between strokes by radial basis functions. The paper does not name its basis. Here
// it is the thin plate, r^2 log r, with an affine part (Duchon 1977): with it the field meets strokes that were held out to
// within a degree, goes on beyond the strokes' ends as they do, and turns about the middle of a round stroke only.
//
//   v(x) = sum_i w_i phi(|x - p_i|) + a_0 + a_1 x + a_2 y,   sum_i w_i = sum_i w_i p_i = 0
//
// Coordinates are counted from the samples' middle in half their extent. The system is solved in the least-squares sense
// with least coefficients, so that samples on one straight line, which leave the affine part open, are no special case.

#include "growth/flow_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <Eigen/Dense>

#include "geometry/angle.h"
#include "geometry/index.h"
#include "geometry/parallel.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

constexpr double ridge = 1e-6;             // added to the diagonal: samples may coincide
constexpr std::size_t least_samples = 16;  // of a stroke: it may be a small circle
constexpr double sample_spacing = 0.005;   // of the strokes' extent: more samples would not change the field
constexpr double no_direction = 1e-9;      // of the field's mean size: below it only rounding has a direction

struct FlowSample {
    Point at;
    Complex direction;  // of length 1; of an undirected field its square
};

void add_samples(const Polyline& line, std::size_t count, bool directed, std::vector<FlowSample>& samples) {
    // Every other cut is a sample, the two beside it tell its direction.
    const std::vector<Point> cuts = cut_evenly(line, 2 * count);
    for (std::size_t i = 1; i < cuts.size(); i += 2) {
        const Point along = cuts[i + 1] - cuts[i - 1];
        const double size = abs(along);
        if (!(size > 0)) continue;  // the line turns back upon itself
        const Complex direction = along / size;
        samples.push_back({cuts[i], directed ? direction : direction * direction});
    }
}

/// Samples at equal distances on every stroke, the longest strokes first if there are more strokes than samples.
std::vector<FlowSample> sampled(std::span<const Polyline> strokes, const FlowOptions& options) {
    std::vector<double> lengths;
    Box extent;
    for (const Polyline& stroke : strokes) {
        lengths.push_back(length_of(stroke));
        for (const Point p : stroke) extent = including(extent, p);
    }
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        if (lengths[i] > 0) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return lengths[a] > lengths[b]; });
    if (order.size() > options.max_samples) order.resize(options.max_samples);

    double total = 0;
    for (const std::size_t i : order) total += lengths[i];
    const std::size_t least = std::min(least_samples, options.max_samples / std::max<std::size_t>(order.size(), 1));
    const auto spare = static_cast<double>(options.max_samples - least * order.size());
    const double spacing = sample_spacing * diagonal(extent);
    std::vector<FlowSample> samples;
    for (const std::size_t i : order) {
        const double more = std::min(spare * lengths[i] / total, lengths[i] / spacing);
        add_samples(strokes[i], least + static_cast<std::size_t>(more), options.directed, samples);
    }
    return samples;
}

/// phi by the square of the distance.
double thin_plate(double squared) { return squared > 0 ? 0.5 * squared * std::log(squared) : 0; }

/// v(x) of the file's head.
struct RadialField {
    Point middle;
    double unit = 1;
    Eigen::ArrayXd x, y;       // of the samples
    Eigen::MatrixX2d weights;  // w_i, then a_0, a_1, a_2

    Point at(Point p) const {
        const Point q = (p - middle) / unit;
        const Eigen::ArrayXd squared = (x - q.x).square() + (y - q.y).square();
        // The least double keeps the logarithm finite; its product with a distance of 0 is 0.
        const Eigen::VectorXd phi = 0.5 * squared * squared.max(std::numeric_limits<double>::min()).log();
        const Eigen::Index count = x.size();
        const Eigen::RowVector2d sum = phi.transpose() * weights.topRows(count) + weights.row(count) +
                                       q.x * weights.row(count + 1) + q.y * weights.row(count + 2);
        return {sum(0), sum(1)};
    }
};

RadialField interpolated(const std::vector<FlowSample>& samples) {
    Box box;
    for (const FlowSample& sample : samples) box = including(box, sample.at);
    RadialField field;
    field.middle = center(box);
    field.unit = diagonal(box) > 0 ? 0.5 * diagonal(box) : 1;
    const auto count = static_cast<Eigen::Index>(samples.size());
    field.x.resize(count);
    field.y.resize(count);
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(count + 3, count + 3);
    Eigen::MatrixX2d values = Eigen::MatrixX2d::Zero(count + 3, 2);
    for (Eigen::Index i = 0; i < count; ++i) {
        const FlowSample& sample = samples[static_cast<std::size_t>(i)];
        const Point q = (sample.at - field.middle) / field.unit;
        field.x(i) = q.x;
        field.y(i) = q.y;
        for (Eigen::Index k = 0; k < i; ++k)
            system(i, k) = system(k, i) = thin_plate(norm(q - Point{field.x(k), field.y(k)}));
        system(i, i) = ridge;
        system.row(i).tail(3) << 1, q.x, q.y;
        system.col(i).tail(3) << 1, q.x, q.y;
        values.row(i) << sample.direction.x, sample.direction.y;
    }
    field.weights = Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(system).solve(values);
    return field;
}

/// The nodes about node i, those at its sides first.
std::vector<std::size_t> nodes_about(const FlowField& field, std::size_t i) {
    const int column = static_cast<int>(i) % field.columns, row = static_cast<int>(i) / field.columns;
    constexpr std::array<std::array<int, 2>, 8> steps{
        {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
    std::vector<std::size_t> nodes;
    for (const auto& [across, up] : steps) {
        if (column + across < 0 || column + across >= field.columns || row + up < 0 || row + up >= field.rows) continue;
        nodes.push_back(static_cast<std::size_t>((row + up) * field.columns + column + across));
    }
    return nodes;
}

/// Gives nodes without a direction that of what is known about them, from the known ones inward.
void fill_unknown(FlowField& field, std::vector<std::size_t> unknown) {
    while (!unknown.empty()) {
        std::vector<std::size_t> left;
        std::vector<std::pair<std::size_t, Complex>> told;
        for (const std::size_t i : unknown) {
            Complex sum, first;
            for (const std::size_t k : nodes_about(field, i)) {
                sum += field.table[k];
                if (first == Complex{}) first = field.table[k];
            }
            // Opposite neighbours have no larger part.
            const Complex direction = abs(sum) > no_direction ? sum / abs(sum) : first;
            if (direction == Complex{})
                left.push_back(i);
            else
                told.emplace_back(i, direction);
        }
        for (const auto& [i, direction] : told) field.table[i] = direction;
        unknown = std::move(left);
    }
}

/// All nodes' directions; `otherwise` if the strokes cancel each other everywhere.
void tabulate(FlowField& field, const RadialField& radial, Complex otherwise) {
    const auto columns = static_cast<std::size_t>(field.columns), rows = static_cast<std::size_t>(field.rows);
    field.table.resize(columns * rows);
    for_each_index(rows, 0, [&](std::size_t row) {
        for (std::size_t column = 0; column < columns; ++column) {
            const Point at = field.box.low + field.step * Point{static_cast<double>(column), static_cast<double>(row)};
            field.table[row * columns + column] = radial.at(at);
        }
    });
    const double mean =
        std::accumulate(field.table.begin(), field.table.end(), 0.0, [](double sum, Complex v) { return sum + abs(v); }) /
        static_cast<double>(field.table.size());
    std::vector<std::size_t> unknown;
    for (std::size_t i = 0; i < field.table.size(); ++i) {
        const double size = abs(field.table[i]);
        const bool known = size > no_direction * std::max(mean, no_direction);
        field.table[i] = known ? field.table[i] / size : Complex{};
        if (!known) unknown.push_back(i);
    }
    if (unknown.size() == field.table.size())
        std::fill(field.table.begin(), field.table.end(), otherwise);
    else
        fill_unknown(field, std::move(unknown));
}

}  // namespace

FlowField make_flow_field(std::span<const Polyline> strokes, const Box& box, const FlowOptions& options,
                          const std::string& label) {
    const std::vector<FlowSample> samples = sampled(strokes, options);
    if (samples.empty()) throw InputError({label}, "expected strokes that show the flow, found none that has a length");

    FlowField field{.box = box, .directed = options.directed};
    const double cells = static_cast<double>(options.max_cells);
    // With a column and a row more than the box has cells, the table keeps within: (w/s + 2) (h/s + 2) <= cells.
    const double least = std::sqrt(width(box) * height(box) / cells) + 2 * (width(box) + height(box)) / cells;
    field.step = std::max(options.step, least);
    field.columns = static_cast<int>(width(box) / field.step) + 2;
    field.rows = static_cast<int>(height(box) / field.step) + 2;
    tabulate(field, interpolated(samples), samples.front().direction);
    return field;
}

Complex direction_at(const FlowField& field, Point p) {
    const auto along = [&](double from_edge, int count) { return std::clamp(from_edge / field.step, 0.0, count - 1.0); };
    const double x = along(p.x - field.box.low.x, field.columns), y = along(p.y - field.box.low.y, field.rows);
    const int column = std::min(static_cast<int>(x), field.columns - 2), row = std::min(static_cast<int>(y), field.rows - 2);
    const auto node = [&field](int c, int r) { return field.table[table_index(r, c, field.columns)]; };
    const double u = x - column, v = y - row;
    const Complex sum = (1 - v) * ((1 - u) * node(column, row) + u * node(column + 1, row)) +
                        v * ((1 - u) * node(column, row + 1) + u * node(column + 1, row + 1));
    const double size = abs(sum);
    const Complex direction = size > no_direction ? sum / size : node(column + (u > 0.5 ? 1 : 0), row + (v > 0.5 ? 1 : 0));
    return field.directed ? direction : polar(1, 0.5 * arg(direction));
}

std::vector<SingularPoint> singular_points(const FlowField& field) {
    // Each edge's turn is told once, whatever cell asks, so that half a turn counts on one of its sides only.
    const auto turn = [&field](int c, int r, int across, int up) {
        const auto node = [&](int column, int row) { return field.table[table_index(row, column, field.columns)]; };
        return arg(node(c + across, r + up) * conj(node(c, r)));
    };
    std::vector<SingularPoint> points;
    for (int row = 0; row + 1 < field.rows; ++row) {
        for (int column = 0; column + 1 < field.columns; ++column) {
            const double around = turn(column, row, 1, 0) + turn(column + 1, row, 0, 1) - turn(column, row + 1, 1, 0) -
                                  turn(column, row, 0, 1);
            const int turns = static_cast<int>(std::lround(around / two_pi));
            if (turns == 0) continue;
            points.push_back(
                {field.box.low + field.step * Point{column + 0.5, row + 0.5}, field.directed ? 2 * turns : turns});
        }
    }
    return points;
}

}  // namespace rinceau
