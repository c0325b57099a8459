// Style sheets, and the cascade over a small drawing. What follows the first NUL is the attribute `style` of every element.

#include <algorithm>
#include <array>

#include "scene/svg_css.h"
#include "tests/fuzz/fuzz_target.h"

namespace rinceau {
namespace {

/// <svg lang="en-GB"> <g id="a" class="x y"> <path class="y"/> <path id="b" fill="red"/> </g> <text/> </svg>
struct Node {
    std::string_view name;
    std::vector<std::pair<std::string_view, std::string_view>> attributes;
    int parent = -1, previous = -1, next = -1;
};

const std::array<Node, 5> tree_nodes{{
    {"svg", {{"lang", "en-GB"}}},
    {"g", {{"id", "a"}, {"class", "x y"}}, 0, -1, 4},
    {"path", {{"class", "y"}}, 1, -1, 3},
    {"path", {{"id", "b"}, {"fill", "red"}}, 1, 2, -1},
    {"text", {}, 0, 1, -1},
}};

const Node& node_of(CssNode node) { return *static_cast<const Node*>(node); }
CssNode at(int index) { return index < 0 ? nullptr : &tree_nodes[static_cast<std::size_t>(index)]; }

CssTree tree() {
    CssTree tree;
    tree.name = [](CssNode node) { return node_of(node).name; };
    tree.attribute = [](CssNode node, std::string_view name) -> std::optional<std::string_view> {
        for (const auto& [known, value] : node_of(node).attributes)
            if (known == name) return value;
        return std::nullopt;
    };
    tree.parent = [](CssNode node) { return at(node_of(node).parent); };
    tree.previous = [](CssNode node) { return at(node_of(node).previous); };
    tree.next = [](CssNode node) { return at(node_of(node).next); };
    tree.empty = [](CssNode node) { return node_of(node).name == "path"; };
    tree.language = [](CssNode) { return std::string_view("en-GB"); };
    return tree;
}

void check_sheet(const StyleSheet& sheet) {
    for (const CssRule& rule : sheet.rules) {
        require(rule.block < sheet.blocks.size(), "a rule has a block");
        require(rule.selector.compounds.size() == rule.selector.combinators.size() + 1,
                "combinators stand between compounds");
    }
}

/// The index of the rules and a plain look at each of them say the same.
void check_cascade(const StyleSheet& sheet, const CssTree& tree, CssNode node, const SpecifiedStyle& style) {
    const auto by_property = [](const auto& a, const auto& b) { return a.first < b.first; };
    require(std::is_sorted(style.begin(), style.end(), by_property), "specified values are sorted");
    for (std::size_t i = 1; i < style.size(); ++i) require(style[i - 1].first != style[i].first, "one value a property");
    for (const CssRule& rule : sheet.rules) {
        if (!matches(rule.selector, tree, node)) continue;
        for (const CssDeclaration& declaration : sheet.blocks[rule.block])
            require(find_value(style, declaration.property) != nullptr, "a rule that matches has its say");
    }
}

}  // namespace

void take_input(std::string_view bytes) {
    const std::size_t end = std::min(bytes.find('\0'), bytes.size());
    const std::vector<std::string> sheets{std::string(bytes.substr(0, end))};
    const std::string_view attribute = bytes.substr(std::min(end + 1, bytes.size()));
    const StyleSheet sheet = parse_style_sheets(sheets);
    check_sheet(sheet);
    for (const Node& node : tree_nodes) {
        const SpecifiedStyle style = specified_style(sheet, tree(), &node, node.attributes, attribute);
        check_cascade(sheet, tree(), &node, style);
    }
}

}  // namespace rinceau
