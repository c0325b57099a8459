// Points and curves.

#include "geometry/cubic_bezier.h"
#include "geometry/delaunay.h"
#include "geometry/kd_tree.h"
#include "geometry/random.h"
#include "made_inputs.h"
#include "sizes.h"

namespace rinceau::bench {
namespace {

void kd_tree_build(benchmark::State& state) {
    const std::vector<Point> points = strewn_points(size_of(state));
    for (auto _ : state) benchmark::DoNotOptimize(KdTree(points));
    set_size(state, points.size());
}
BENCHMARK(kd_tree_build)->Apply(to_100000);

void kd_tree_nearest_8(benchmark::State& state) {
    const std::vector<Point> points = strewn_points(size_of(state));
    const KdTree tree(points);
    constexpr std::size_t neighbours = 8;
    for (auto _ : state) benchmark::DoNotOptimize(tree.nearest_others(neighbours));
    set_size(state, points.size());
}
BENCHMARK(kd_tree_nearest_8)->Apply(to_100000);

void delaunay_triangles(benchmark::State& state) {
    const std::vector<Point> points = strewn_points(size_of(state));
    for (auto _ : state) benchmark::DoNotOptimize(delaunay(points));
    set_size(state, points.size());
}
BENCHMARK(delaunay_triangles)->Apply(to_100000);

/// Curves across a box of 100 to a twentieth of its unit.
void curve_flattening(benchmark::State& state) {
    Random random(2);
    std::vector<CubicBezier> curves;
    const auto point = [&] {
        const double x = random.uniform(0, 100);
        return Point{x, random.uniform(0, 100)};
    };
    for (int i = 0; i < size_of(state); ++i) {
        const Point from = point(), control1 = point(), control2 = point();
        curves.push_back({from, control1, control2, point()});
    }
    constexpr double deviation = 0.05;
    for (auto _ : state) {
        for (const CubicBezier& curve : curves) benchmark::DoNotOptimize(flattened(curve, deviation));
    }
    set_size(state, curves.size());
}
BENCHMARK(curve_flattening)->Apply(to_100000);

}  // namespace
}  // namespace rinceau::bench
