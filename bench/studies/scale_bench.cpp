// Cost by size: nested structure, a grid and clutter at about 1,000, 10,000 and 100,000 elements, from the SVG text to the
// grammar text. Each runs in a process of its own, so that its memory can be told.
// Usage: scale_bench [largest number of elements, default 100000]

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

#include "analyzer/analyze.h"
#include "closed_loop/scenes.h"
#include "lsystem/grammar_text.h"
#include "scene/svg_read.h"
#include "scene/svg_write.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

Scene grid_scene(int count) {
    const int side = static_cast<int>(std::round(std::sqrt(count)));
    Scene scene{{{0, 0}, {10.0 * side, 10.0 * side}}, true, {}};
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const Point p{10.0 * column + 2, 10.0 * row + 2};
            Element square;
            square.paths = {{p, {line_to(p + Point{6, 0}), line_to(p + Point{6, 6}), line_to(p + Point{0, 6})}, true}};
            square.style.fill = Color{51, 102, 170};
            scene.elements.push_back(square);
        }
    }
    return scene;
}

Scene nested(int count) {
    if (count < 10'000) return nested_scene(1, 1).scene;
    return count < 100'000 ? nested_scene(2, 5).scene : nested_scene(7, 12).scene;
}

struct Cost {
    double elements = 0;
    double wall = 0, processor = 0;  // seconds
    double again = 0;                // seconds for other weights, when the drawing is prepared
    double kilobytes = 0;            // at the peak
};

/// Runs `work` in a process of its own and brings its numbers back.
template <class Work>
Cost measured(const Work& work) {
    int ends[2];
    if (pipe(ends) != 0) return {};
    const pid_t child = fork();
    if (child == 0) {
        const Cost cost = work();
        const bool told = write(ends[1], &cost, sizeof cost) == sizeof cost;
        _exit(told ? 0 : 1);
    }
    Cost cost;
    if (read(ends[0], &cost, sizeof cost) != sizeof cost) cost = {};
    close(ends[0]);
    close(ends[1]);
    rusage used{};
    int status = 0;
    wait4(child, &status, 0, &used);
    const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
    cost.processor = seconds(used.ru_utime) + seconds(used.ru_stime);
    cost.kilobytes = static_cast<double>(used.ru_maxrss);
    return cost;
}

std::string content_of(const std::string& file) {
    std::string content;
    if (std::FILE* input = std::fopen(file.c_str(), "rb")) {
        char bytes[1 << 16];
        for (std::size_t n = 0; (n = std::fread(bytes, 1, sizeof bytes, input)) > 0;) content.append(bytes, n);
        std::fclose(input);
    }
    return content;
}

Cost cost_of(const std::string& file) {
    return measured([&] {
        const auto start = Clock::now();
        const SvgReadResult drawing = read_svg(content_of(file), {.file_name = file});
        const Analysis analysis = analyze(drawing.scene);
        const std::string text = to_text(analysis.grammar);
        return Cost{.elements = static_cast<double>(drawing.scene.elements.size()), .wall = seconds_since(start)};
    });
}

/// Seconds of a second analysis with other weights.
double seconds_again(const std::string& file) {
    return measured([&] {
               const SvgReadResult drawing = read_svg(content_of(file), {.file_name = file});
               const PreparedDrawing prepared = prepare_drawing(drawing.scene);
               const auto start = Clock::now();
               analyze(prepared, {.weights = {.nearness = 2}});
               return Cost{.again = seconds_since(start)};
           })
        .again;
}

void write_scene(const std::string& file, const Scene& scene) {
    if (std::FILE* output = std::fopen(file.c_str(), "wb")) {
        const std::string svg = write_svg(scene);
        std::fwrite(svg.data(), 1, svg.size(), output);
        std::fclose(output);
    }
}

/// Best of three runs: what else the machine does only ever adds.
Cost best_cost(const std::string& file) {
    Cost best = cost_of(file);
    for (int k = 1; k < 3; ++k) {
        const Cost cost = cost_of(file);
        best.wall = std::min(best.wall, cost.wall);
        best.processor = std::min(best.processor, cost.processor);
    }
    best.again = seconds_again(file);
    return best;
}

template <class MakeScene>
void run_row(const char* name, const MakeScene& make_scene, int largest, double empty_kilobytes) {
    double first = 0;
    for (const int count : {1'000, 10'000, 100'000}) {
        if (count > largest) return;
        const std::string file = "scale_bench.svg";
        measured([&] {
            write_scene(file, make_scene(count));
            return Cost{};
        });
        const Cost cost = best_cost(file);
        std::remove(file.c_str());
        const double each = cost.processor / cost.elements;
        if (first == 0) first = each;
        std::printf("%-8s %7.0f  %8.3f %8.3f  %10.1f %6.2f  %7.2f  %7.3f\n", name, cost.elements, cost.wall, cost.processor,
                    1e6 * each, each / first, (cost.kilobytes - empty_kilobytes) / cost.elements, cost.again);
        std::fflush(stdout);
    }
}

}  // namespace

int main(int argc, char** argv) {
    int largest = 100'000;
    if (argc > 1) {
        const std::string_view text = argv[1];
        if (std::from_chars(text.data(), text.data() + text.size(), largest).ec != std::errc{}) {
            std::fputs("usage: scale_bench [largest number of elements]\n", stderr);
            return 2;
        }
    }
    const double empty_kilobytes = measured([] { return Cost{}; }).kilobytes;
    std::printf("%-8s %7s  %8s %8s  %10s %6s  %7s  %7s\n", "scene", "N", "seconds", "cpu s", "us/element", "ratio", "kB each",
                "again s");
    run_row("nested", nested, largest, empty_kilobytes);
    run_row("grid", grid_scene, largest, empty_kilobytes);
    run_row("clutter", [](int count) { return clutter_scene(count).scene; }, largest, empty_kilobytes);
}
