// How fast the editor draws: real frames by OpenGL, at 1280 x 800, of pictures of many elements. Needs a display.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "tests/editor/hidden_window.h"
#include "editor/gl/draw_plan.h"
#include "editor/gl/picture_renderer.h"
#include "editor/gl/plan_drawer.h"
#include "geometry/random.h"
#include "lsystem/grammar_text.h"

using namespace rinceau;
using Clock = std::chrono::steady_clock;

namespace {

constexpr Point frame_size{1280, 800};
constexpr int frames = 12;

/// Of all threads of the program: does not depend on what else the machine does.
double processor_milliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double milliseconds(Clock::duration duration) { return std::chrono::duration<double, std::milli>(duration).count(); }

/// A closed outline of 30 cubic curves about the origin, of radius 1.
Path blob() {
    constexpr int corners = 30;
    const auto at = [](double k, double radius) { return polar(radius, 2 * pi * k / corners); };
    const auto radius = [](int k) { return k % 2 == 0 ? 1.0 : 0.8; };
    Path path;
    path.start = at(0, radius(0));
    for (int k = 0; k < corners; ++k)
        path.segments.push_back(
            curve_to(at(k + 0.35, 1.02 * radius(k)), at(k + 0.65, 1.02 * radius(k + 1)), at(k + 1, radius(k + 1))));
    path.closed = true;
    return path;
}

/// A leaf of two cubic curves, of radius 1.
Path leaf() {
    Path path;
    path.start = {0, -1};
    path.segments.push_back(curve_to({0.9, -0.4}, {0.9, 0.4}, {0, 1}));
    path.segments.push_back(curve_to({-0.9, 0.4}, {-0.9, -0.4}, {0, -1}));
    path.closed = true;
    return path;
}

struct CrowdOptions {
    bool leaves = false;
    int count = 10'000;
    int looks = 4;
    double opacity = 1;
    bool stroked = false;
};

/// Elements spread over the frame at random, as large as keeps them from hiding each other altogether.
std::shared_ptr<DerivedPicture> crowd(const CrowdOptions& options) {
    Grammar grammar;
    grammar.canvas = {{0, 0}, frame_size};
    auto picture = std::make_shared<DerivedPicture>();
    for (int k = 0; k < options.looks; ++k) {
        Style style;
        const auto shade = static_cast<std::uint8_t>(40 + 200 * k / options.looks);
        style.fill = Color{shade, 120, static_cast<std::uint8_t>(255 - shade)};
        style.opacity = options.opacity;
        if (options.stroked) style.stroke.paint = Color{20, 20, 20};
        style.stroke.width = 0.15;
        grammar.styles.push_back({.number = k + 1, .style = style});
        grammar.terminals.push_back({.symbol = "T" + std::to_string(k), .style = k + 1, .paths = {options.leaves ? leaf() : blob()}});
        picture->looks.push_back({k, k + 1});
    }
    picture->grammar = std::make_shared<const Grammar>(std::move(grammar));
    Random random(1);
    const double size = 0.6 * std::sqrt(frame_size.x * frame_size.y / options.count);
    for (int i = 0; i < options.count; ++i) {
        const Point at{random.uniform(0, frame_size.x), random.uniform(0, frame_size.y)};
        const double scale = size * random.uniform(0.7, 1.3);
        picture->items.push_back({{polar(scale, random.uniform(0, 2 * pi)), at, false}, i % options.looks, i, {}});
    }
    return picture;
}

struct Times {
    std::vector<double> passed, worked;  ///< milliseconds on the clock, and of processors
};

/// Measures from its making to its end.
class Measured {
  public:
    explicit Measured(Times& times) : times_(times) {}
    ~Measured() {
        times_.passed.push_back(milliseconds(Clock::now() - start_));
        times_.worked.push_back(processor_milliseconds() - worked_);
    }
    Measured(const Measured&) = delete;
    Measured& operator=(const Measured&) = delete;

  private:
    Times& times_;
    Clock::time_point start_ = Clock::now();
    double worked_ = processor_milliseconds();
};

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

void print_times(const std::string& name, const Times& times) {
    const double usual = median(times.passed);
    std::printf("%-46s %8.1f %8.1f %8.1f %10.1f\n", name.c_str(), usual, std::ranges::max(times.passed), 1000 / usual,
                median(times.worked));
}

/// Frames while the view moves by some pixels each.
void pan(const std::string& name, const std::shared_ptr<const DerivedPicture>& picture) {
    PictureRenderer renderer;
    ViewTransform view{.center = center(picture->grammar->canvas), .zoom = 1, .size = frame_size};
    renderer.draw(picture, view);
    test::finish_drawing();
    Times times;
    for (int k = 0; k < frames; ++k) {
        view.center.x += 3;
        const Measured measured(times);
        renderer.draw(picture, view);
        test::finish_drawing();
    }
    print_times(name, times);
}

/// What a drag costs before the first pixel: derivation, looks, plan and upload, once for each value.
void drag() {
    const std::string text =
        "lsystem 1\n"
        "canvas 0 -800 1280 800\n"
        "axiom: Rows(100)\n"
        "Rows(m) : m > 0 -> [Row(100)] f(7.9) Rows(m-1)\n"
        "Row(m) : m > 0 -> [A] -(90) f(12.7) +(90) Row(m-1)\n"
        "style 1: fill #226688\n"
        "terminal A: style 1; path \"M-4 3C-4 0 -3 -4 0 -4C3 -4 4 0 4 3Z\"\n";
    Document document = empty_document();
    ShapeStore shapes;
    UploadedPlan uploaded;
    Times derived;
    Times shown;
    for (int k = 0; k < frames; ++k) {
        std::string changed = text;
        changed.replace(changed.find("7.9"), 3, std::to_string(7.5 + 0.01 * k));
        document = with_grammar(document, parse_grammar(changed));
        std::shared_ptr<const DerivedPicture> picture;
        {
            const Measured measured(derived);
            picture = std::make_shared<const DerivedPicture>(derive_picture(document));
        }
        const Measured measured(shown);
        const LookTable table = look_table(picture, shapes);
        const PlanRequest request{.region = picture->grammar->canvas, .zoom = 1, .deadline = Clock::time_point::max()};
        upload_plan(uploaded, draw_plan(table, request, shapes));
        test::finish_drawing();
    }
    print_times("drag on 10,000 elements: derive", derived);
    print_times("drag on 10,000 elements: plan and upload", shown);
}

}  // namespace

int main() {
    const test::HiddenWindow window;
    std::printf("%-46s %8s %8s %8s %10s\n", "1280 x 800 pixels, milliseconds", "median", "worst", "a second", "processors");
    drag();
    pan("1 leaf, panning", crowd({.leaves = true, .count = 1}));
    pan("100 leaves, panning", crowd({.leaves = true, .count = 100}));
    pan("10,000 leaves, panning", crowd({.leaves = true}));
    pan("10,000 leaves with lines around", crowd({.leaves = true, .stroked = true}));
    pan("100,000 leaves, panning", crowd({.leaves = true, .count = 100'000}));
    pan("100,000 leaves, translucent", crowd({.leaves = true, .count = 100'000, .opacity = 0.6}));
    pan("10,000 instances of 30 curves, panning", crowd({.count = 10'000}));
    pan("10,000 with lines around", crowd({.count = 10'000, .stroked = true}));
    pan("10,000 translucent, four looks in turn", crowd({.count = 10'000, .opacity = 0.6}));
    pan("10,000 of 2,000 looks", crowd({.count = 10'000, .looks = 2'000}));
    pan("100,000 instances of 30 curves, panning", crowd({.count = 100'000}));
    pan("100,000 translucent, four looks in turn", crowd({.count = 100'000, .opacity = 0.6}));
}
