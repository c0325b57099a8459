// Drawings with one issue each (tests/svg): the title says what is expected, the attribute data-expect in figures:
// "elements=2 verbatim=0 subpaths=2 box=10,10,60,30 warnings=0" (box of the outlines, SVG's y down).

#include <catch2/catch.hpp>
#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include "picture.h"
#include "scene/svg_read.h"
#include "scene/svg_write.h"

using namespace rinceau;

namespace {

std::string file_text(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::filesystem::path> all_drawings() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(std::string(RINCEAU_SOURCE_DIR) + "/tests/svg"))
        if (entry.path().extension() == ".svg") files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

std::map<std::string, std::string> expectations(const std::string& svg) {
    tinyxml2::XMLDocument document;
    document.Parse(svg.c_str());
    const char* text = document.RootElement() == nullptr ? nullptr : document.RootElement()->Attribute("data-expect");
    std::map<std::string, std::string> expected;
    std::istringstream words(text == nullptr ? "" : text);
    for (std::string word; words >> word;) expected[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
    return expected;
}

std::string figures(const SvgReadResult& result, const std::string& name) {
    std::size_t verbatim = 0, subpaths = 0;
    Box box;
    for (const Element& element : result.scene.elements) {
        verbatim += element.verbatim.empty() ? 0 : 1;
        subpaths += element.paths.size();
        box = including(box, bounds(element.paths));
    }
    if (name == "elements") return std::to_string(result.scene.elements.size());
    if (name == "verbatim") return std::to_string(verbatim);
    if (name == "subpaths") return std::to_string(subpaths);
    if (name == "warnings") return std::to_string(result.warnings.size());
    std::ostringstream text;
    // To a hundredth of a px, without a sign before 0.
    const auto rounded = [](double value) { return std::round(value * 100) / 100 + 0.0; };
    text << rounded(box.low.x) << ',' << rounded(-box.high.y) << ',' << rounded(box.high.x) << ',' << rounded(-box.low.y);
    return text.str();
}

}  // namespace

TEST_CASE("every drawing with one issue gives the elements that its title promises") {
    for (const auto& file : all_drawings()) {
        const std::string svg = file_text(file);
        const auto expected = expectations(svg);
        INFO(file.filename().string());
        REQUIRE(!expected.empty());
        const SvgReadResult result = read_svg(svg, {.file_name = file.filename().string()});
        for (const auto& [name, value] : expected) {
            if (name == "picture") continue;
            INFO(name);
            CHECK(figures(result, name) == value);
        }
    }
}

TEST_CASE("every drawing with one issue looks the same after it has been read and written") {
    // Pixels of edges that fall between two roundings.
    constexpr double share_of_edges = 0.002;
    for (const auto& file : all_drawings()) {
        const std::string svg = file_text(file);
        // The reference renderer does not know everything that browsers do.
        if (expectations(svg)["picture"] == "other") continue;
        INFO(file.filename().string());
        CHECK(picture_difference(svg, write_svg(read_svg(svg).scene), 200) <= share_of_edges);
    }
}

TEST_CASE("what has been written is read back as the same drawing") {
    // Last digits of maps that are taken apart and put together again.
    constexpr double rounding = 1e-9;
    for (const auto& file : all_drawings()) {
        INFO(file.filename().string());
        const Scene once = read_svg(file_text(file)).scene;
        const Scene twice = read_svg(write_svg(once)).scene;
        CHECK(twice.sized == once.sized);
        REQUIRE(twice.elements.size() == once.elements.size());
        for (std::size_t i = 0; i < once.elements.size(); ++i) {
            const Element &before = once.elements[i], &after = twice.elements[i];
            CHECK(after.verbatim == before.verbatim);
            CHECK(same_style(after.style, before.style, rounding));
            REQUIRE(after.paths.size() == before.paths.size());
            for (std::size_t p = 0; p < before.paths.size(); ++p) {
                REQUIRE(after.paths[p].segments.size() == before.paths[p].segments.size());
                CHECK(abs(after.paths[p].start - before.paths[p].start) <= rounding);
                for (std::size_t k = 0; k < before.paths[p].segments.size(); ++k)
                    CHECK(abs(after.paths[p].segments[k].to - before.paths[p].segments[k].to) <= rounding);
            }
        }
    }
}
