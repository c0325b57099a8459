#include <catch2/catch.hpp>

#include "geometry/random.h"
#include "scene/input_error.h"
#include "scene/svg_document.h"
#include "scene/svg_path_data.h"
#include "scene/svg_raster.h"
#include "scene/svg_transform.h"
#include "scene/svg_write.h"

using namespace rinceau;

static const Affine flip{1, 0, 0, -1, 0, 0};

static std::vector<Path> random_paths(Random& random) {
    const auto point = [&] { return Point{random.uniform(-1e3, 1e3), random.uniform(-1, 1)}; };
    std::vector<Path> paths;
    for (int i = 0; i < 5; ++i) {
        Path path{point(), {}, random.below(2) == 0};
        for (std::uint64_t k = random.below(5); k-- > 0;) {
            path.segments.push_back(random.below(2) == 0 ? line_to(point()) : curve_to(point(), point(), point()));
        }
        if (path.segments.empty()) path.closed = true;
        paths.push_back(path);
    }
    return paths;
}

TEST_CASE("path data read back are the same paths, bit by bit") {
    Random random(21);
    for (int i = 0; i < 100; ++i) {
        const std::vector<Path> paths = random_paths(random);
        const ParsedPath parsed = parse_path_data(svg_path_data(paths));
        CHECK_FALSE(parsed.faulty);
        CHECK(transformed(parsed.paths, flip) == paths);
    }
    CHECK(svg_path_data({{{1.23456, -2}, {line_to({0.5, 0})}, true}}, 3) == "M1.23 2L0.5 0Z");
}

TEST_CASE("transforms read back are the same maps, bit by bit") {
    const Affine maps[] = {
        {}, {1, 0, 0, 1, 5, -6}, {2, 0, 0, 2, 0, 0}, {2, 0, 0, -3, 0, 0}, {0.1, 0.2, -0.3, 0.4, 5, 6}, {2, 0, 0, 2, 1, 0}};
    for (const Affine& map : maps) {
        const std::string text = svg_transform_text(map);
        CAPTURE(text);
        CHECK(flip * parse_transform_attribute(text).map.value() * flip == map);
    }
    CHECK(svg_transform_text({}).empty());
}

static Scene small_scene() {
    Scene scene;
    scene.viewport = {{0, -20}, {30, 0}};
    Element plain;
    plain.id = "a<b";
    plain.paths = {{{1, -1}, {line_to({9, -1}), line_to({9, -9})}, true}};
    Element rich = plain;
    Gradient gradient;
    gradient.stops = {{0, {255, 0, 0}, 1}, {1, {0, 0, 255}, 0.5}};
    gradient.map = {10, 0, 0, 10, 10, 0};
    rich.style.fill = std::make_shared<const Gradient>(gradient);
    rich.style.stroke.paint = Color{0x12, 0x34, 0x56};
    rich.style.stroke.dashes = {1, 2};
    rich.style.stroke_first = true;
    rich.style.stroke.pen = {3, 0, 0, 1};
    Element verbatim;
    verbatim.verbatim = "<text x=\"3\">paint0f</text>";
    scene.elements = {plain, verbatim, rich};
    return scene;
}

TEST_CASE("a written scene is well-formed, in paint order, with unique ids and gradients that are found") {
    const auto document = parse_svg_document(write_svg(small_scene()));
    const tinyxml2::XMLElement* root = document->RootElement();
    CHECK(root->Attribute("viewBox") == std::string("0 0 30 20"));
    const tinyxml2::XMLElement* definitions = root->FirstChildElement("defs");
    REQUIRE(definitions);
    const std::string gradient = definitions->FirstChildElement("linearGradient")->Attribute("id");
    CHECK(gradient.find("paint0") == std::string::npos);
    const tinyxml2::XMLElement* plain = definitions->NextSiblingElement();
    CHECK(plain->Attribute("id") == std::string("a<b"));
    CHECK(plain->Attribute("d") == std::string("M1 1L9 1L9 9Z"));
    const tinyxml2::XMLElement* text = plain->NextSiblingElement();
    CHECK(text->Name() == std::string("text"));
    const tinyxml2::XMLElement* rich = text->NextSiblingElement();
    CHECK(rich->Attribute("fill") == "url(#" + gradient + ")");
    CHECK(rich->Attribute("id") == nullptr);
    CHECK(rich->Attribute("transform") == std::string("scale(3 1)"));
    CHECK(rich->Attribute("paint-order") == std::string("stroke"));
    CHECK(rich->NextSiblingElement() == nullptr);
}

TEST_CASE("a scene without size writes none") {
    CHECK(svg_root_tag({{0, -20}, {30, 0}}, false).find("viewBox") == std::string::npos);
}

TEST_CASE("pictures have the asked size and are the same each time") {
    const std::string svg = write_svg(small_scene());
    const std::string png = svg_to_png(svg, 60);
    REQUIRE(png.size() > 24);
    CHECK(png.substr(1, 3) == "PNG");
    // width and height stand big-endian from byte 16 on
    CHECK(static_cast<unsigned char>(png[19]) == 60);
    CHECK(static_cast<unsigned char>(png[23]) == 40);
    CHECK(svg_to_png(svg, 60) == png);
    const std::string pdf = svg_to_pdf(svg);
    CHECK(pdf.starts_with("%PDF"));
    CHECK(pdf.find("MediaBox [ 0 0 22.5 15 ]") != std::string::npos);
    CHECK(svg_to_pdf(svg) == pdf);
}

TEST_CASE("a document that the renderer cannot read is an input error, too large a picture a limit") {
    CHECK_THROWS_AS(svg_to_png("<svg"), InputError);
    CHECK_THROWS_AS(svg_to_pdf("no svg"), InputError);
    CHECK_THROWS_AS(svg_to_png(write_svg(small_scene()), 40000), LimitError);
}
