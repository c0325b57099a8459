// The picture with <use>: what is drawn more than once is defined once.

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <map>
#include <set>
#include <utility>

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

/// Before or behind others in paint order.
struct PaintPlace {
    int layer = 0;
    std::size_t order = 0;  ///< within the layer
    friend constexpr auto operator<=>(const PaintPlace&, const PaintPlace&) = default;
};

struct LookUse {
    int count = 0;
    PaintPlace first;  ///< of its placements
    std::string id;    ///< of the definition, if it has one
    /// Width and dashes of a fixed stroke, in the terminal's frame, if all placements agree in them; else each <use> has its
    /// own, which the definition inherits.
    std::string stroke_lengths;
    bool lengths_differ = false;
};

/// What a number is rounded to a multiple of 1 / steps of; 0 = it is kept.
struct Rounding {
    double steps = 0;

    Rounding() = default;
    /// To as few decimals as keep a number within `error`.
    explicit Rounding(double error) {
        const double decimals = std::ceil(-std::log10(2 * error));
        constexpr double most = 15;  // a double has no more
        if (decimals <= most) steps = std::pow(10.0, std::max(0.0, decimals));
    }
    double operator()(double value) const { return steps > 0 ? std::round(value * steps) / steps : value; }
};

/// So that no point of a terminal moves by more than 1e-4 px, nor by more than a ten-millionth of the picture.
struct PoseRounding {
    Rounding linear;
    Rounding translation;
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

/// Looks at all placements, in any order, before it writes any of them.
class Writer {
  public:
    Writer(const Grammar& grammar, const GrammarSvgOptions& options)
        : grammar_(grammar), options_(options), styles_(grammar) {
        choose_prefix();
        for (const Terminal& terminal : grammar.terminals) roundings_.push_back(rounding_of(terminal));
    }

    void look_at(const Placement& placement, PaintPlace place) {
        const Look look = look_of(placement);
        LookUse& use = uses_[look];
        if (paints_fixed_stroke(look)) {
            const std::string lengths = stroke_lengths(look, rounded_pose(placement));
            if (use.count > 0 && lengths != use.stroke_lengths) use.lengths_differ = true;
            use.stroke_lengths = lengths;
        }
        if (use.count == 0 || place < use.first) use.first = place;
        ++use.count;
    }

    /// Everything that stands before the placements.
    std::string head() {
        std::vector<std::pair<PaintPlace, Look>> looks;
        for (const auto& [look, use] : uses_) {
            ++looks_with_id_[terminal_of(look).id];
            looks.push_back({use.first, look});
        }
        std::ranges::sort(looks);
        std::string definitions;
        for (const auto& [place, look] : looks) definitions += definition(look);
        std::string text = svg_root_tag(grammar_.canvas, grammar_.sized) + '\n';
        if (!definitions.empty()) text += "<defs>\n" + definitions + "</defs>\n";
        return text;
    }

    void append(std::string& text, const Placement& placement) const {
        const Look look = look_of(placement);
        const LookUse& use = uses_.at(look);
        const Affine map = rounded_pose(placement);
        if (use.count == 1) {
            const std::string& id = terminal_of(look).id;
            const bool own = !id.empty() && looks_with_id_.at(id) == 1;
            const std::string id_attribute = own ? " id=\"" + xml_escaped(id) + '"' : "";
            const SvgElementText element = element_text(look, placement.repaint);
            text += placed(look, element, map, id_attribute + use.stroke_lengths);
            return;
        }
        text += "<use href=\"#";
        text += use.id;
        text += '"';
        text += transform_attribute(map);
        append_paint(text, look, placement.repaint);
        if (use.lengths_differ) text += stroke_lengths(look, map);
        text += "/>\n";
    }

    static constexpr const char* end = "</svg>\n";

  private:
    const Grammar& grammar_;
    GrammarSvgOptions options_;
    StyleTable styles_;
    std::string prefix_;
    std::vector<PoseRounding> roundings_;  ///< by terminal
    std::map<Look, LookUse> uses_;
    std::map<std::string, int> looks_with_id_;

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

    bool paints_fixed_stroke(const Look& look) const {
        if (!terminal_of(look).verbatim.empty()) return false;
        const Style& style = styles_.style(look.style);
        return style.stroke.fixed && paints_stroke(style);
    }

    /// Of a fixed stroke, so that they are right under `map`.
    std::string stroke_lengths(const Look& look, const Affine& map) const {
        constexpr int digits = 6;  // a millionth of a stroke's width is never seen
        return svg_stroke_lengths(styles_.style(look.style).stroke, 1 / std::sqrt(std::abs(determinant(map))), digits);
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
                if (placement.repaint == Repaint{}) break;
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

    PoseRounding rounding_of(const Terminal& terminal) const {
        const double reach = reach_of(terminal);
        const double largest_move = is_empty(grammar_.canvas) ? 0 : std::min(1e-4, 1e-7 * diagonal(grammar_.canvas));
        if (!(largest_move > 0) || !std::isfinite(reach)) return {};
        // each of the two translations and of the two linear numbers in a coordinate has a quarter of the way
        const double share = largest_move / 4;
        return {reach > 0 ? Rounding(share / reach) : Rounding(), Rounding(share)};
    }

    Affine rounded_pose(const Placement& placement) const {
        const PoseRounding& rounding = roundings_[static_cast<std::size_t>(placement.terminal)];
        Affine map = to_affine(placement.pose);
        for (double* number : {&map.e, &map.f}) *number = rounding.translation(*number);
        for (double* number : {&map.a, &map.b, &map.c, &map.d}) *number = rounding.linear(*number);
        return map;
    }

    /// What a look needs before it is drawn: its gradients, and itself if it is used more than once.
    std::string definition(const Look& look) {
        LookUse& use = uses_.at(look);
        SvgElementText element = element_text(look, {});
        if (use.count == 1) return element.definitions;
        use.id = look_id(look);
        const std::string shared_lengths = use.lengths_differ ? "" : use.stroke_lengths;
        std::string text = placed(look, element, {}, " id=\"" + use.id + '"' + shared_lengths);
        // one that is repainted inherits its colours from its uses
        if (look.repaints_fill) text = without_attribute(std::move(text), "fill");
        if (look.repaints_stroke) text = without_attribute(std::move(text), "stroke");
        return element.definitions + text;
    }

    static void append_paint(std::string& text, const Look& look, const Repaint& repaint) {
        if (look.repaints_fill) text += " fill=\"" + svg_color_text(*repaint.fill) + '"';
        if (look.repaints_stroke) text += " stroke=\"" + svg_color_text(*repaint.stroke) + '"';
    }

    std::string look_id(const Look& look) const {
        std::string id = prefix_ + terminal_of(look).symbol;
        if (look.style != terminal_of(look).style) id += "-style" + std::to_string(look.style);
        if (look.color >= 0) id += "-color" + std::to_string(look.color);
        if (look.repaints_fill) id += "-fill";
        if (look.repaints_stroke) id += "-stroke";
        return id;
    }

    SvgElementText element_text(const Look& look, const Repaint& repaint) const {
        const Terminal& terminal = terminal_of(look);
        Element element{terminal.paths, repainted(styles_.style(look.style), repaint), {}, terminal.verbatim, {}};
        if (look.color >= 0) element.style = recolored(std::move(element.style), distinct_color(look.color));
        return svg_element_text(element, look_id(look) + '-');
    }

    /// The element itself with further attributes, under `map`.
    std::string placed(const Look& look, const SvgElementText& element, const Affine& map,
                       const std::string& own_attributes) const {
        const std::string attributes = own_attributes + transform_attribute(map);
        if (attributes.empty()) return element.body + '\n';
        // a path takes the attributes itself unless its pen has given it a transform already
        constexpr std::string_view path_tag = "<path";
        if (terminal_of(look).verbatim.empty() && element.body.find(" transform=\"") == std::string::npos) {
            return std::string(path_tag) + attributes + element.body.substr(path_tag.size()) + '\n';
        }
        return "<g" + attributes + '>' + element.body + "</g>\n";
    }
};

/// The layers, as long as there are few layers.
class LayerCensus {
  public:
    static constexpr std::size_t most_passes = 8;  // deriving once more is cheap beside writing what is derived

    void add(int layer) {
        if (layers_.size() <= most_passes) layers_.insert(layer);
    }
    bool few() const { return layers_.size() <= most_passes; }
    const std::set<int>& layers() const { return layers_; }

  private:
    std::set<int> layers_;
};

}  // namespace

std::string grammar_svg(const Grammar& grammar, const std::vector<Placement>& placements, const GrammarSvgOptions& options) {
    Writer writer(grammar, options);
    for (std::size_t i = 0; i < placements.size(); ++i) writer.look_at(placements[i], {0, i});
    std::string text = writer.head();
    for (const Placement& placement : placements) writer.append(text, placement);
    return text + Writer::end;
}

void write_grammar_svg(const Grammar& grammar, const InterpretOptions& derivation, const GrammarSvgOptions& options,
                       const TextSink& sink, const Progress& progress) {
    Writer writer(grammar, options);
    LayerCensus census;
    std::size_t order = 0;
    visit_placements(
        grammar, derivation,
        [&](const Placement& placement) {
            writer.look_at(placement, {placement.layer, order++});
            census.add(placement.layer);
        },
        progress);
    TextPieces pieces(sink);
    pieces.text() = writer.head();
    const auto write = [&](const Placement& placement) {
        writer.append(pieces.text(), placement);
        pieces.pass_on_if_large();
    };
    if (census.few()) {
        for (const int layer : census.layers()) {
            const auto write_layer = [&](const Placement& placement) {
                if (placement.layer == layer) write(placement);
            };
            visit_placements(grammar, derivation, write_layer, progress);
        }
    } else {
        std::ranges::for_each(interpret(grammar, derivation, progress), write);
    }
    pieces.text() += Writer::end;
    pieces.pass_on();
}

}  // namespace rinceau
