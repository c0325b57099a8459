#include <catch2/catch.hpp>

#include <chrono>
#include <string>

#include "scene/svg_read.h"
#include "scene/svg_write.h"

using namespace rinceau;

namespace {

const std::string head = "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"100\" height=\"100\">";

std::string repeated(const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
}

/// What reading says, and that it says it soon.
template <typename Error>
std::string refusal(const std::string& svg) {
    const auto begin = std::chrono::steady_clock::now();
    std::string message = "(read without complaint)";
    try {
        read_svg(svg, {.file_name = "bad.svg"});
    } catch (const Error& error) {
        message = error.what();
        CHECK(error.place().line > 0);
    }
    constexpr double patience = 10;  // seconds, on a busy machine; about 0.1 on an idle one
    CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() < patience);
    return message;
}

bool has_column(const std::string& message) {
    // "bad.svg:LINE:COLUMN: ..."
    std::size_t at = message.find(':');
    at = at == std::string::npos ? at : message.find_first_not_of("0123456789", at + 1);
    return at != std::string::npos && message[at] == ':' && at + 1 < message.size() && std::isdigit(static_cast<unsigned char>(message[at + 1]));
}

}  // namespace

TEST_CASE("what is no SVG is refused with line and column") {
    const std::string png = "\x89PNG\r\n\x1a\n" + std::string(40, '\0');
    const std::string html = "<!DOCTYPE html>\n<html><body>hello</body></html>";
    const std::string truncated = head + "\n<g><path d=\"M0 0L1 1\"/>\n<rect wid";
    const std::string unclosed = head + "<g><rect width=\"5\" height=\"5\"/></svg>";
    for (const std::string& bad : {std::string(), std::string("   \n "), std::string("hello"), png, html, truncated, unclosed, std::string("{\"a\": 1}")}) {
        const std::string message = refusal<InputError>(bad);
        INFO(message);
        CHECK(message.starts_with("bad.svg:"));
        CHECK(has_column(message));
    }
}

TEST_CASE("ten thousand nested groups are a limit, four hundred are not") {
    const auto nested = [](int depth) { return head + repeated("<g>", depth) + "<path d=\"M0 0h9v9z\"/>" + repeated("</g>", depth) + "</svg>"; };
    CHECK(refusal<LimitError>(nested(10'000)).find("deep") != std::string::npos);
    CHECK(read_svg(nested(400)).scene.elements.size() == 1);
    CHECK(read_svg(nested(4000)).scene.elements.size() == 1);
}

TEST_CASE("a chain of use elements may be as deep as the limit and no deeper") {
    const auto chain = [](int length) {
        std::string svg = head + "<rect id=\"u0\" width=\"9\" height=\"9\"/>";
        for (int i = 1; i <= length; ++i)
            svg += "<use id=\"u" + std::to_string(i) + "\" xlink:href=\"#u" + std::to_string(i - 1) + "\" x=\"1\"/>";
        return svg + "</svg>";
    };
    // Every use draws the rectangle once more.
    CHECK(read_svg(chain(100)).scene.elements.size() == 101);
    CHECK(read_svg(chain(500)).scene.elements.size() == 501);
    CHECK(refusal<LimitError>(chain(10'000)).find("deep") != std::string::npos);
}

TEST_CASE("ten levels of ten uses are counted before they are drawn") {
    std::string svg = head + "<defs><rect id=\"l0\" width=\"1\" height=\"1\"/>";
    for (int level = 1; level <= 10; ++level)
        svg += "<g id=\"l" + std::to_string(level) + "\">" + repeated("<use xlink:href=\"#l" + std::to_string(level - 1) + "\"/>", 10) + "</g>";
    svg += "</defs><use xlink:href=\"#l10\"/></svg>";
    CHECK(refusal<LimitError>(svg).find("elements") != std::string::npos);
}

TEST_CASE("markers on many vertices count as elements") {
    std::string svg = head + "<defs><marker id=\"m\"><path d=\"M0 0h1v1z\"/><path d=\"M0 0h1v1z\"/></marker></defs><path stroke=\"red\" marker-mid=\"url(#m)\" d=\"M0 0" +
                      repeated("h1", 1000) + "\"/></svg>";
    CHECK_THROWS_AS(read_svg(svg, {.max_elements = 1500}), LimitError);
    CHECK(read_svg(svg, {.max_elements = 5000}).scene.elements.size() == 1 + 2 * 999);
}

TEST_CASE("references that lead back to themselves are skipped with a warning") {
    for (const std::string& body :
         {std::string("<g id=\"a\"><use xlink:href=\"#a\"/></g>"), std::string("<use id=\"a\" xlink:href=\"#b\"/><use id=\"b\" xlink:href=\"#a\"/>"),
          std::string("<symbol id=\"a\"><use xlink:href=\"#a\"/></symbol><use xlink:href=\"#a\"/>"),
          std::string("<marker id=\"m\"><path d=\"M0 0h5\" marker-end=\"url(#m)\"/></marker><path d=\"M0 0h5\" marker-end=\"url(#m)\"/>")}) {
        INFO(body);
        const SvgReadResult result = read_svg(head + body + "</svg>");
        CHECK(result.scene.elements.empty());
        bool told = false;
        for (const Warning& warning : result.warnings) told = told || warning.message.find("back to themselves") != std::string::npos;
        CHECK(told);
    }
}

TEST_CASE("a bomb of entities is a limit") {
    std::string svg = "<!DOCTYPE svg [<!ENTITY e0 \"aaaaaaaaaaaaaaaa\">";
    for (int i = 1; i < 12; ++i)
        svg += "<!ENTITY e" + std::to_string(i) + " \"" + repeated("&e" + std::to_string(i - 1) + ";", 10) + "\">";
    svg += "]>\n" + head + "<desc>&e11;</desc></svg>";
    CHECK(has_column(refusal<LimitError>(svg)));
}

TEST_CASE("numbers that are none or too large leave a drawing that can be used") {
    for (const std::string& body :
         {std::string("<rect width=\"NaN\" height=\"5\"/>"), std::string("<path d=\"M0 0L1e308 1e308\" stroke=\"red\"/>"),
          std::string("<g transform=\"scale(1e308)\"><g transform=\"scale(1e308)\"><rect width=\"5\" height=\"5\"/></g></g>"),
          std::string("<rect width=\"1e308\" height=\"1e308\"/>"), std::string("<circle r=\"inf\"/>"),
          std::string("<rect width=\"5\" height=\"5\" stroke=\"red\" stroke-width=\"1e308\"/>"),
          std::string("<g transform=\"matrix(0 0 0 0 0 0)\"><rect width=\"5\" height=\"5\"/></g>"),
          std::string("<g transform=\"matrix(NaN 0 0 1 0 0)\"/>"), std::string("<path d=\"M0 0 A 1e308 1e-308 0 0 1 5 5\" stroke=\"red\"/>")}) {
        INFO(body);
        for (const Element& element : read_svg(head + body + "</svg>").scene.elements) {
            const Box box = painted_box(element);
            CHECK(std::isfinite(diagonal(box)));
        }
    }
}

TEST_CASE("a drawing with a huge number of elements is a limit, not a crash") {
    CHECK_THROWS_AS(read_svg(head + repeated("<path d=\"M0 0h1v1z\"/>", 2000) + "</svg>", {.max_elements = 1000}), LimitError);
}

TEST_CASE("a fault of the XML library still has a line of the drawing") {
    const std::string message = refusal<InputError>(head + "\n<rect width=5 height=\"5\"/>\n</svg>");
    INFO(message);
    CHECK(message.starts_with("bad.svg:2:"));
}

TEST_CASE("a clip whose shapes lie beyond all coordinates leaves what it clips as it is") {
    for (const char* far : {"<rect x='1e308' width='80' height='80'/>", "<circle r='1e200'/>",
                            "<rect width='9' height='9' transform='scale(1e300)'/>"}) {
        const SvgReadResult read = read_svg(head + "<clipPath id='c'>" + far +
                                            "</clipPath><path clip-path='url(#c)' d='M20 20h10v10h-10z'/></svg>");
        INFO(far);
        REQUIRE(read.scene.elements.size() == 1);
        CHECK_FALSE(read.scene.elements.front().verbatim.empty());
    }
}

TEST_CASE("a clip is told in a time that does not grow with the square of its corners") {
    // Far larger than the drawing, so that it is flattened into as many corners as there may be.
    std::string circles;
    for (int i = 0; i < 8; ++i) circles += "<circle r='" + std::to_string(i + 1) + "e9'/>";
    const auto begin = std::chrono::steady_clock::now();
    const SvgReadResult read = read_svg(head + "<clipPath id='c'>" + circles +
                                        "</clipPath><path clip-path='url(#c)' d='M20 20h10v10h-10z'/></svg>");
    constexpr double patience = 5;  // seconds, on a busy machine; about 0.2 on an idle one
    CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() < patience);
    REQUIRE(read.scene.elements.size() == 1);
    CHECK(read.scene.elements.front().verbatim.empty());
}

TEST_CASE("a stroke that is stretched beyond measure is left out rather than written out of range") {
    const std::string svg = head + "<path d='M1 1h9v9z' fill='red' stroke='blue' transform='scale(1e-150 1e150)'/>"
                                   "<path d='M1 1h9v9z' fill='red' stroke='blue' transform='scale(1e-3 1e3)'/></svg>";
    const Scene once = read_svg(svg).scene;
    CHECK(once.elements.size() == 1);
    CHECK(read_svg(write_svg(once)).scene.elements.size() == 1);
}
