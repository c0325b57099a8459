#include <catch2/catch.hpp>

#include "derivation_world.h"

using namespace rinceau;

namespace {

double distance_to(const PatternLine& line, SpacePoint p) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        const SpacePoint a = line.points[i - 1], along = line.points[i] - a;
        const double length = dot(along, along);
        const double share = length > 0 ? std::clamp(dot(p - a, along) / length, 0.0, 1.0) : 0;
        best = std::min(best, abs(a + share * along - p));
    }
    return best;
}

const std::string cracks = R"(
param u = 0.06
axiom scatter 3 [Start(0)] [Rz(120) Start(0)] [Rz(240) Start(0)]
Start(k) ~ Line(1) Crack(0,k)
Crack(n,k) : n < 60 ~ LineSeg(u,0.012) Rz(rand(-10,10)) Fork(n,k)
Fork(n,k) ~ Crack(n+1,k) : 0.9
Fork(n,k) : k < 4 && n > 2 ~ Crack(n+1,k) [Rz(if(rand()<0.5,70,-70)) T(u*0.3,0,0) Start(k+1)] : 0.1
)";

}  // namespace

TEST_CASE("a line that meets another ends on it") {
    const std::string text = R"(
axiom nearest 2 5 0 Line(0) LineSeg(6,0.1)
axiom nearest 5 2 0 Rz(80) Line(1) LineSeg(5,0.1) LineSeg(1,0.1)
)";
    const SurfacePattern pattern = grown(text, plane_world());
    REQUIRE(pattern.lines.size() == 2);
    CHECK(pattern.lines[1].merged);
    CHECK(pattern.lines[1].segments == 1);
    CHECK(pattern.counts.merged_lines == 1);
    const SpacePoint end = pattern.lines[1].points.back();
    CHECK(abs(end - SpacePoint{5 + 3 / std::tan(radians(80)), 5, 0}) < 1e-9);
    CHECK(abs(position_in_space(*plane_world().surface, pattern.lines[1].at.back()) - end) < 1e-9);
}

TEST_CASE("lines without merging cross") {
    const SurfacePattern pattern = grown(
        "axiom nearest 2 5 0 Line(0) LineSeg(6,0.1)\n"
        "axiom nearest 5 2 0 Rz(80) Line(0) LineSeg(5,0.1) LineSeg(1,0.1)\n",
        plane_world());
    REQUIRE(pattern.lines.size() == 2);
    CHECK_FALSE(pattern.lines[1].merged);
    CHECK(pattern.lines[1].segments == 2);
}

TEST_CASE("segments are one line as long as their scope stands at its end") {
    const SurfacePattern pattern = grown(
        "axiom nearest 5 5 0 Line(0) LineSeg(1,0.1) [Rz(90) LineSeg(1,0.1)] LineSeg(1,0.2) T(0.5,0,0) LineSeg(0.5,0.1)\n",
        plane_world());
    REQUIRE(pattern.lines.size() == 3);
    CHECK(abs(pattern.lines[0].points.back() - SpacePoint{6, 6, 0}) < 1e-9);  // the bracket came first
    CHECK(abs(pattern.lines[1].points.front() - SpacePoint{6, 5, 0}) < 1e-9);
    CHECK(abs(pattern.lines[1].points.back() - SpacePoint{7, 5, 0}) < 1e-9);
    CHECK(abs(pattern.lines[2].points.front() - SpacePoint{7.5, 5, 0}) < 1e-9);
}

TEST_CASE("every point of a line lies on the surface, and cracks end on older lines") {
    const SurfaceWorld world = bare_world(sphere_triangles(4));
    const SurfacePattern pattern = grown(cracks, world);
    CHECK(pattern.complete);
    CHECK(pattern.counts.merged_lines > 5);
    int merged = 0;
    for (std::size_t i = 0; i < pattern.lines.size(); ++i) {
        const PatternLine& line = pattern.lines[i];
        REQUIRE(line.at.size() == line.points.size());
        REQUIRE(line.normals.size() == line.points.size());
        REQUIRE(line.widths.size() == line.points.size());
        for (std::size_t k = 0; k < line.points.size(); ++k)
            CHECK(abs(position_in_space(*world.surface, line.at[k]) - line.points[k]) < 1e-9);
        if (!line.merged) continue;
        ++merged;
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t j = 0; j < pattern.lines.size(); ++j)
            if (j != i) nearest = std::min(nearest, distance_to(pattern.lines[j], line.points.back()));
        CHECK(nearest < 1e-9);
    }
    CHECK(merged == pattern.counts.merged_lines);
}

TEST_CASE("a line whose end merges with a node ends at the node, on a curved surface too") {
    const std::string text = R"(
shape node = disc
axiom vertex 3 Node(0)
Node(k) ~ S(0.05,0.05,0.05) IM("node",0.16,180) [Rz(60) Out(k)] [Rz(-60) Out(k)] [Rz(180) Out(k)]
Out(k) ~ Line(0) LineSeg(0.3,0.02) Node(k+1)
)";
    const SurfacePattern pattern = grown(text, bare_world(torus_triangles(60, 30, 1.2, 0.5)));
    CHECK(pattern.complete);
    CHECK(pattern.placed.size() > 50);
    CHECK(pattern.counts.merged_points > 50);
    for (const PatternLine& line : pattern.lines)
        for (const SpacePoint end : {line.points.front(), line.points.back()}) {
            double nearest = std::numeric_limits<double>::infinity();
            for (const PatternShape& node : pattern.placed) nearest = std::min(nearest, abs(node.position - end));
            CHECK(nearest < 1e-9);
        }
}

TEST_CASE("a line through a chart lies on the surface and closes its ring") {
    const std::string text = R"(
axiom vertex 40 Chart{ T(0.4,0,0) Rz(105) Line(0) Round(0) }
Round(i) : i < 12 ~ LineSeg(0.8*sin(15),0.02) Rz(30) Round(i+1)
)";
    const SurfaceWorld world = bare_world(sphere_triangles(4));
    const SurfacePattern pattern = grown(text, world);
    REQUIRE(pattern.lines.size() == 1);
    const PatternLine& ring = pattern.lines[0];
    CHECK(ring.segments == 12);
    CHECK(abs(ring.points.front() - ring.points.back()) < 1e-9);
    for (std::size_t k = 0; k < ring.points.size(); ++k) {
        CHECK(abs(position_in_space(*world.surface, ring.at[k]) - ring.points[k]) < 1e-12);
        if (k > 0) CHECK(abs(ring.points[k] - ring.points[k - 1]) < 0.03);
    }
}
