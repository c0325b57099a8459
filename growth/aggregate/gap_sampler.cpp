// The paper visits every pixel with the probability d^16 to scatter points Q and picks 100 of them, the points P; its
// sentence "when the random number is over the probability" must read "below". Drawing a block of cells from a tree of sums
// and a cell from the block is the same distribution, without the points Q and without a visit to every pixel.

#include "growth/aggregate/gap_sampler.h"

#include <algorithm>
#include <bit>

namespace rinceau {
namespace {

constexpr int block_side = 8;  // cells

double to_the_16th(double x) {
    const double square = x * x, fourth = square * square, eighth = fourth * fourth;
    return eighth * eighth;
}

int blocks_of(int cells) { return (cells + block_side - 1) / block_side; }

}  // namespace

GapSampler::GapSampler(const DistanceField& field, double least, std::vector<float> clearance)
    : least_(least),
      clearance_(std::move(clearance)),
      block_columns_(blocks_of(field.columns())),
      block_rows_(blocks_of(field.rows())),
      leaves_(std::bit_ceil(static_cast<std::size_t>(block_columns_) * static_cast<std::size_t>(block_rows_))),
      sums_(2 * leaves_, 0.0) {
    update(field);
}

double GapSampler::weight(const DistanceField& field, int column, int row) const {
    double value = field.value(column, row);
    if (!clearance_.empty())
        value -= clearance_[static_cast<std::size_t>(row) * static_cast<std::size_t>(field.columns()) +
                            static_cast<std::size_t>(column)];
    // In cells, so that the power neither overflows nor vanishes.
    return value > least_ ? to_the_16th(value / field.step()) : 0;
}

double GapSampler::block_weight(const DistanceField& field, int block_column, int block_row) const {
    const int end_row = std::min((block_row + 1) * block_side, field.rows());
    const int end_column = std::min((block_column + 1) * block_side, field.columns());
    double sum = 0;
    for (int row = block_row * block_side; row < end_row; ++row)
        for (int column = block_column * block_side; column < end_column; ++column) sum += weight(field, column, row);
    return sum;
}

void GapSampler::update_blocks(const DistanceField& field, int first_column, int end_column, int first_row, int end_row) {
    if (first_column >= end_column || first_row >= end_row) return;
    const auto columns = static_cast<std::size_t>(block_columns_);
    for (int row = first_row / block_side; row < blocks_of(end_row); ++row) {
        const std::size_t line = leaves_ + static_cast<std::size_t>(row) * columns;
        std::size_t first = line + static_cast<std::size_t>(first_column / block_side);
        std::size_t last = line + static_cast<std::size_t>(blocks_of(end_column)) - 1;
        for (std::size_t leaf = first; leaf <= last; ++leaf)
            sums_[leaf] = block_weight(field, static_cast<int>(leaf - line), row);
        for (first /= 2, last /= 2; first > 0; first /= 2, last /= 2)
            for (std::size_t node = first; node <= last; ++node) sums_[node] = sums_[2 * node] + sums_[2 * node + 1];
    }
}

void GapSampler::update(const DistanceField& field) { update_blocks(field, 0, field.columns(), 0, field.rows()); }

void GapSampler::update(const DistanceField& field, const CellWindow& window) {
    // A window of a tile may hang over its sides: up to two pieces along each axis.
    struct Piece {
        int first, end;
    };
    const auto pieces = [](int first, int count, int whole) {
        const int start = ((first % whole) + whole) % whole;
        return std::vector<Piece>{{start, std::min(start + count, whole)}, {0, std::max(start + count - whole, 0)}};
    };
    for (const Piece& across : pieces(window.column, window.columns, field.columns()))
        for (const Piece& up : pieces(window.row, window.rows, field.rows()))
            update_blocks(field, across.first, across.end, up.first, up.end);
}

std::optional<Point> GapSampler::draw(const DistanceField& field, Random& random) const {
    double rest = random.uniform() * sums_[1];
    if (!(sums_[1] > 0)) return std::nullopt;
    std::size_t node = 1;
    while (node < leaves_) {
        node *= 2;
        if (rest >= sums_[node] && sums_[node + 1] > 0) rest -= sums_[node++];
    }
    const CellWindow cell = cell_of(field, static_cast<int>(node - leaves_), rest);
    const double row = cell.row + random.uniform();  // not as arguments of one call: compilers draw these in either order
    return field.corner(cell.column + random.uniform(), row);
}

/// The cell of a block at which the running sum of weights passes `rest`.
CellWindow GapSampler::cell_of(const DistanceField& field, int block, double rest) const {
    const int first_row = block / block_columns_ * block_side, first_column = block % block_columns_ * block_side;
    const int end_row = std::min(first_row + block_side, field.rows());
    const int end_column = std::min(first_column + block_side, field.columns());
    CellWindow last{first_column, first_row, 1, 1};  // should rounding leave a rest behind the last cell
    for (int row = first_row; row < end_row; ++row)
        for (int column = first_column; column < end_column; ++column) {
            const double w = weight(field, column, row);
            if (w <= 0) continue;
            last = {column, row, 1, 1};
            if (rest < w) return last;
            rest -= w;
        }
    return last;
}

}  // namespace rinceau
