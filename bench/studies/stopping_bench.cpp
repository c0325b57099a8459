// How soon an analysis can be stopped: the longest processor time of the calling thread between two looks at its progress,
// and how long it runs on after it was told to stop, which an idle machine must be asked for. Usage: stopping_bench
// [FILE.svg ...]; without files, random elements and nested structure.

#include <time.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "analyzer/analyze.h"
#include "closed_loop/scenes.h"
#include "scene/svg_read.h"

using namespace rinceau;

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

double thread_seconds() {
    timespec used{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

struct Gap {
    double seconds = 0;
    std::string after;  ///< stage that was told before it
};

/// The longest of a whole analysis, and what that took.
Gap longest_gap(const Scene& scene, double& whole) {
    Gap longest;
    std::string stage = "begin";
    const auto start = Clock::now();
    double last = thread_seconds();
    const auto look = [&](std::string_view now, double) {
        if (const double gap = thread_seconds() - last; gap > longest.seconds)
            longest = {gap, stage + " -> " + std::string(now)};
        stage = now;
        last = thread_seconds();
    };
    analyze(scene, {}, look);
    look("end", 1);
    whole = seconds_since(start);
    return longest;
}

/// Seconds from the wish to stop, that comes after `delay`, to the end.
double seconds_to_stop(const Scene& scene, double delay) {
    struct Stopped {};
    std::atomic<bool> stop = false;
    Clock::time_point wished;
    std::jthread timer([&] {
        std::this_thread::sleep_for(std::chrono::duration<double>(delay));
        wished = Clock::now();
        stop = true;
    });
    try {
        analyze(scene, {}, [&](std::string_view, double) {
            if (stop) throw Stopped{};
        });
    } catch (const Stopped&) {
        return seconds_since(wished);
    }
    return 0;
}

void run_row(const std::string& name, const Scene& scene) {
    double whole = 0;
    const Gap gap = longest_gap(scene, whole);
    double longest_stop = 0;
    for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9})
        longest_stop = std::max(longest_stop, seconds_to_stop(scene, share * whole));
    std::printf("%-28s %7zu  %8.2f  %8.3f  %8.3f  %s\n", name.c_str(), scene.elements.size(), whole, gap.seconds,
                longest_stop, gap.after.c_str());
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    std::printf("%-28s %7s  %8s  %8s  %8s\n", "drawing", "N", "whole s", "gap s", "stop s");
    for (int k = 1; k < argc; ++k) {
        std::ifstream input(argv[k], std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(input), {}};
        const std::string path = argv[k];
        run_row(path.substr(path.rfind('/') + 1), read_svg(text, {.file_name = path}).scene);
    }
    if (argc > 1) return 0;
    run_row("random", test::clutter_scene(10'000).scene);
    run_row("nested", test::nested_scene(2, 5).scene);
}
