#include "how_to/hpgl.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "exports/palette.h"
#include "exports/plain_color.h"
#include "lsystem/interpret.h"
#include "lsystem/to_scene.h"

namespace rinceau {

namespace {

constexpr double units_per_px = 25.4 / 96 / 0.025;  // a px is 1/96 inch, a plotter's unit 0.025 mm
constexpr int pens = 8;                             // in the carousel

/// What the pen draws an element with: its stroke, or the outline of its fill.
std::optional<Color> pen_color(const Style& style) {
    const std::optional<PlainColor> plain = plain_color(paints_stroke(style) ? style.stroke.paint : style.fill);
    return plain ? std::optional(plain->color) : std::nullopt;
}

/// Where coordinates are counted from: a grammar need not have a canvas.
Point low_corner(const Scene& scene) {
    if (!is_empty(scene.viewport)) return scene.viewport.low;
    Box drawn;
    for (const Element& element : scene.elements) drawn = including(drawn, bounds(element.paths));
    return drawn.low;
}

class HpglWriter {
  public:
    explicit HpglWriter(const Scene& scene) : low_(low_corner(scene)) {
        for (const Element& element : scene.elements) add(element);
    }

    std::string text() const {
        std::string text = "IN;\n";
        for (const auto& [pen, lines] : of_pen_) text += "SP" + std::to_string(pen) + ";\n" + lines;
        return text + "PU;SP0;\n";
    }

    std::vector<std::string> notes() const {
        std::vector<std::string> notes;
        if (filled_) notes.emplace_back("HP-GL draws lines: fills are drawn as their outlines");
        if (dashed_) notes.emplace_back("HP-GL draws lines: dashes are drawn as whole lines");
        if (left_out_ > 0) notes.push_back("HP-GL draws lines: fragments of SVG are left out: " + std::to_string(left_out_));
        if (palette_.overflowed())
            notes.emplace_back("a plotter has 8 pens: further colours are drawn in the nearest of these");
        return notes;
    }

    bool is_empty() const { return of_pen_.empty(); }

  private:
    void add(const Element& element) {
        const std::optional<Color> color = pen_color(element.style);
        if (!element.verbatim.empty() || !color) {
            ++left_out_;
            return;
        }
        filled_ = filled_ || paints_fill(element.style);
        dashed_ = dashed_ || !element.style.stroke.dashes.empty();
        for (const Path& path : element.paths) of_pen_[palette_.number_of(*color)] += line(path);
    }

    std::string line(const Path& path) const {
        constexpr double half_a_unit = 0.5 / units_per_px;
        std::vector<Point> corners = flattened(path, half_a_unit);
        if (path.closed) corners.push_back(corners.front());
        std::string text = "PU" + place(corners.front()) + ";PD";
        for (std::size_t i = 1; i < corners.size(); ++i) text += (i > 1 ? "," : "") + place(corners[i]);
        return text + ";\n";
    }

    /// From the low left corner of the canvas: a plotter's y goes up, as the scene's does.
    std::string place(Point p) const {
        const auto units = [](double length) { return std::to_string(std::lround(length * units_per_px)); };
        return units(p.x - low_.x) + ',' + units(p.y - low_.y);
    }

    Point low_;
    Palette palette_{1, pens};
    std::map<int, std::string> of_pen_;
    int left_out_ = 0;
    bool filled_ = false;
    bool dashed_ = false;
};

}  // namespace

Export to_hpgl(const Grammar& grammar, const ExportOptions& options) {
    const Scene scene = to_scene(grammar, interpret(grammar, {.derive = options.derive}));
    const HpglWriter writer(scene);
    if (writer.is_empty()) throw InputError({}, "expected outlines for a plotter, found nothing that pens can draw");
    return {.bytes = writer.text(), .companions = {}, .notes = writer.notes()};
}

}  // namespace rinceau
