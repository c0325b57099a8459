#include "scene/svg_replacement.h"

#include "scene/svg_adopt.h"
#include "scene/svg_budget.h"
#include "scene/svg_document.h"
#include "scene/svg_draw.h"
#include "scene/svg_excerpt.h"
#include "scene/svg_fragment.h"
#include "scene/svg_originals.h"
#include "scene/svg_splice.h"
#include "scene/svg_write.h"

namespace rinceau {

struct SvgReplacement::State {
    SvgReadOptions options;
    std::string text;
    SvgTree tree;
    SvgSelection selection;
    SvgExcerpt excerpt;
    std::string rules;
    std::set<std::string> surrounding;  ///< properties that the elements around the place, or style sheets, set
    std::set<std::string> sheet_properties;
};

namespace {

SvgSourceOptions source_options(const SvgReadOptions& options) {
    return {options.file_name, options.max_bytes, options.max_depth};
}

std::string description_of(const SvgNode* group) {
    if (group == nullptr) return {};
    for (const SvgNode* child = group->first_child; child != nullptr; child = child->next) {
        if (is_text(*child) || !is_svg(*child) || child->name != "desc") continue;
        std::string text;
        for (const SvgNode* part = child->first_child; part != nullptr; part = part->next) text += part->text;
        return text;
    }
    return {};
}

/// What elements below `parent` inherit from it and its parents, by name.
std::set<std::string> inherited_properties(SvgReader& reader, const SvgNode& child) {
    const auto contexts = ancestor_contexts(reader, child);
    std::set<std::string> properties;
    for (const auto& [property, value] : inherited_declarations(*contexts.back())) properties.insert(property);
    return properties;
}

/// The text is UTF-8 now, whatever it was.
void declare_utf8(std::string& text) {
    if (!text.starts_with("<?xml")) return;
    const std::size_t end = text.find("?>"), name = text.find("encoding");
    if (name >= end) return;
    const std::size_t open = text.find_first_of("\"'", name);
    if (open >= end) return;
    const std::size_t close = text.find(text[open], open + 1);
    if (close < end) text.replace(open + 1, close - open - 1, "UTF-8");
}

bool is_inside(const SvgNode* node, const std::unordered_set<const SvgNode*>& elements) {
    for (; node != nullptr; node = node->parent)
        if (elements.contains(node)) return true;
    return false;
}

}  // namespace

IdsByRules ids_by_rules(std::string_view document, std::span<const std::string> ids, const SvgReadOptions& options) {
    const SvgTree tree = parse_svg_tree(svg_source_text(document, source_options(options)), source_options(options));
    IdsByRules result;
    for (const std::string& id : ids) {
        bool found = false;
        for (const SvgNode* up = tree.find(id); up != nullptr && !found; up = up->parent)
            found = find_attribute(*up, rules_group_attribute) != nullptr;
        (found ? result.with_rules : result.others).push_back(id);
    }
    return result;
}

SvgReplacement::SvgReplacement(std::string_view document, std::span<const std::string> ids, const SvgReadOptions& options)
    : state_(std::make_unique<State>()) {
    State& state = *state_;
    state.options = options;
    state.text = svg_source_text(document, source_options(options));
    state.tree = parse_svg_tree(state.text, source_options(options));
    SvgReader reader = reader_of(state.tree, state.options);
    expanded_elements(reader);
    const std::optional<SvgContext> root = enter_root(reader);
    if (!root) return;
    state.selection = select_elements(reader, *root, ids);
    if (state.selection.chosen.empty()) return;
    state.rules = description_of(state.selection.rules);
    state.sheet_properties = properties_of(reader.sheet);
    state.surrounding = inherited_properties(reader, *state.selection.chosen.back());
    state.surrounding.insert(state.sheet_properties.begin(), state.sheet_properties.end());
    state.excerpt = read_excerpt(reader, *root, state.selection);
}

SvgReplacement::~SvgReplacement() = default;

const Scene& SvgReplacement::scene() const { return state_->excerpt.scene; }
const std::vector<Warning>& SvgReplacement::warnings() const { return state_->excerpt.warnings; }
const std::string& SvgReplacement::rules() const { return state_->rules; }
std::size_t SvgReplacement::overtaken() const { return state_->excerpt.overtaken; }

std::string SvgReplacement::document_with(const SvgReplacementContent& content) const {
    const State& state = *state_;
    const SvgSelection& selection = state.selection;
    const SvgMarkupIndex markup(state.text, state.tree);
    const std::unordered_set<const SvgNode*> removed(selection.chosen.begin(), selection.chosen.end());
    const std::vector<const SvgNode*> kept = referred_to(state.tree, removed);
    const std::unordered_set<const SvgNode*> kept_set(kept.begin(), kept.end());

    // What was selected stays selected: the group has the name of an element that goes.
    std::string id = "rinceau";
    for (int number = 2; state.tree.find(id) != nullptr; ++number) id = "rinceau-" + std::to_string(number);
    const std::string_view* name = find_attribute(*selection.chosen.back(), "id");
    if (name != nullptr && !name->empty() && state.tree.find(*name) == selection.chosen.back() &&
        !kept_set.contains(selection.chosen.back()))
        id = xml_escaped(std::string(*name));

    // Make the drawing fit to stand in the document.
    const auto is_taken = [&](const std::string& wanted) {
        const SvgNode* node = state.tree.find(wanted);
        return (wanted == id && selection.rules == nullptr) || (node != nullptr && (!is_inside(node, removed) || is_inside(node, kept_set)));
    };
    const auto drawing = parse_svg_document(content.svg);
    make_originals_real(*drawing);
    rename_ids(*drawing, is_taken);
    use_xlink(*drawing);
    shield_styles(*drawing, state.sheet_properties);

    // Write the group.
    std::string inside = "<desc>" + xml_escaped(content.rules) + "</desc>" + content_text(*drawing);
    std::vector<TextEdit> edits;
    if (selection.rules != nullptr) {
        const SvgMarkup& group = markup.of(*selection.rules);
        edits.push_back({group.tag_end, group.content_end, inside});
    } else {
        std::string tag = "<g xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\""
                          " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" id=\"" +
                          id + "\" inkscape:label=\"" + xml_escaped(content.label) + "\" " +
                          std::string(rules_group_attribute) + "=\"rules\"";
        const std::string style = initial_declarations(state.surrounding);
        if (!style.empty()) tag += " style=\"" + style + "\"";
        for (const SvgNode* node : selection.chosen) edits.push_back(removal(state.text, markup.of(*node)));
        edits.back().begin = markup.of(*selection.chosen.back()).begin;
        edits.back().text = tag + ">" + inside + "</g>";
    }
    if (!kept.empty()) {
        std::string elements;
        for (const SvgNode* node : kept) {
            const SvgMarkup& place = markup.of(*node);
            elements += state.text.substr(place.begin, place.end - place.begin);
        }
        edits.push_back(addition_to_definitions(state.text, state.tree, markup, elements));
    }
    std::string result = with_edits(state.text, std::move(edits));
    declare_utf8(result);
    return result;
}

}  // namespace rinceau
