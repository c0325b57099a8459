// A face's linear map into the chart is z -> a z + b conj(z) on its flat frame: its singular values are
// |a| + |b| and |a| - |b|, and it flips where the second is negative.

#include "growth/surface/surface_chart.h"

#include <algorithm>
#include <cmath>

#include "geometry/index.h"

namespace rinceau {
namespace {

/// No place of a triangle is farther from its nearest corner than this share of its longest edge, the even triangle's.
constexpr double share_to_corner = 0.5774;
constexpr double on_edge = 1e-9;    // weights this little below 0 still are in the triangle
constexpr int most_columns = 4096;  // of a lookup's grid

struct LinearMap {
    Complex a, b;
};

LinearMap map_of(const SurfaceMesh& surface, const ChartTriangle& triangle) {
    const auto& flat = surface.flat[at(triangle.face)];  // (0, 0), (x1, 0), (x2, y2)
    const Complex by_x = (triangle.at[1] - triangle.at[0]) / flat[1].x;
    const Complex by_y = (triangle.at[2] - triangle.at[0] - flat[2].x * by_x) / flat[2].y;
    const Complex turned{-by_y.y, by_y.x};
    return {(by_x - turned) / 2, (by_x + turned) / 2};
}

double distance_from_origin(Complex a, Complex b) {
    const Complex along = b - a;
    const double length = norm(along);
    return abs(length > 0 ? a + std::clamp(-dot(a, along) / length, 0.0, 1.0) * along : a);
}

/// 0 where the origin lies inside, whichever way round the triangle is.
double distance_from_origin(const std::array<Complex, 3>& corners) {
    const double ab = cross(corners[0], corners[1]), bc = cross(corners[1], corners[2]), ca = cross(corners[2], corners[0]);
    if ((ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0)) return 0;
    return std::min({distance_from_origin(corners[0], corners[1]), distance_from_origin(corners[1], corners[2]),
                     distance_from_origin(corners[2], corners[0])});
}

double longest_side(const SurfaceMesh& surface, int face) {
    double longest = 0;
    for (int h = 3 * face; h < 3 * face + 3; ++h) longest = std::max(longest, norm(edge_vector(surface, h)));
    return std::sqrt(longest);
}

/// Is v the nearest corner of its face in the map, all of whose corners are known? Ties go to the lower vertex.
bool nearest_corner(const PolarMapper& mapper, int h) {
    const SurfaceMesh& surface = mapper.surface();
    const int v = start_of(surface, h);
    for (const int other : {end_of(surface, h), start_of(surface, previous_in_face(h))}) {
        if (!mapper.has(other)) return false;
        const double here = mapper.distance(v), there = mapper.distance(other);
        if (there < here || (there == here && other < v)) return false;
    }
    return true;
}

class ChartMaker {
  public:
    ChartMaker(const PolarMapper& mapper, SurfacePoint anchor, Complex x, double radius, double stretch)
        : mapper_(mapper), surface_(mapper.surface()), back_(conj(x)), stretch_(stretch) {
        chart_.anchor = anchor;
        chart_.radius = chart_.good_radius = radius;
    }

    SurfaceChart chart() && {
        for (const int v : mapper_.reached()) {
            const int first = surface_.outgoing[at(v)];
            int h = first;
            do {
                if (nearest_corner(mapper_, h)) add_face(face_of(h));
                h = next_about_start(surface_, h);
            } while (h >= 0 && h != first);
        }
        chart_.meets_border = chart_.border_distance < chart_.radius;
        return std::move(chart_);
    }

  private:
    void add_face(int face) {
        ChartTriangle triangle{face, {}};
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < 3; ++k) {
            const int v = surface_.mesh.triangles[at(face)][k];
            triangle.at[k] = polar(mapper_.distance(v), mapper_.angle(v)) * back_;
            nearest = std::min(nearest, mapper_.distance(v));
        }
        const double distance = distance_from_origin(triangle.at);
        const ChartStretch stretch = stretch_of(surface_, triangle);
        if (stretch.smallest < 1 / stretch_ || stretch.largest > stretch_) {
            // behind the cut locus a face is drawn right across the chart, and so its place there tells nothing
            const double known = nearest - share_to_corner * longest_side(surface_, face);
            chart_.good_radius = std::max(0.0, std::min(chart_.good_radius, std::max(distance, known)));
            return;
        }
        if (distance > chart_.radius) return;
        for (std::size_t k = 0; k < 3; ++k)
            if (surface_.twin[at(3 * face) + k] < 0)
                chart_.border_distance =
                    std::min(chart_.border_distance, distance_from_origin(triangle.at[k], triangle.at[(k + 1) % 3]));
        chart_.triangles.push_back(triangle);
    }

    const PolarMapper& mapper_;
    const SurfaceMesh& surface_;
    Complex back_;
    double stretch_;
    SurfaceChart chart_;
};

std::array<Complex, 2> box_of(const ChartTriangle& triangle) {
    const auto& [a, b, c] = triangle.at;
    return {Complex{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})},
            Complex{std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})}};
}

/// Weights of the corners at a place of the chart.
std::array<double, 3> weights_at(const ChartTriangle& triangle, Complex place) {
    const auto& [a, b, c] = triangle.at;
    const double whole = cross(b - a, c - a), of_b = cross(place - a, c - a) / whole, of_c = cross(b - a, place - a) / whole;
    return {1 - of_b - of_c, of_b, of_c};
}

}  // namespace

ChartStretch stretch_of(const SurfaceMesh& surface, const ChartTriangle& triangle) {
    const LinearMap map = map_of(surface, triangle);
    const double a = abs(map.a), b = abs(map.b);
    return {a + b, a - b};
}

SurfaceChart surface_chart(PolarMapper& mapper, SurfacePoint anchor, Complex x, double radius, const ChartOptions& options) {
    mapper.map(anchor, radius);
    return ChartMaker(mapper, anchor, x, radius, options.stretch).chart();
}

SurfaceChart surface_chart(const SurfaceMesh& surface, SurfacePoint anchor, Complex x, double radius,
                           const ChartOptions& options) {
    PolarMapper mapper(surface);
    return surface_chart(mapper, anchor, x, radius, options);
}

ChartLookup::ChartLookup(const SurfaceMesh& surface, const SurfaceChart& chart) : surface_(&surface), chart_(&chart) {
    double reach = 0;
    for (const ChartTriangle& triangle : chart.triangles)
        for (const Complex corner : triangle.at) reach = std::max({reach, std::abs(corner.x), std::abs(corner.y)});
    // about one triangle in a cell
    columns_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(chart.triangles.size()))), 1, most_columns);
    low_ = -reach;
    cell_ = reach > 0 ? 2 * reach / columns_ : 1;
    std::vector<std::size_t> count(at(columns_ * columns_) + 1, 0);
    const auto each_cell = [&](auto&& visit) {
        for (std::size_t i = 0; i < chart.triangles.size(); ++i) {
            const auto [low, high] = box_of(chart.triangles[i]);
            for (int row = cell_of(low.y); row <= cell_of(high.y); ++row)
                for (int column = cell_of(low.x); column <= cell_of(high.x); ++column)
                    visit(at(row * columns_ + column), static_cast<int>(i));
        }
    };
    each_cell([&](std::size_t cell, int) { ++count[cell + 1]; });
    for (std::size_t i = 1; i < count.size(); ++i) count[i] += count[i - 1];
    first_ = count;
    list_.resize(first_.back());
    each_cell([&](std::size_t cell, int triangle) { list_[count[cell]++] = triangle; });
}

int ChartLookup::cell_of(double coordinate) const {
    return static_cast<int>(std::clamp((coordinate - low_) / cell_, 0.0, columns_ - 1.0));
}

std::optional<ChartPlace> ChartLookup::find(Complex place) const {
    const std::size_t cell = at(cell_of(place.y) * columns_ + cell_of(place.x));
    double best = -on_edge;
    int found = -1;
    for (std::size_t i = first_[cell]; i < first_[cell + 1]; ++i) {
        const double least = std::ranges::min(weights_at(chart_->triangles[at(list_[i])], place));
        if (least > best) best = least, found = list_[i];
    }
    if (found < 0) return std::nullopt;
    const ChartTriangle& triangle = chart_->triangles[at(found)];
    auto weights = weights_at(triangle, place);
    for (double& weight : weights) weight = std::max(weight, 0.0);
    const double sum = weights[0] + weights[1] + weights[2];
    for (double& weight : weights) weight /= sum;
    // the direction that the face's map takes to +x
    const LinearMap map = map_of(*surface_, triangle);
    const Complex x = conj(map.a) - map.b;
    return ChartPlace{from_barycentric(*surface_, triangle.face, weights), x / abs(x)};
}

}  // namespace rinceau
