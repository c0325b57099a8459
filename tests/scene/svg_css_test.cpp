#include <catch2/catch.hpp>

#include <chrono>
#include <deque>
#include <map>

#include "scene/svg_css.h"

using namespace rinceau;

namespace {

// A small tree by hand.
struct Node {
    std::string name;
    std::map<std::string, std::string, std::less<>> attributes;
    const Node* parent = nullptr;
    const Node* previous = nullptr;
    const Node* next = nullptr;
    Node* last_child = nullptr;
};

class Tree {
  public:
    Node* add(Node* parent, std::string name, std::map<std::string, std::string, std::less<>> attributes = {}) {
        nodes_.push_back({std::move(name), std::move(attributes), parent, parent ? parent->last_child : nullptr});
        Node* node = &nodes_.back();
        if (parent) {
            if (parent->last_child) parent->last_child->next = node;
            parent->last_child = node;
        }
        return node;
    }

  private:
    std::deque<Node> nodes_;
};

CssTree access() {
    const auto node = [](CssNode n) { return static_cast<const Node*>(n); };
    CssTree tree;
    tree.name = [node](CssNode n) -> std::string_view { return node(n)->name; };
    tree.attribute = [node](CssNode n, std::string_view name) -> std::optional<std::string_view> {
        const auto found = node(n)->attributes.find(name);
        return found == node(n)->attributes.end() ? std::nullopt : std::optional<std::string_view>(found->second);
    };
    tree.parent = [node](CssNode n) -> CssNode { return node(n)->parent; };
    tree.previous = [node](CssNode n) -> CssNode { return node(n)->previous; };
    tree.next = [node](CssNode n) -> CssNode { return node(n)->next; };
    tree.empty = [node](CssNode n) { return node(n)->last_child == nullptr; };
    tree.link = [node](CssNode n) { return node(n)->attributes.contains("href"); };
    tree.language = [node](CssNode n) -> std::string_view {
        const auto found = node(n)->attributes.find("lang");
        return found == node(n)->attributes.end() ? std::string_view{} : std::string_view(found->second);
    };
    return tree;
}

StyleSheet sheet_of(const std::string& text) { return parse_style_sheets(std::vector<std::string>{text}); }

std::string fill_of(const std::string& sheet, const Node* node, std::string_view style = {}) {
    const std::vector<std::pair<std::string_view, std::string_view>> presentation{{"fill", "presentation"}};
    return *find_value(specified_style(sheet_of(sheet), access(), node, presentation, style), "fill");
}

}  // namespace

TEST_CASE("of several values of a property the strongest that is understood holds") {
    const StyleSheet sheet = parse_style_sheets({});
    const CssTree tree{
        .name = [](CssNode) { return "rect"; },
        .attribute = [](CssNode, std::string_view) -> std::optional<std::string_view> { return std::nullopt; }};
    const auto short_ones = [](std::string_view, std::string_view value) { return value.size() <= 4; };
    const std::vector<std::pair<std::string_view, std::string_view>> presentation = {{"fill", "blue"}};
    const auto fill = [&](std::string_view style) {
        return *find_value(specified_style(sheet, tree, nullptr, presentation, style, short_ones), "fill");
    };
    CHECK(fill("fill:red;fill:color(display-p3 1 0 0)") == "red");
    CHECK(fill("fill:red!important;fill:lime") == "red");
    CHECK(fill("fill:color(display-p3 1 0 0)") == "blue");
    CHECK(fill("") == "blue");
}

TEST_CASE("each kind of selector matches what it names and nothing else") {
    Tree tree;
    Node* root = tree.add(nullptr, "svg");
    Node* group = tree.add(root, "g", {{"class", "k wide"}, {"id", "g1"}});
    Node* first = tree.add(group, "rect", {{"data-a", "one two"}, {"lang", "en-GB"}});
    Node* second = tree.add(group, "circle", {{"class", "red"}, {"id", "7up"}, {"href", "#g1"}});
    Node* third = tree.add(group, "rect");
    struct Case {
        const char* selector;
        std::vector<const Node*> matched;
    };
    const Case cases[] = {
        {"*", {root, group, first, second, third}},
        {"rect", {first, third}},
        {".k", {group}},
        {".wide.k", {group}},
        {".wid", {}},
        {"#g1", {group}},
        {"#7up", {second}},
        {"g#g1.k", {group}},
        {"svg rect", {first, third}},
        {"svg > rect", {}},
        {"svg>g>rect", {first, third}},
        {"rect + circle", {second}},
        {"rect ~ rect", {third}},
        {"circle ~ rect", {third}},
        {"circle + circle", {}},
        {"[data-a]", {first}},
        {"[data-a='one two']", {first}},
        {"[data-a~=two]", {first}},
        {"[data-a~=tw]", {}},
        {"[lang|=en]", {first}},
        {"[lang^=\"en-\"]", {first}},
        {"[lang$=GB]", {first}},
        {"[lang*=n-G]", {first}},
        {":root", {root}},
        {"rect:first-child", {first}},
        {"rect:last-child", {third}},
        {"g > :nth-child(2)", {second}},
        {"g > :nth-child(odd)", {first, third}},
        {"g > :nth-child( -n + 2 )", {first, second}},
        {"rect:not(:first-child)", {third}},
        {"g > :not(.red)", {first, third}},
        {"rect:hover", {}},
        {"svg|rect", {first, third}},
        {"g:only-child", {group}},
        {"g > :nth-last-child(1)", {third}},
        {"g > :nth-last-child(n+2)", {first, second}},
        {"rect:first-of-type", {first}},
        {"g > :last-of-type", {second, third}},
        {"rect:nth-of-type(2)", {third}},
        {"rect:nth-last-of-type(2)", {first}},
        {"g > :only-of-type", {second}},
        {":empty", {first, second, third}},
        {"rect:not(:empty)", {}},
        {":link", {second}},
        {":not(:any-link)", {root, group, first, third}},
        {":lang(EN)", {first}},
        {":lang('en-gb')", {first}},
        {":lang(e)", {}},
        {":lang(fr, 'EN')", {first}},
        {"svg g rect", {first, third}},
    };
    for (const Case& c : cases) {
        const StyleSheet sheet = sheet_of(std::string(c.selector) + "{fill:x}");
        CAPTURE(c.selector);
        REQUIRE(sheet.rules.size() == 1);
        CHECK(sheet.faults.empty());
        for (const Node* node : {root, group, first, second, third}) {
            const bool expected = std::find(c.matched.begin(), c.matched.end(), node) != c.matched.end();
            CHECK(matches(sheet.rules[0].selector, access(), node) == expected);
            const SpecifiedStyle style = specified_style(sheet, access(), node, {}, {});
            CHECK((find_value(style, "fill") != nullptr) == expected);
        }
    }
}

TEST_CASE("specificity decides, then the order, then !important over all") {
    Tree tree;
    Node* root = tree.add(nullptr, "svg");
    Node* rect = tree.add(root, "rect", {{"class", "a b"}, {"id", "i"}});
    CHECK(fill_of("", rect) == "presentation");
    CHECK(fill_of("*{fill:star}", rect) == "star");
    CHECK(fill_of("rect{fill:type} *{fill:star}", rect) == "type");
    CHECK(fill_of("rect{fill:1} rect{fill:2}", rect) == "2");
    CHECK(fill_of(".a{fill:class} svg rect{fill:types}", rect) == "class");
    CHECK(fill_of(".a.b{fill:classes} .a{fill:class}", rect) == "classes");
    CHECK(fill_of("#i{fill:id} svg rect.a.b{fill:classes}", rect) == "id");
    CHECK(fill_of("rect:first-child{fill:pseudo} rect{fill:type}", rect) == "pseudo");
    CHECK(fill_of("#i{fill:id}", rect, "fill:own") == "own");
    CHECK(fill_of("rect{fill:important ! IMPORTANT} #i{fill:id}", rect, "fill:own") == "important");
    CHECK(fill_of("rect{fill:important !important}", rect, "fill:own!important") == "own");
    CHECK(fill_of("rect{fill:1;fill:2}", rect, "fill:3;FILL: 4 ;") == "4");
}

TEST_CASE("comments, marks, at-rules and media are understood, faulty rules are skipped alone and reported") {
    Tree tree;
    Node* rect = tree.add(nullptr, "rect");
    CHECK(fill_of("<!-- rect{/* fill:no; } */fill:yes} -->", rect) == "yes");
    CHECK(fill_of("<![CDATA[ rect{fill:yes} ]]>", rect) == "yes");
    CHECK(fill_of("@charset 'x'; @font-face{src:url(a)} rect{fill:yes}", rect) == "yes");
    CHECK(fill_of("@media screen, print {rect{fill:yes}}", rect) == "yes");
    CHECK(fill_of("rect{fill:yes} @media print{rect{fill:no}}", rect) == "yes");
    CHECK(fill_of("g, rect , path{fill:yes}", rect) == "yes");
    CHECK(fill_of("rect{a:url(data:x;y);fill:yes", rect) == "yes");
    const StyleSheet sheet =
        sheet_of("rect:frob(2){fill:no} rect, ::before{fill:no} rect{fill:yes} rect:frob(2){fill:no} @import 'x';");
    CHECK(sheet.rules.size() == 1);
    CHECK(sheet.faults.size() == 3);
}

TEST_CASE("style sheets of any bytes are read to their end") {
    for (const char* text : {"{", "}", "}}}{{{", "@", "@media", "@media{", "a{b:c", "a[b", "a[b='", ":not(", "\\", "a{\\",
                             "/*", "a{b:'c}", ",{}", "a:nth-child(n n){}"}) {
        CAPTURE(text);
        CHECK(sheet_of(text).rules.size() <= 1);
    }
    std::string deep;
    for (int i = 0; i < 20000; ++i) deep += "@media all{";
    CHECK(sheet_of(deep).rules.empty());
}

TEST_CASE("a selector of many steps on a deep tree is decided quickly") {
    Tree tree;
    Node* node = tree.add(nullptr, "g");
    for (int i = 0; i < 3000; ++i) node = tree.add(node, "g");
    const StyleSheet sheet =
        sheet_of("x g g g g g g g g g g g g g g g g g g g g{fill:no} g g > g g g > g g g g g g g g{fill:yes}");
    const auto start = std::chrono::steady_clock::now();
    CHECK_FALSE(matches(sheet.rules[0].selector, access(), node));
    CHECK(matches(sheet.rules[1].selector, access(), node));
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(1));
}
