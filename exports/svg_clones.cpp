#include "exports/svg_clones.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "exports/unique_names.h"
#include "lsystem/derivation_graph.h"
#include "lsystem/flat_grammar.h"
#include "lsystem/to_scene.h"
#include "scene/svg_write.h"

namespace rinceau {

namespace {

/// A look, or what a part has in one layer above its own beginning.
struct Thing {
    bool is_look = false;
    int index = 0;
    int layer = 0;
    friend constexpr auto operator<=>(const Thing&, const Thing&) = default;
};

class ClonesWriter {
  public:
    ClonesWriter(const Grammar& grammar, const DerivationGraph& graph)
        : grammar_(grammar), graph_(graph), names_(taken_ids(grammar)), layers_(graph.parts.size()) {}

    std::string write() {
        find_layers();
        const Thing root{false, static_cast<int>(graph_.parts.size()) - 1, 0};
        const std::set<int>& layers = layers_.back();
        for (const int layer : layers) count_uses({root.is_look, root.index, layer});
        std::string body;
        for (const int layer : layers) body += layer_text({root.is_look, root.index, layer}, layers.size() > 1);
        std::string tag = svg_root_tag(grammar_.canvas, grammar_.sized);
        tag.insert(tag.size() - 1, " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"");
        std::string text = tag + '\n';
        if (!grammar_.title.empty()) text += "<title>" + xml_escaped(grammar_.title) + "</title>\n";
        if (!definitions_.empty()) text += "<defs>\n" + definitions_ + "</defs>\n";
        return text + body + "</svg>\n";
    }

  private:
    const Grammar& grammar_;
    const DerivationGraph& graph_;
    UniqueNames names_;
    std::vector<std::set<int>> layers_;  ///< of each part, above its own beginning
    std::map<Thing, int> uses_;
    std::map<Thing, std::string> ids_;  ///< of originals that are written
    std::string definitions_;

    /// Ids inside fragments, which stay as they are.
    static std::set<std::string> taken_ids(const Grammar& grammar) {
        std::set<std::string> taken;
        for (const Terminal& terminal : grammar.terminals) {
            const std::string& text = terminal.verbatim;
            constexpr std::string_view mark = "id=";
            for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1)) {
                const std::size_t first = at + mark.size() + 1;
                if (first > text.size()) break;
                taken.insert(text.substr(first, text.find(text[first - 1], first) - first));
            }
        }
        return taken;
    }

    const GraphPart& part_of(const Thing& thing) const { return graph_.parts[static_cast<std::size_t>(thing.index)]; }

    void find_layers() {
        for (std::size_t i = 0; i < graph_.parts.size(); ++i) {
            for (const PartItem& item : graph_.parts[i].items) {
                if (item.is_look) {
                    layers_[i].insert(item.layer);
                    continue;
                }
                for (const int layer : layers_[static_cast<std::size_t>(item.index)]) layers_[i].insert(item.layer + layer);
            }
        }
    }

    /// What an item has in a layer of the part around it, if anything.
    std::optional<Thing> thing_in(const PartItem& item, int layer) const {
        const int above = layer - item.layer;
        const bool there = item.is_look ? above == 0 : layers_[static_cast<std::size_t>(item.index)].contains(above);
        return there ? std::optional(Thing{item.is_look, item.index, above}) : std::nullopt;
    }

    void count_uses(const Thing& thing) {
        if (thing.is_look) return;
        for (const PartItem& item : part_of(thing).items) {
            const std::optional<Thing> inside = thing_in(item, thing.layer);
            if (inside && ++uses_[*inside] == 1) count_uses(*inside);
        }
    }

    std::string layer_text(const Thing& root, bool several) {
        std::string items = items_text(root);
        if (!several) return items;
        const std::string number = std::to_string(root.layer);
        return "<g id=\"" + names_.take("layer" + number) + "\" inkscape:groupmode=\"layer\" inkscape:label=\"Layer " +
               number + "\">\n" + items + "</g>\n";
    }

    std::string items_text(const Thing& thing) {
        std::string text;
        for (const PartItem& item : part_of(thing).items) {
            if (const std::optional<Thing> inside = thing_in(item, thing.layer)) text += placed_text(*inside, item.pose);
        }
        return text;
    }

    /// The first of several is the original, every other one a clone of it. The original has no transform of its own, so
    /// that a clone's transform is its place.
    std::string placed_text(const Thing& thing, const Similarity& pose) {
        const std::string transform = transform_of(pose);
        const std::string lengths = stroke_lengths(thing, pose);
        if (uses_[thing] == 1) {
            const std::string id = names_.take(wanted_id(thing));
            return original_text(thing, " id=\"" + xml_escaped(id) + '"' + transform + lengths, id);
        }
        const auto [place, added] = ids_.try_emplace(thing);
        if (!added) return "<use xlink:href=\"#" + xml_escaped(place->second) + '"' + transform + lengths + "/>\n";
        const std::string id = names_.take(wanted_id(thing));
        place->second = id;
        const std::string original = original_text(thing, " id=\"" + xml_escaped(id) + '"', id);
        const std::string around = transform + lengths;
        return around.empty() ? original : "<g" + around + ">\n" + original + "</g>\n";
    }

    const Terminal& terminal_of(const Thing& thing) const {
        const GraphLook& look = graph_.looks[static_cast<std::size_t>(thing.index)];
        return grammar_.terminals[static_cast<std::size_t>(look.terminal)];
    }
    Style style_of(const Thing& thing) const {
        return look_style(grammar_, graph_.looks[static_cast<std::size_t>(thing.index)]);
    }

    std::string wanted_id(const Thing& thing) const {
        if (!thing.is_look) return part_of(thing).symbol;
        const Terminal& terminal = terminal_of(thing);
        return terminal.id.empty() ? terminal.symbol : terminal.id;
    }

    std::string original_text(const Thing& thing, const std::string& attributes, const std::string& id) {
        if (!thing.is_look)
            return "<g" + attributes + " inkscape:label=\"" + part_of(thing).symbol + "\">\n" + items_text(thing) + "</g>\n";
        const Terminal& terminal = terminal_of(thing);
        const std::string label = " inkscape:label=\"" + terminal.symbol + '"';
        const SvgElementText text = svg_element_text({terminal.paths, style_of(thing), {}, terminal.verbatim, {}}, id + '-');
        definitions_ += text.definitions;
        constexpr std::string_view path_tag = "<path";
        const bool is_path = terminal.verbatim.empty() && text.body.find(" transform=\"") == std::string::npos;
        if (is_path) return std::string(path_tag) + attributes + label + text.body.substr(path_tag.size()) + '\n';
        return "<g" + attributes + label + '>' + text.body + "</g>\n";
    }

    /// Of a stroke whose width does not follow the scale: the inverse of it, which the original inherits.
    std::string stroke_lengths(const Thing& thing, const Similarity& pose) const {
        if (!thing.is_look || !terminal_of(thing).verbatim.empty()) return {};
        const Style style = style_of(thing);
        if (!style.stroke.fixed || !paints_stroke(style)) return {};
        return svg_stroke_lengths(style.stroke, 1 / scale_of(pose));
    }

    std::string transform_of(const Similarity& pose) const {
        const double size = is_empty(grammar_.canvas) ? 0 : diagonal(grammar_.canvas);
        constexpr double share = 1e-11;  // far below what a chain of transforms needs to stay exact to the eye and to tests
        Affine map = to_affine(pose);
        for (double* number : {&map.a, &map.b, &map.c, &map.d}) *number = rounded(*number, share);
        for (double* number : {&map.e, &map.f}) *number = rounded(*number, share * size);
        const std::string text = svg_transform_text(map);
        return text.empty() ? "" : " transform=\"" + text + '"';
    }

    /// In as few decimals as keep it within `error`; as it is if that is 0, or if it is so small itself that its digits
    /// count.
    static double rounded(double value, double error) {
        if (!(error > 0) || std::abs(value) < 1e5 * error) return value;
        const double grid = std::pow(10.0, std::ceil(-std::log10(2 * error)));
        return grid >= 1 ? std::round(value * grid) / grid : value;
    }
};

bool has_fixed_stroke(const Grammar& grammar) {
    return std::ranges::any_of(grammar.styles, [](const NumberedStyle& style) { return style.style.stroke.fixed; });
}

}  // namespace

Export to_svg_clones(const Grammar& grammar, const ExportOptions& options) {
    Export result;
    // inside a group that is cloned in several sizes a stroke could not keep its width
    std::optional<DerivationGraph> graph;
    if (!has_fixed_stroke(grammar)) graph = derivation_graph(grammar, options.derive);
    if (graph) {
        result.bytes = ClonesWriter(grammar, *graph).write();
        return result;
    }
    const Grammar flat = flat_grammar(grammar, options.derive);
    result.bytes = ClonesWriter(flat, *derivation_graph(flat)).write();
    result.notes.push_back(
        has_fixed_stroke(grammar)
            ? "because of strokes of fixed width every element is a clone by itself, without groups of rules"
            : "because a rule closes a bracket of another every element is a clone by itself, without groups of rules");
    return result;
}

}  // namespace rinceau
