// Prints the rules behind a drawing.

#include <iostream>
#include <string_view>

#include "analyzer/analyze.h"
#include "lsystem/grammar_text.h"
#include "scene/svg_read.h"

constexpr std::string_view drawing = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 240 40">
  <path d="M10 5h20l-10 30z"/><path d="M50 5h20l-10 30z"/><path d="M90 5h20l-10 30z"/>
  <path d="M130 5h20l-10 30z"/><path d="M170 5h20l-10 30z"/><path d="M210 5h20l-10 30z"/>
</svg>)";

int main() {
    const rinceau::SvgReadResult read = rinceau::read_svg(drawing);
    const rinceau::Analysis analysis = rinceau::analyze(read.scene);
    std::cout << rinceau::to_text(analysis.grammar);
    return analysis.report.check.passed ? 0 : 1;
}
