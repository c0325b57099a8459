#include "growth/surface/shape_sources.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "geometry/polygon.h"

namespace rinceau {
namespace {

constexpr const char* all_kinds[] = {"box",  "tile",    "cylinder", "sphere", "ellipsoid", "torus", "disc", "ellipse",
                                     "cone", "pyramid", "prism",    "star",   "leaf",      "arrow", "glyph"};

std::string drawn(const std::string& name) {
    if (name == "ring.svg")  // a frame with an island: three rings, one of them a hole
        return "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='50'>"
               "<path fill='#c00000' fill-rule='evenodd' d='M0 0 H100 V50 H0 Z M20 10 H80 V40 H20 Z'/>"
               "<rect x='40' y='20' width='20' height='10' fill='#00c000'/></svg>";
    if (name == "round.svg")
        return "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'><circle cx='60' cy='50' r='20'/></svg>";
    if (name == "empty.svg") return "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/>";
    if (name == "wedge.obj") return "v 1 1 1\nv 5 1 1\nv 1 3 1\nv 1 1 2\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    throw InputError({name}, "expected the name of a file that is there");
}

GrammarShape made(const std::string& kind, const std::string& text = {}, std::map<std::string, double> numbers = {},
                  std::map<std::string, std::string> words = {}) {
    ShapeSource source{.name = "it", .kind = kind, .text = text, .words = std::move(words), .place = {"g.fgsg", 3, 7}};
    for (const auto& [name, value] : numbers) source.numbers.emplace(name, number_expression(value));
    return make_shape(source, drawn, [](const Expression& e) { return e.postfix.front().number; });
}

/// Every edge has its twin, every triangle an area, and the volume is positive: normals point outwards.
double checked_volume(const TriangleMesh& mesh) {
    std::map<std::pair<int, int>, int> edges;
    double volume = 0;
    for (const auto& t : mesh.triangles) {
        const auto p = [&](std::size_t k) { return mesh.positions[static_cast<std::size_t>(t[k])]; };
        CHECK(abs(cross(p(1) - p(0), p(2) - p(0))) > 1e-9);
        volume += dot(p(0), cross(p(1), p(2))) / 6;
        for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    }
    int open = 0;
    for (const auto& [edge, count] : edges) open += count != 1 || !edges.contains({edge.second, edge.first});
    CHECK(open == 0);
    return volume;
}

std::string message_of(const std::string& kind, const std::string& text = {}, std::map<std::string, double> numbers = {},
                       std::map<std::string, std::string> words = {}) {
    try {
        made(kind, text, std::move(numbers), std::move(words));
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("every kind of shape is a closed mesh that fills the scope, its normals outwards") {
    for (const char* kind : all_kinds) {
        INFO(kind);
        const GrammarShape shape = made(kind);
        CHECK(checked_volume(shape.mesh) > 0.01);
        CHECK(shape.low.x == Approx(-0.5).margin(0.1));
        CHECK(shape.high.x == Approx(0.5).margin(0.005));
        CHECK(shape.high.y == Approx(0.5).margin(0.07));
        CHECK(shape.low.y == Approx(-0.5).margin(0.07));
        CHECK(((shape.low.z == 0 && shape.high.z == 1) || shape.low.z == Approx(-shape.high.z)));
        CHECK(!shape.outline.empty());
        CHECK(signed_area(shape.hull) > 0.3);
    }
}

TEST_CASE("volumes come near those of the round bodies as the detail rises") {
    constexpr double pi_ = 3.14159265358979;
    CHECK(checked_volume(made("box").mesh) == Approx(1));
    CHECK(checked_volume(made("sphere", {}, {{"detail", 60}}).mesh) == Approx(pi_ / 6).epsilon(0.01));
    CHECK(checked_volume(made("torus", {}, {{"detail", 80}, {"tube", 0.1}}).mesh) ==
          Approx(2 * pi_ * 0.4 * pi_ * 0.01).epsilon(0.01));
    CHECK(checked_volume(made("cylinder", {}, {{"detail", 80}}).mesh) == Approx(pi_ / 4).epsilon(0.01));
    CHECK(checked_volume(made("cone", {}, {{"detail", 80}}).mesh) == Approx(pi_ / 12).epsilon(0.01));
    CHECK(checked_volume(made("disc", {}, {{"detail", 80}, {"height", 0.5}}).mesh) == Approx(pi_ / 8).epsilon(0.01));
    CHECK(checked_volume(made("tile", {}, {{"round", 0}, {"bevel", 0}}).mesh) == Approx(1));
    CHECK(checked_volume(made("tile").mesh) < 0.99);
    CHECK(checked_volume(made("tile").mesh) > 0.9);
}

TEST_CASE("the number of faces can be chosen") {
    CHECK(made("torus").mesh.triangles.size() == 576);
    for (const double faces : {100.0, 1000.0}) {
        for (const char* kind : {"sphere", "torus", "disc", "leaf"}) {
            INFO(kind << ' ' << faces);
            CHECK(double(made(kind, {}, {{"faces", faces}}).mesh.triangles.size()) == Approx(faces).epsilon(0.25));
        }
    }
    const std::size_t coarse = made("outline", "round.svg", {{"faces", 40}}).mesh.triangles.size();
    CHECK(coarse >= 20);
    CHECK(coarse <= 60);
    CHECK(made("outline", "round.svg", {{"faces", 400}}).mesh.triangles.size() > 4 * coarse);
}

TEST_CASE("a drawing becomes one solid with its holes, as high as said, in the colour that covers most") {
    const GrammarShape ring = made("outline", "ring.svg", {{"height", 0.3}});
    // 100 x 50 without 60 x 30, with 20 x 10, on the page of 100 x 50.
    CHECK(checked_volume(ring.mesh) == Approx(0.3 * (5000 - 1800 + 200) / 5000).epsilon(1e-6));
    CHECK(ring.color == Color{0xc0, 0, 0});
    CHECK(ring.low == SpacePoint{-0.5, -0.5, 0});
    CHECK(ring.high.z == 0.3);
    CHECK(ring.collide == CollideAs::hull);
    CHECK(ring.hull.size() == 4);
    CHECK(made("outline", "ring.svg", {}, {{"colour", "#010203"}}).color == Color{1, 2, 3});
}

TEST_CASE("a drawing fills the scope with its page or with its ink") {
    const GrammarShape page = made("outline", "round.svg"), ink = made("outline", "round.svg", {}, {{"fit", "ink"}});
    CHECK(page.low.x == Approx(-0.1).margin(1e-3));
    CHECK(page.high.x == Approx(0.3).margin(1e-3));
    CHECK(page.high.y == Approx(0.2).margin(1e-3));
    CHECK(ink.low.x == Approx(-0.5).margin(1e-3));
    CHECK(ink.high.x == Approx(0.5).margin(1e-3));
}

TEST_CASE("a mesh is scaled as a whole and stands on the surface") {
    const GrammarShape wedge = made("mesh", "wedge.obj");
    CHECK(checked_volume(wedge.mesh) == Approx(4.0 * 2 * 1 / 6 / 64));
    CHECK(wedge.low == SpacePoint{-0.5, -0.25, 0});
    CHECK(wedge.high == SpacePoint{0.5, 0.25, 0.25});
    CHECK(wedge.hull.size() == 3);
    const GrammarShape turned = made("mesh", "wedge.obj", {}, {{"up", "y"}, {"collide", "hull"}});
    CHECK(checked_volume(turned.mesh) == Approx(4.0 * 2 * 1 / 6 / 64));
    CHECK(turned.high.z == Approx(0.5));
    CHECK(turned.collide == CollideAs::hull);
}

TEST_CASE("what is wrong with a source is said with its place, and what is possible") {
    CHECK(message_of("blob") ==
          "g.fgsg:3:7: the shape 'it': expected a kind among box, tile, cylinder, sphere, ellipsoid, torus, disc, ellipse, "
          "cone, pyramid, prism, star, leaf, arrow, glyph, outline or mesh, found 'blob'");
    CHECK(message_of("disc", {}, {{"tube", 1}}) ==
          "g.fgsg:3:7: the disc 'it': expected a setting among height, detail, faces, collide or colour, found 'tube'");
    CHECK(message_of("torus", {}, {{"tube", 0.4}}) ==
          "g.fgsg:3:7: the torus 'it': expected a number from 0.01 to 0.24 for tube, found 0.4");
    CHECK(message_of("prism", {}, {{"sides", 4.5}}) ==
          "g.fgsg:3:7: the prism 'it': expected a whole number from 3 to 1000 for sides, found 4.5");
    CHECK(message_of("disc", {}, {}, {{"collide", "sphere"}}) ==
          "g.fgsg:3:7: the disc 'it': expected disc, box, hull or outline for collide, found 'sphere'");
    CHECK(message_of("disc", {}, {}, {{"height", "tall"}}) ==
          "g.fgsg:3:7: the disc 'it': expected a number for height, found a word");
    CHECK(message_of("box", {}, {}, {{"colour", "reddish"}}) ==
          "g.fgsg:3:7: the shape 'it': expected a colour such as \"#d9a441\", found 'reddish'");
    CHECK(message_of("outline") == "g.fgsg:3:7: the shape 'it': expected a file name in quotation marks behind outline");
    CHECK(message_of("box", "x.obj") == "g.fgsg:3:7: the shape 'it': expected settings behind box, found \"x.obj\"");
    CHECK(message_of("outline", "empty.svg") ==
          "empty.svg: expected paths that are filled or drawn, found none: text and pictures make no shape");
    CHECK(message_of("outline", "gone.svg") == "g.fgsg:3:7: gone.svg: expected the name of a file that is there");
}

}  // namespace rinceau
