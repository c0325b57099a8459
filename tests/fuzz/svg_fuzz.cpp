// Drawings: what is read can be written, and reads back as what was written.

#include <algorithm>

#include "scene/svg_read.h"
#include "scene/svg_write.h"
#include "tests/fuzz/fuzz_target.h"

namespace rinceau {
namespace {

/// Strokes that were stretched come back to rounding only, also in fragments.
bool has_round_pens(const Scene& scene) {
    return std::ranges::all_of(scene.elements, [](const Element& element) {
        return element.style.stroke.pen == Linear2{} && element.verbatim.find("transform=") == std::string::npos;
    });
}

}  // namespace

void take_input(std::string_view bytes) {
    SvgReadOptions options;
    options.file_name = "any.svg";
    options.max_elements = 2000;
    options.max_depth = 200;
    options.max_bytes = 1u << 20U;
    const Scene scene = read_svg(bytes, options).scene;

    Scene again;
    require(is_taken([&] { again = read_svg(write_svg(scene)).scene; }), "a written drawing can be read");
    require(again.elements.size() == scene.elements.size(), "a written drawing has as many elements");
    if (!has_round_pens(scene)) return;
    const std::string once = write_svg(again);
    require(write_svg(read_svg(once).scene) == once, "a written drawing reads back as the same");
}

}  // namespace rinceau
