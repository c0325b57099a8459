// Regions on a raster by scan lines; correlation by the Fourier transform (Eigen's kissfft).

#include "growth/measure/mask.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

#include "growth/aggregate/distance_transform.h"

namespace rinceau {
namespace {

using Spectrum = std::vector<std::complex<double>>;

/// The least number >= n that has no prime factors but 2, 3 and 5: lengths that are transformed fast.
int fast_length(int n) {
    for (;; ++n) {
        int rest = n;
        for (const int factor : {2, 3, 5})
            while (rest % factor == 0) rest /= factor;
        if (rest == 1) return n;
    }
}

/// Both directions of a transform of rows and columns; forth if `inverse` is false.
void transform(Spectrum& values, int columns, int rows, bool inverse) {
    Eigen::FFT<double> fft;
    const auto width = static_cast<std::size_t>(columns), height = static_cast<std::size_t>(rows);
    std::vector<std::complex<double>> line, result;
    const auto along = [&](std::size_t first, std::size_t count, std::size_t stride) {
        line.resize(count);
        for (std::size_t i = 0; i < count; ++i) line[i] = values[first + i * stride];
        inverse ? fft.inv(result, line) : fft.fwd(result, line);
        for (std::size_t i = 0; i < count; ++i) values[first + i * stride] = result[i];
    };
    for (std::size_t row = 0; row < height; ++row) along(row * width, width, 1);
    for (std::size_t column = 0; column < width; ++column) along(column, height, width);
}

/// Where an outline crosses the scan line y, from left to right.
std::vector<double> crossings(const Region& region, double y) {
    std::vector<double> found;
    for (const auto& ring : region) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            if ((a.y <= y) != (b.y <= y)) found.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace

Mask empty_mask(const Box& box, std::size_t cells) {
    const double cell = std::sqrt(width(box) * height(box) / static_cast<double>(cells));
    const auto count = [cell](double length) { return std::max(1, static_cast<int>(std::lround(length / cell))); };
    Mask mask{box.low, cell, count(width(box)), count(height(box)), {}};
    mask.inside.resize(static_cast<std::size_t>(mask.columns) * static_cast<std::size_t>(mask.rows));
    return mask;
}

std::ptrdiff_t cell_at(const Mask& mask, Point p) {
    const double x = std::floor((p.x - mask.low.x) / mask.cell), y = std::floor((p.y - mask.low.y) / mask.cell);
    if (!(x >= 0 && y >= 0 && x < mask.columns && y < mask.rows)) return -1;
    return static_cast<std::ptrdiff_t>(y) * mask.columns + static_cast<std::ptrdiff_t>(x);
}

bool contains(const Mask& mask, Point p) {
    const std::ptrdiff_t cell = cell_at(mask, p);
    return cell >= 0 && mask.inside[static_cast<std::size_t>(cell)] != 0;
}

Point cell_center(const Mask& mask, std::size_t cell) {
    const auto width = static_cast<std::size_t>(mask.columns);
    return mask.low + mask.cell * Point{static_cast<double>(cell % width) + 0.5, static_cast<double>(cell / width) + 0.5};
}

double area(const Mask& mask) {
    return mask.cell * mask.cell * static_cast<double>(std::count(mask.inside.begin(), mask.inside.end(), 1));
}

Mask with_region(Mask mask, const Region& region) {
    const Box box = bounds(region);
    if (is_empty(box)) return mask;
    const auto index = [&mask](double along, int count) {  // of the first cell whose middle lies behind
        return static_cast<int>(std::clamp(std::ceil(along / mask.cell - 0.5), 0.0, static_cast<double>(count)));
    };
    for (int row = index(box.low.y - mask.low.y, mask.rows); row < index(box.high.y - mask.low.y, mask.rows); ++row) {
        const std::vector<double> at = crossings(region, mask.low.y + (row + 0.5) * mask.cell);
        for (std::size_t k = 0; k + 1 < at.size(); k += 2) {
            const auto line = mask.inside.begin() + static_cast<std::ptrdiff_t>(row) * mask.columns;
            const int first = index(at[k] - mask.low.x, mask.columns), end = index(at[k + 1] - mask.low.x, mask.columns);
            std::fill(line + first, line + std::max(first, end), std::uint8_t{1});
        }
    }
    return mask;
}

std::vector<double> depths(const Mask& mask) {
    // One cell more on each side is outside.
    const int columns = mask.columns + 2, rows = mask.rows + 2;
    std::vector<std::uint8_t> outside(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 1);
    const auto framed = [&](std::size_t cell) {
        const auto width = static_cast<std::size_t>(mask.columns);
        return (cell / width + 1) * static_cast<std::size_t>(columns) + cell % width + 1;
    };
    for (std::size_t cell = 0; cell < mask.inside.size(); ++cell) outside[framed(cell)] = mask.inside[cell] != 0 ? 0 : 1;
    const std::vector<float> distance = distances_to_marked({columns, rows, std::move(outside)}, {mask.cell, mask.cell});
    std::vector<double> result(mask.inside.size());
    for (std::size_t cell = 0; cell < result.size(); ++cell) result[cell] = static_cast<double>(distance[framed(cell)]);
    return result;
}

SelfOverlap self_overlap(std::span<const double> values, int columns, int rows, int column_steps, int row_steps,
                         bool wrapped) {
    const int wide = wrapped ? columns : fast_length(columns + column_steps);
    const int high = wrapped ? rows : fast_length(rows + row_steps);
    const auto cell = [wide, high](int column, int row) {
        return static_cast<std::size_t>((row + high) % high) * static_cast<std::size_t>(wide) +
               static_cast<std::size_t>((column + wide) % wide);
    };
    Spectrum spectrum(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high));
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            spectrum[cell(column, row)] =
                values[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)];
    transform(spectrum, wide, high, false);
    for (auto& value : spectrum) value = std::norm(value);
    transform(spectrum, wide, high, true);

    SelfOverlap overlap{column_steps, row_steps, {}};
    overlap.shared.reserve(static_cast<std::size_t>(2 * column_steps + 1) * static_cast<std::size_t>(2 * row_steps + 1));
    for (int row = -row_steps; row <= row_steps; ++row)
        for (int column = -column_steps; column <= column_steps; ++column)
            overlap.shared.push_back(spectrum[cell(column, row)].real());
    return overlap;
}

}  // namespace rinceau
