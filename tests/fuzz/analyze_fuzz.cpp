// Small drawings, analysed: the grammar draws the drawing again.

#include "analyzer/analyze.h"
#include "lsystem/grammar_text.h"
#include "scene/svg_read.h"
#include "tests/fuzz/fuzz_target.h"

namespace rinceau {
namespace {

/// Few elements with few points, which an analysis takes no time for, none of them much larger than the page or very far
/// from the origin: numbers are kept to the digits that show on the page.
bool is_small(const Scene& scene) {
    constexpr std::size_t most_elements = 40, most_segments = 600;
    const double most_reach = 100 * drawing_diagonal(scene), farthest = 1e6 * drawing_diagonal(scene);
    std::size_t segments = 0;
    for (const Element& element : scene.elements) {
        const Box box = painted_box(element);
        if (diagonal(box) > most_reach || abs(box.low) > farthest) return false;
        for (const Path& path : element.paths) segments += path.segments.size() + 1;
    }
    return scene.elements.size() <= most_elements && segments <= most_segments;
}

}  // namespace

void take_input(std::string_view bytes) {
    SvgReadOptions reading;
    reading.file_name = "any.svg";
    reading.max_elements = 100;
    reading.max_depth = 50;
    reading.max_bytes = 1u << 18U;
    const Scene scene = read_svg(bytes, reading).scene;
    if (!is_small(scene)) return;
    AnalyzeOptions options;
    options.threads = 1;
    const Analysis analysis = analyze(scene, options);
    require(analysis.report.check.passed, "an analysis has passed its check");
    const std::string text = to_text(analysis.grammar);
    require(is_taken([&] { require(to_text(parse_grammar(text)) == text, "its grammar reads back as the same"); }),
            "its grammar can be read");
}

}  // namespace rinceau
