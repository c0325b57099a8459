// The stress drawings of the shared corpus, which is not part of this repository: the folder is $RINCEAU_CORPUS, or
// ../shared/corpus beside the sources. Without it these tests say so and pass.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "scene/svg_read.h"

using namespace rinceau;

namespace {

std::filesystem::path corpus() {
    const char* given = std::getenv("RINCEAU_CORPUS");
    return given != nullptr ? std::filesystem::path(given) : std::filesystem::path(RINCEAU_SOURCE_DIR) / "../shared/corpus";
}

std::string file_text(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

TEST_CASE("the stress drawings have as many shapes and sub-paths, and the box, that a person counted") {
    const std::filesystem::path folder = corpus() / "stress";
    if (!std::filesystem::exists(folder / "expected.json")) {
        WARN("no corpus at " << folder.string() << ": set RINCEAU_CORPUS to check against it");
        return;
    }
    for (const auto& expected : nlohmann::json::parse(file_text(folder / "expected.json"))) {
        const std::string name = expected["file"];
        INFO(name << ": " << expected["note"].get<std::string>());
        const Scene scene = read_svg(file_text(folder / name), {.split_compound_paths = false}).scene;
        CHECK(scene.elements.size() == expected["shapes"].get<std::size_t>());
        std::size_t subpaths = 0;
        Box box;
        bool outlines_only = true;
        for (const Element& element : scene.elements) {
            // A kept shape counts as one; its box is that of its ink.
            subpaths += element.verbatim.empty() ? element.paths.size() : 1;
            box = including(box, bounds(element.paths));
            outlines_only = outlines_only && element.verbatim.empty();
        }
        CHECK(subpaths == expected["subpaths"].get<std::size_t>());
        if (!outlines_only) continue;
        constexpr double printed_digits = 1e-3;
        CHECK(box.low.x == Approx(expected["bbox"][0].get<double>()).margin(printed_digits));
        CHECK(-box.high.y == Approx(expected["bbox"][1].get<double>()).margin(printed_digits));
        CHECK(box.high.x == Approx(expected["bbox"][2].get<double>()).margin(printed_digits));
        CHECK(-box.low.y == Approx(expected["bbox"][3].get<double>()).margin(printed_digits));
    }
}

TEST_CASE("all art of the corpus is read") {
    const std::filesystem::path folder = corpus() / "art";
    if (!std::filesystem::exists(folder)) {
        WARN("no corpus at " << folder.string() << ": set RINCEAU_CORPUS to check against it");
        return;
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".svg") continue;
        INFO(entry.path().filename().string());
        CHECK(!read_svg(file_text(entry.path())).scene.elements.empty());
    }
}
