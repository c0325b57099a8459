#include "growth/measure/ring_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rinceau {
namespace {

void count_degree(DegreeHistogram& histogram, std::size_t degree) {
    if (histogram.size() <= degree) histogram.resize(degree + 1);
    histogram[degree] += 1;
}

DegreeHistogram normalized(DegreeHistogram histogram) {
    double sum = 0;
    for (const double count : histogram) sum += count;
    for (double& count : histogram) count = sum > 0 ? count / sum : 0;
    return histogram;
}

std::vector<std::vector<int>> neighbors_of(std::size_t count, std::span<const std::pair<int, int>> edges) {
    std::vector<std::vector<int>> neighbors(count);
    for (const auto& [a, b] : edges) {
        neighbors[static_cast<std::size_t>(a)].push_back(b);
        neighbors[static_cast<std::size_t>(b)].push_back(a);
    }
    return neighbors;
}

Point nearest_place(const ExemplarRing& ring, Point to) {
    Point nearest{std::numeric_limits<double>::infinity(), 0};
    for (const Point place : ring.offsets)
        if (abs(place - to) < abs(nearest - to)) nearest = place;
    return nearest;
}

}  // namespace

double degree_distance(const DegreeHistogram& a, const DegreeHistogram& b) {
    double sum = 0;
    for (std::size_t degree = 0; degree < std::max(a.size(), b.size()); ++degree)
        sum += std::abs((degree < a.size() ? a[degree] : 0) - (degree < b.size() ? b[degree] : 0));
    return 0.5 * sum;
}

DegreeHistogram degree_histogram(const Exemplar& exemplar) {
    DegreeHistogram histogram;
    for (const ExemplarElement& element : exemplar.elements)
        if (element.usable) count_degree(histogram, element.ring.elements.size());
    return normalized(std::move(histogram));
}

RingFit ring_fit(const Exemplar& exemplar, const std::vector<ArrangedElement>& elements,
                 std::span<const std::pair<int, int>> edges, const std::vector<bool>& asked) {
    const auto neighbors = neighbors_of(elements.size(), edges);
    RingFit fit;
    double right = 0, count = 0, places = 0, square_spacing = 0, square_ring = 0;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (!asked[i]) continue;
        const ExemplarRing& ring = exemplar.elements[static_cast<std::size_t>(elements[i].reference)].ring;
        count += 1;
        right += neighbors[i].size() == ring.elements.size() ? 1 : 0;
        count_degree(fit.degrees, neighbors[i].size());
        const Complex back = polar(1, -elements[i].angle);
        for (const int other : neighbors[i]) {
            const Point step = back * (elements[static_cast<std::size_t>(other)].position - elements[i].position);
            const Point place = nearest_place(ring, step);
            if (!(abs(place - step) <= 0.5 * exemplar.mean_edge)) {
                fit.defects += 1;
                continue;
            }
            const double longer = std::abs(abs(step) - abs(place)) / exemplar.mean_edge;
            places += 1;
            square_spacing += longer * longer;
            square_ring += norm(step - place) / (exemplar.mean_edge * exemplar.mean_edge);
            fit.largest_spacing_error = std::max(fit.largest_spacing_error, longer);
        }
    }
    fit.degrees = normalized(std::move(fit.degrees));
    if (count > 0) fit.right_degrees = right / count, fit.defects /= count;
    if (places > 0) fit.spacing_error = std::sqrt(square_spacing / places), fit.ring_error = std::sqrt(square_ring / places);
    return fit;
}

}  // namespace rinceau
