// Pictures by real OpenGL: single pixels whose colour is known, and whole drawings against librsvg.

#include "editor/gl/picture_renderer.h"

#include <array>
#include <catch2/catch.hpp>
#include <limits>
#include <optional>

#include "editor/gl/thumbnails.h"
#include "hidden_window.h"
#include "scene/svg_raster.h"
#include "scene/svg_read.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

constexpr int side = 40;  // pixels of a frame, units of a drawing

using Rgb = std::array<int, 3>;

struct Frame {
    std::vector<std::uint8_t> pixels;
    Rgb at(int x, int y) const {
        const std::uint8_t* pixel = &pixels[static_cast<std::size_t>(4 * (y * side + x))];
        return {pixel[0], pixel[1], pixel[2]};
    }
};

std::shared_ptr<DerivedPicture> drawn(const std::string& shapes) {
    const std::string svg = "<svg xmlns='http://www.w3.org/2000/svg' width='40' height='40'>" + shapes + "</svg>";
    return std::make_shared<DerivedPicture>(drawing_picture(read_svg(svg).scene));
}

ViewTransform whole_view(const DerivedPicture& picture) {
    return {.center = center(picture.grammar->canvas), .zoom = 1, .size = {side, side}};
}

Frame frame(PictureRenderer& renderer, const std::shared_ptr<const DerivedPicture>& picture,
            const PictureEmphasis& emphasis = {}) {
    const unsigned texture = renderer.draw(picture, whole_view(*picture), emphasis, {.surround = {}, .finish = true});
    Frame result{texture_pixels(texture, side, side)};
    CHECK_FALSE(opengl_complains());
    return result;
}

Frame frame(const std::string& shapes) {
    PictureRenderer renderer;
    return frame(renderer, drawn(shapes));
}

bool alike(const Rgb& a, const Rgb& b, int tolerance = 2) {
    for (std::size_t k = 0; k < a.size(); ++k)
        if (std::abs(a[k] - b[k]) > tolerance) return false;
    return true;
}

constexpr Rgb white{255, 255, 255}, red{255, 0, 0}, green{0, 128, 0}, blue{0, 0, 255};

ItemFlags flags(std::vector<char> values) { return std::make_shared<const std::vector<char>>(std::move(values)); }

const std::string two_squares =
    "<rect x='5' y='5' width='20' height='20' fill='red'/><rect x='15' y='15' width='20' height='20' fill='blue'/>";

}  // namespace

TEST_CASE("what comes later lies above, whatever its kind of paint") {
    const HiddenWindow window;
    const Frame opaque = frame(two_squares);
    CHECK(opaque.at(10, 10) == red);
    CHECK(opaque.at(20, 20) == blue);
    CHECK(opaque.at(2, 2) == white);
    // half blue over red, half white over that, red over all
    const Frame mixed = frame(
        "<rect width='40' height='40' fill='red'/><rect width='40' height='20' fill='blue' fill-opacity='.5'/>"
        "<rect width='20' height='40' fill='white' fill-opacity='.5'/><rect width='5' height='40' fill='green'/>");
    CHECK(alike(mixed.at(30, 10), {127, 0, 128}));
    CHECK(alike(mixed.at(10, 10), {191, 128, 191}));
    CHECK(alike(mixed.at(10, 30), {255, 128, 128}));
    CHECK(mixed.at(2, 10) == green);
}

TEST_CASE("holes follow the fill rule") {
    const HiddenWindow window;
    const std::string nested = " d='M5 5H35V35H5Z M12 12H28V28H12Z'/>";
    CHECK(frame("<path fill='red' fill-rule='evenodd'" + nested).at(20, 20) == white);
    CHECK(frame("<path fill='red'" + nested).at(20, 20) == red);
}

TEST_CASE("edges are as dark as the share of the pixel that they cover") {
    const HiddenWindow window;
    const Frame half = frame("<rect x='10.5' y='10' width='10' height='10' fill='black'/>");
    CHECK(alike(half.at(10, 15), {128, 128, 128}, 8));
    CHECK(half.at(15, 15) == Rgb{0, 0, 0});
    const Frame crisp = frame("<rect x='10.4' y='10' width='10' height='10' shape-rendering='crispEdges'/>");
    CHECK(crisp.at(10, 15) == Rgb{0, 0, 0});
    CHECK(crisp.at(20, 15) == white);
}

TEST_CASE("opacity is of fill and stroke together") {
    const HiddenWindow window;
    const std::string shape = "<rect x='10' y='10' width='20' height='20' fill='red' stroke='blue' stroke-width='8'";
    const Frame together = frame(shape + " opacity='.5'/>");
    CHECK(alike(together.at(20, 20), {255, 128, 128}));
    CHECK(alike(together.at(12, 20), {128, 128, 255}));  // no red shines through the inner half of the line
    const Frame apart = frame(shape + " fill-opacity='.5' stroke-opacity='.5'/>");
    CHECK(alike(apart.at(12, 20), {128, 64, 191}));
    // The line lets the fill through, and both together the white: .5 (.5 blue + .5 red) + .5 white
    const Frame nested = frame(shape + " opacity='.5' stroke-opacity='.5'/>");
    CHECK(alike(nested.at(12, 20), {191, 128, 191}));
    CHECK(alike(nested.at(20, 20), {255, 128, 128}));
    CHECK(alike(nested.at(8, 20), {191, 191, 255}));
}

TEST_CASE("gradients run as their stops say, and go on as their spread says") {
    const HiddenWindow window;
    const std::string stops = "<stop stop-color='black'/><stop offset='1' stop-color='white'/>";
    const auto linear = [&](const std::string& spread) {
        return frame("<linearGradient id='g' gradientUnits='userSpaceOnUse' x1='10' x2='30' spreadMethod='" + spread + "'>" +
                     stops + "</linearGradient><rect width='40' height='40' fill='url(#g)'/>");
    };
    CHECK(alike(linear("pad").at(19, 20), {121, 121, 121}, 4));
    CHECK(linear("pad").at(35, 20) == white);
    CHECK(alike(linear("reflect").at(35, 20), {185, 185, 185}, 4));
    CHECK(alike(linear("repeat").at(35, 20), {70, 70, 70}, 4));
    const Frame radial = frame("<radialGradient id='g' gradientUnits='userSpaceOnUse' cx='20' cy='20' r='20'>" + stops +
                               "</radialGradient><rect width='40' height='40' fill='url(#g)'/>");
    CHECK(alike(radial.at(30, 20), {134, 134, 134}, 4));
    CHECK(alike(radial.at(20, 20), {9, 9, 9}, 4));
    CHECK(radial.at(0, 0) == white);
}

TEST_CASE("verbatim parts have librsvg's own pixels, in paint order") {
    const HiddenWindow window;
    const std::string text =
        "<text x='3' y='30' font-size='30' fill='blue'>Wm</text><rect x='20' width='20' height='40' fill='red'/>";
    const std::string svg = "<svg xmlns='http://www.w3.org/2000/svg' width='40' height='40'>" + text + "</svg>";
    const Picture expected = svg_to_picture(svg, side);
    const Frame result = frame(text);
    int ink = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const std::uint8_t* pixel = &expected.rgb[static_cast<std::size_t>(3 * (y * side + x))];
            CHECK(alike(result.at(x, y), {pixel[0], pixel[1], pixel[2]}, 3));
            ink += x < 20 && pixel[0] < 128 ? 1 : 0;
        }
    }
    CHECK(ink > 20);
}

TEST_CASE("what is not lit fades, what is lit is seen") {
    const HiddenWindow window;
    PictureRenderer renderer;
    const auto picture = drawn(two_squares);
    const Frame lit = frame(renderer, picture, {.lit = flags({1, 0})});
    CHECK(lit.at(10, 10) == red);
    CHECK(alike(lit.at(30, 30), {217, 217, 255}));
    CHECK(alike(lit.at(20, 20), {217, 0, 38}, 3));  // lit, but covered by what is faded
}

TEST_CASE("a line goes around what is selected, also where something covers it") {
    const HiddenWindow window;
    PictureRenderer renderer;
    const PictureSurround surround;
    const Rgb accent{surround.accent.red, surround.accent.green, surround.accent.blue};
    const Frame outlined = frame(renderer, drawn(two_squares), {.outlined = flags({1})});
    CHECK(outlined.at(4, 15) == accent);
    CHECK(outlined.at(25, 20) == accent);
    CHECK(outlined.at(10, 10) == red);
    CHECK(outlined.at(1, 1) == white);
}

TEST_CASE("a comparison shows where two pictures differ") {
    const HiddenWindow window;
    PictureRenderer renderer;
    PictureEmphasis emphasis{.before = drawn("<rect x='5' y='5' width='20' height='20' fill='red'/>"),
                             .comparison = PictureComparison::difference};
    const Frame difference = frame(renderer, drawn(two_squares), emphasis);
    const PictureSurround surround;
    CHECK(difference.at(30, 30) == Rgb{surround.accent.red, surround.accent.green, surround.accent.blue});
    CHECK(alike(difference.at(10, 10), {255, 191, 191}));
    emphasis.comparison = PictureComparison::onion;
    const Frame onion = frame(renderer, drawn("<rect x='30' y='30' width='5' height='5'/>"), emphasis);
    CHECK(onion.at(2, 2) == white);
    CHECK_FALSE(onion.at(10, 10) == white);
    CHECK(onion.at(32, 32) == Rgb{0, 0, 0});
}

TEST_CASE("the same picture gives the same bytes, whatever was drawn before") {
    const HiddenWindow window;
    const auto picture = drawn("<circle cx='20' cy='20' r='13' fill='red' stroke='blue' opacity='.7'/>" + two_squares);
    PictureRenderer fresh, used;
    frame(used, drawn(two_squares));
    used.draw(picture, {.center = {3, 4}, .zoom = 7, .size = {90, 50}});
    CHECK(frame(fresh, picture).pixels == frame(used, picture).pixels);
}

TEST_CASE("a frame is refined until it is the finished one") {
    const HiddenWindow window;
    PictureRenderer renderer;
    const auto picture = drawn("<circle cx='20' cy='20' r='13' fill='red'/>");
    unsigned texture = renderer.draw(picture, whole_view(*picture));
    for (int k = 0; k < 100 && renderer.refining(); ++k) texture = renderer.draw(picture, whole_view(*picture));
    CHECK_FALSE(renderer.refining());
    CHECK(texture_pixels(texture, side, side) == frame(renderer, picture).pixels);
}

TEST_CASE("pictures that make no sense are drawn as far as they do") {
    const HiddenWindow window;
    PictureRenderer renderer;
    auto picture = drawn(two_squares);
    const double endless = std::numeric_limits<double>::infinity();
    const double no_number = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {endless, no_number, 1e300, 1e-300}) {
        PictureItem item = picture->items[1];
        item.pose.translation.x = bad;
        picture->items.push_back(item);
        item.pose = {{bad, 0}, {}, false};
        picture->items.push_back(item);
    }
    CHECK(frame(renderer, picture).at(20, 20) == blue);
    auto grammar = *picture->grammar;
    grammar.canvas = {};
    picture->grammar = std::make_shared<const Grammar>(std::move(grammar));
    renderer.draw(picture, {.center = {20, -20}, .zoom = 1e6, .size = {0, 0}});
    renderer.draw(nullptr, {.center = {}, .zoom = 1, .size = {7, 5}});
    CHECK_FALSE(opengl_complains());
}

TEST_CASE("thumbnails show one look each and are kept") {
    const HiddenWindow window;
    ThumbnailRenderer thumbnails;
    const auto picture = drawn(two_squares);
    constexpr int size = 24;
    thumbnails.begin_frame();
    const auto first = thumbnails.thumbnail(picture, 0, size);
    thumbnails.begin_frame();
    const auto second = thumbnails.thumbnail(picture, 1, size);
    REQUIRE(first);
    REQUIRE(second);
    const auto middle = [&](unsigned texture) {
        const auto pixels = texture_pixels(texture, size, size);
        const std::size_t place = 4 * (size / 2 * size + size / 2);
        return Rgb{pixels[place], pixels[place + 1], pixels[place + 2]};
    };
    CHECK(middle(*first) == red);
    CHECK(middle(*second) == blue);
    CHECK(thumbnails.thumbnail(drawn(two_squares), 0, size) == first);
}
