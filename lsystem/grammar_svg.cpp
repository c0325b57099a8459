// The picture with <use>: what is drawn more than once is defined once.

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <map>

#include "lsystem/drawn_style.h"
#include "lsystem/style_table.h"
#include "lsystem/to_scene.h"
#include "scene/svg_write.h"

namespace rinceau {

namespace {

/// What one definition draws.
struct Look {
    int terminal = 0;
    int style = 0;               ///< number
    int color = -1;              ///< index of a distinct colour, -1 = the style's own
    bool repaints_fill = false;  ///< with the colour of the placement
    bool repaints_stroke = false;
    friend constexpr auto operator<=>(const Look&, const Look&) = default;
};

struct LookUse {
    int count = 0;
    std::string id;  ///< of the definition; empty until it is written
    /// Width and dashes of a fixed stroke, in the terminal's frame, if all placements agree in them; else each <use> has its
    /// own, which the definition inherits.
    std::string stroke_lengths;
    bool lengths_differ = false;
};

/// `text` without the values of an attribute, so that what is drawn inherits it.
std::string without_attribute(std::string text, const std::string& name) {
    const std::string front = ' ' + name + "=\"";
    for (std::size_t at = text.find(front); at != std::string::npos; at = text.find(front, at)) {
        text.erase(at, text.find('"', at + front.size()) + 1 - at);
    }
    return text;
}

std::string transform_attribute(const Affine& map) {
    const std::string text = svg_transform_text(map);
    return text.empty() ? "" : " transform=\"" + text + '"';
}

class Writer {
  public:
    Writer(const Grammar& grammar, const std::vector<Placement>& placements, const GrammarSvgOptions& options)
        : grammar_(grammar), placements_(placements), options_(options), styles_(grammar) {}

    std::string write() {
        choose_prefix();
        for (const Terminal& terminal : grammar_.terminals) reach_.push_back(reach_of(terminal));
        for (const Placement& placement : placements_) count_use(placement);
        for (const auto& [look, use] : uses_) ++looks_with_id_[terminal_of(look).id];
        for (const Placement& placement : placements_) write_placement(placement);
        std::string text = svg_root_tag(grammar_.canvas, grammar_.sized) + '\n';
        if (!definitions_.empty()) text += "<defs>\n" + definitions_ + "</defs>\n";
        return text + body_ + "</svg>\n";
    }

  private:
    const Grammar& grammar_;
    const std::vector<Placement>& placements_;
    GrammarSvgOptions options_;
    StyleTable styles_;
    std::string prefix_;
    std::vector<double> reach_;
    std::map<Look, LookUse> uses_;
    std::map<std::string, int> looks_with_id_;
    std::string definitions_;
    std::string body_;

    const Terminal& terminal_of(const Look& look) const {
        return grammar_.terminals[static_cast<std::size_t>(look.terminal)];
    }

    /// No kept fragment and no element has an id that begins so.
    void choose_prefix() {
        prefix_ = "lsystem-";
        const auto taken = [&](const Terminal& terminal) {
            return terminal.verbatim.find(prefix_) != std::string::npos || terminal.id.starts_with(prefix_);
        };
        while (std::ranges::any_of(grammar_.terminals, taken)) prefix_ += '-';
    }

    void count_use(const Placement& placement) {
        const Look look = look_of(placement);
        LookUse& use = uses_[look];
        const std::string lengths = stroke_lengths(look, rounded_pose(placement));
        if (use.count > 0 && lengths != use.stroke_lengths) use.lengths_differ = true;
        use.stroke_lengths = lengths;
        ++use.count;
    }

    /// Of a fixed stroke, so that they are right under `map`.
    std::string stroke_lengths(const Look& look, const Affine& map) const {
        if (!terminal_of(look).verbatim.empty()) return {};
        const Style& style = styles_.style(look.style);
        if (!style.stroke.fixed || !paints_stroke(style)) return {};
        constexpr int digits = 6;  // a millionth of a stroke's width is never seen
        return svg_stroke_lengths(style.stroke, 1 / std::sqrt(std::abs(determinant(map))), digits);
    }

    /// How far from its origin a terminal reaches, with a stroke that follows its scale.
    double reach_of(const Terminal& terminal) const {
        const Style& style = styles_.style(terminal.style);
        const Box outline = style.stroke.fixed ? bounds(terminal.paths) : painted_box({terminal.paths, style});
        const Box box = terminal.verbatim.empty() ? outline : terminal.verbatim_box;
        if (is_empty(box)) return terminal.verbatim.empty() ? 0 : std::numeric_limits<double>::infinity();
        double reach = 0;
        for (const double x : {box.low.x, box.high.x}) {
            for (const double y : {box.low.y, box.high.y}) reach = std::max(reach, abs(Point{x, y}));
        }
        return reach;
    }

    Look look_of(const Placement& placement) const {
        Look look{placement.terminal, drawn_style_number(grammar_, placement)};
        if (!terminal_of(look).verbatim.empty()) return {placement.terminal};
        switch (options_.color_by) {
            case ColorBy::none: {
                const Style& style = styles_.style(look.style);
                const Style painted = repainted(style, placement.repaint);
                look.repaints_fill = painted.fill != style.fill;
                look.repaints_stroke = painted.stroke.paint != style.stroke.paint;
                break;
            }
            case ColorBy::rule:
                look.color = placement.production + 1;
                break;
            case ColorBy::terminal:
                look.color = placement.terminal;
                break;
            case ColorBy::level:
                look.color = static_cast<int>(placement.address.size());
                break;
        }
        return look;
    }

    /// The pose with its numbers rounded so that no point of the terminal moves by more than 1e-4 px, nor by more than a
    /// ten-millionth of the picture.
    Affine rounded_pose(const Placement& placement) const {
        const double reach = reach_[static_cast<std::size_t>(placement.terminal)];
        Affine map = to_affine(placement.pose);
        const double largest_move = is_empty(grammar_.canvas) ? 0 : std::min(1e-4, 1e-7 * diagonal(grammar_.canvas));
        if (!(largest_move > 0) || !std::isfinite(reach)) return map;
        // each of the two translations and of the two linear numbers in a coordinate has a quarter of the way
        const double share = largest_move / 4;
        for (double* number : {&map.e, &map.f}) *number = rounded_to(*number, share);
        if (reach > 0) {
            for (double* number : {&map.a, &map.b, &map.c, &map.d}) *number = rounded_to(*number, share / reach);
        }
        return map;
    }
    /// `value` in as few decimals as keep it within `error`.
    static double rounded_to(double value, double error) {
        const double decimals = std::ceil(-std::log10(2 * error));
        constexpr double most = 15;  // a double has no more
        if (decimals > most) return value;
        const double grid = std::pow(10.0, std::max(0.0, decimals));
        return std::round(value * grid) / grid;
    }

    void write_placement(const Placement& placement) {
        const Look look = look_of(placement);
        LookUse& use = uses_[look];
        const Affine map = rounded_pose(placement);
        if (use.count == 1) {
            const std::string& id = terminal_of(look).id;
            const std::string id_attribute = id.empty() || looks_with_id_[id] > 1 ? "" : " id=\"" + xml_escaped(id) + '"';
            body_ += drawn(look, placement.repaint, map, id_attribute + use.stroke_lengths, look_id(look));
            return;
        }
        if (use.id.empty()) {
            use.id = look_id(look);
            const std::string shared_lengths = use.lengths_differ ? "" : use.stroke_lengths;
            definitions_ += definition(look, " id=\"" + use.id + '"' + shared_lengths, use.id);
        }
        const std::string own_lengths = use.lengths_differ ? stroke_lengths(look, map) : "";
        body_ += "<use href=\"#" + use.id + '"' + transform_attribute(map) + paint_attributes(look, placement.repaint) +
                 own_lengths + "/>\n";
    }

    /// A definition that is repainted inherits its colours from its uses.
    std::string definition(const Look& look, const std::string& own_attributes, const std::string& gradient_prefix) {
        std::string text = drawn(look, {}, {}, own_attributes, gradient_prefix);
        if (look.repaints_fill) text = without_attribute(std::move(text), "fill");
        if (look.repaints_stroke) text = without_attribute(std::move(text), "stroke");
        return text;
    }

    static std::string paint_attributes(const Look& look, const Repaint& repaint) {
        std::string text;
        if (look.repaints_fill) text += " fill=\"" + svg_color_text(*repaint.fill) + '"';
        if (look.repaints_stroke) text += " stroke=\"" + svg_color_text(*repaint.stroke) + '"';
        return text;
    }

    std::string look_id(const Look& look) const {
        std::string id = prefix_ + terminal_of(look).symbol;
        if (look.style != terminal_of(look).style) id += "-style" + std::to_string(look.style);
        if (look.color >= 0) id += "-color" + std::to_string(look.color);
        if (look.repaints_fill) id += "-fill";
        if (look.repaints_stroke) id += "-stroke";
        return id;
    }

    /// The element itself with further attributes, under `map`; definitions of its gradients go to the definitions.
    std::string drawn(const Look& look, const Repaint& repaint, const Affine& map, const std::string& own_attributes,
                      const std::string& gradient_prefix) {
        const Terminal& terminal = terminal_of(look);
        Element element{terminal.paths, repainted(styles_.style(look.style), repaint), {}, terminal.verbatim, {}};
        if (look.color >= 0) element.style = recolored(std::move(element.style), distinct_color(look.color));
        const SvgElementText text = svg_element_text(element, gradient_prefix + '-');
        definitions_ += text.definitions;
        const std::string attributes = own_attributes + transform_attribute(map);
        if (attributes.empty()) return text.body + '\n';
        // a path takes the attributes itself unless its pen has given it a transform already
        constexpr std::string_view path_tag = "<path";
        if (terminal.verbatim.empty() && text.body.find(" transform=\"") == std::string::npos) {
            return std::string(path_tag) + attributes + text.body.substr(path_tag.size()) + '\n';
        }
        return "<g" + attributes + '>' + text.body + "</g>\n";
    }
};

}  // namespace

std::string grammar_svg(const Grammar& grammar, const std::vector<Placement>& placements, const GrammarSvgOptions& options) {
    return Writer(grammar, placements, options).write();
}

}  // namespace rinceau
