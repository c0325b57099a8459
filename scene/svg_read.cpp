#include "scene/svg_read.h"

#include "scene/compound_path.h"
#include "scene/svg_budget.h"
#include "scene/svg_draw.h"
#include "scene/svg_number.h"
#include "scene/svg_source.h"

namespace rinceau {
namespace {

CssTree css_tree() {
    const auto node = [](CssNode css) { return static_cast<const SvgNode*>(css); };
    return {.name = [node](CssNode css) { return node(css)->name; },
            .attribute = [node](CssNode css, std::string_view name) -> std::optional<std::string_view> {
                const std::string_view* value = find_attribute(*node(css), name);
                return value == nullptr ? std::nullopt : std::optional(*value);
            },
            .parent = [node](CssNode css) -> CssNode { return node(css)->parent; },
            .previous = [node](CssNode css) -> CssNode { return node(css)->previous_element; },
            .next = [node](CssNode css) -> CssNode { return node(css)->next_element; },
            .position = [node](CssNode css) { return node(css)->position; }};
}

bool is_style_sheet(const SvgNode& node) {
    if (!is_svg(node) || node.name != "style") return false;
    const std::string_view* type = find_attribute(node, "type");
    return type == nullptr || type->empty() || lower_case(trimmed(*type)) == "text/css";
}

void collect_sheets(const SvgNode& node, std::vector<std::string>& sheets) {
    for (const SvgNode* child = node.first_child; child != nullptr; child = child->next) {
        if (!is_style_sheet(*child)) {
            collect_sheets(*child, sheets);
            continue;
        }
        std::string& sheet = sheets.emplace_back();
        for (const SvgNode* text = child->first_child; text != nullptr; text = text->next) sheet += text->text;
    }
}

StyleSheet style_sheet_of(const SvgTree& tree) {
    std::vector<std::string> sheets;
    collect_sheets(tree.root(), sheets);
    return parse_style_sheets(sheets);
}

/// What would come from other files.
void note_inclusions(SvgReader& reader, const SvgNode& node) {
    if (node.name == "include" && node.space_name == "http://www.w3.org/2001/XInclude")
        reader.warnings.add("{} XInclude elements are left out: other files are not read", node);
    for (const SvgNode* child = node.first_child; child != nullptr; child = child->next) note_inclusions(reader, *child);
}

}  // namespace

SvgReadResult read_svg(std::string_view bytes, const SvgReadOptions& options) {
    const SvgSourceOptions source{options.file_name, options.max_bytes, options.max_depth};
    const std::string text = svg_source_text(bytes, source);
    const SvgTree tree = parse_svg_tree(text, source);
    SvgReader reader{.tree = tree, .options = options, .sheet = style_sheet_of(tree), .css = css_tree()};
    reader.scene.elements.reserve(expanded_elements(reader));
    for (const std::string& fault : reader.sheet.faults) reader.warnings.add(fault, tree.root());
    note_inclusions(reader, tree.root());
    if (text.substr(0, text.find("<svg")).find("<?xml-stylesheet") != std::string::npos)
        reader.warnings.add("style sheets in other files (xml-stylesheet) are not read", tree.root());
    draw_root(reader);
    if (options.split_compound_paths) reader.scene.elements = split_compound_paths(std::move(reader.scene.elements));
    return {std::move(reader.scene), reader.warnings.summary(options.file_name)};
}

}  // namespace rinceau
