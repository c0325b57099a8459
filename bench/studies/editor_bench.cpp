// What the editor does between two frames of a drag, in milliseconds of processor time: the median of some runs.
// usage: editor_bench [ELEMENTS..]

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <vector>

#include "editor/model/derived_picture.h"
#include "editor/model/hit_test.h"
#include "editor_drawings.h"
#include "lsystem/check_edit.h"
#include "lsystem/grammar_text.h"
#include "lsystem/numbers.h"
#include "lsystem/set_numbers.h"

using namespace rinceau;

namespace {

constexpr int runs = 5;

double processor_milliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double median_time(const std::function<void()>& work) {
    std::vector<double> times;
    for (int run = 0; run < runs; ++run) {
        const double start = processor_milliseconds();
        work();
        times.push_back(processor_milliseconds() - start);
    }
    std::ranges::sort(times);
    return times[runs / 2];
}

struct Column {
    const char* title;
    std::function<void(const Document&, const EditorDrawing&)> work;
};

EditResult with_number_set(const Grammar& grammar, const EditorDrawing& drawing) {
    const std::vector<NumberEdit> edits{parse_number_edit(drawing.number + "*=1")};
    return set_numbers(grammar, edits);
}

/// One a line: what is measured is added here.
std::vector<Column> columns() {
    return {
        {"derive", [](const Document& document, const EditorDrawing&) { derive_picture(document); }},
        {"set", [](const Document& document, const EditorDrawing& drawing) { with_number_set(*document.grammar, drawing); }},
        {"set+resolve",
         [](const Document& document, const EditorDrawing& drawing) {
             with_grammar(document, with_number_set(*document.grammar, drawing).grammar);
         }},
        {"numbers", [](const Document& document, const EditorDrawing&) { grammar_numbers(*document.grammar); }},
        {"text", [](const Document& document, const EditorDrawing&) { to_text(*document.grammar); }},
        {"check",
         [](const Document& document, const EditorDrawing& drawing) {
             checked_edit(*document.grammar, with_number_set(*document.grammar, drawing));
         }},
        {"hit index",
         [](const Document& document, const EditorDrawing&) {
             HitIndex(std::make_shared<const DerivedPicture>(derive_picture(document)));
         }},
    };
}

void print_table(int elements) {
    std::printf("\n%-12s %8s", "drawing", "items");
    for (const Column& column : columns()) std::printf(" %11s", column.title);
    std::printf("\n");
    for (const EditorDrawing& drawing : editor_drawings(elements)) {
        const Document document = with_grammar(empty_document(), drawing.grammar);
        std::printf("%-12s %8zu", drawing.name.c_str(), derive_picture(document).items.size());
        for (const Column& column : columns()) std::printf(" %11.2f", median_time([&] { column.work(document, drawing); }));
        std::printf("\n");
        std::fflush(stdout);
    }
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<int> sizes;
    for (int i = 1; i < argc; ++i) sizes.push_back(std::atoi(argv[i]));
    if (sizes.empty()) sizes = {1000, 10'000, 100'000};
    for (const int elements : sizes) print_table(elements);
}
