#pragma once
// Style sheets: rules, selectors, and the cascade that gives each element its specified values (CSS 2.1, chapters 5 and 6,
// and of Selectors 3 what drawings use). Nothing here knows the XML library: the tree is seen through CssTree.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "scene/svg_css_text.h"

namespace rinceau {

/// An element of the caller's tree; null = none.
using CssNode = const void*;

/// Where an element stands among the elements of its parent, from 1.
struct CssPlace {
    int child = 1, child_from_end = 1;      ///< among all of them
    int of_type = 1, of_type_from_end = 1;  ///< among those of its name
};

/// How selectors see the tree. Only elements count as parents and siblings. Each call must take constant time, on average
/// over all elements; only `language` may take as long as the tree is deep.
struct CssTree {
    std::function<std::string_view(CssNode)> name;  ///< local name, without namespace prefix
    std::function<std::optional<std::string_view>(CssNode, std::string_view)> attribute;
    std::function<CssNode(CssNode)> parent;
    std::function<CssNode(CssNode)> previous;  ///< sibling before
    std::function<CssNode(CssNode)> next;      ///< sibling after
    std::function<CssPlace(CssNode)> place;    ///< may be left empty (counted by `previous` and `next`)
    // Those left empty say no of every element.
    std::function<bool(CssNode)> empty;                 ///< holds neither elements nor text
    std::function<bool(CssNode)> link;                  ///< an `a` that leads somewhere
    std::function<std::string_view(CssNode)> language;  ///< of its text, as "en-GB"
};

enum class CssCombinator : std::uint8_t { descendant, child, adjacent, sibling };
enum class CssTest : std::uint8_t {
    type,
    id,
    has_class,
    attribute,
    attribute_is,
    attribute_word,
    attribute_dash,
    attribute_starts,
    attribute_ends,
    attribute_contains,
    first_child,
    last_child,
    only_child,
    nth_child,
    nth_last_child,
    nth_of_type,
    nth_last_of_type,
    only_of_type,
    empty,
    link,
    language,
    root,
    never
};

/// One simple selector.
struct CssCondition {
    CssTest test = CssTest::type;  ///< never: what needs a person, as :hover
    bool negated = false;          ///< inside :not()
    std::string name;              ///< type, id, class or attribute
    std::string value;             ///< of the attribute, or the languages: "de,en"
    int step = 0, offset = 0;      ///< nth-child(step n + offset) and its like
};

/// "g > path.a": compounds from right to left; combinators[i] stands between compounds[i] and compounds[i + 1].
struct CssSelector {
    std::vector<std::vector<CssCondition>> compounds;
    std::vector<CssCombinator> combinators;
    std::uint32_t specificity = 0;  ///< ids * 2^20 + classes * 2^10 + types
};

struct CssRule {
    CssSelector selector;
    std::uint32_t block = 0;  ///< into StyleSheet::blocks
};

/// All rules of a drawing in the order of its text, with an index by the rightmost compound.
struct StyleSheet {
    std::vector<CssRule> rules;
    std::vector<std::vector<CssDeclaration>> blocks;
    std::unordered_map<std::string, std::vector<std::uint32_t>> by_id, by_class, by_type;  ///< rule numbers, rising
    std::vector<std::uint32_t> others;
    std::vector<std::string> faults;  ///< one sentence for each thing that was skipped, no repeats
};

/// The sheets in document order (text of each <style>, CDATA marks allowed in it). Comments and at-rules are skipped, but
/// @media all and @media screen apply. A rule with a selector that is not understood is skipped and reported.
StyleSheet parse_style_sheets(std::span<const std::string> sheets);

/// Specified values, sorted by property, one entry each.
using SpecifiedStyle = std::vector<std::pair<std::string, std::string>>;

/// Is this value of this property understood?
using CssAccepts = std::function<bool(std::string_view property, std::string_view value)>;

/// The cascade of one element: presentation attributes (given by the caller; specificity 0), rules by specificity and
/// order, the attribute `style`, !important above all. Nothing is inherited here and shorthands are not taken apart.
/// Of several values of a property the strongest that `accepts` likes holds, as drawings that offer a newer syntax first
/// or last expect ("fill:#d00; fill:color(display-p3 1 0 0)"); if it likes none of them, the strongest.
SpecifiedStyle specified_style(const StyleSheet& sheet, const CssTree& tree, CssNode node,
                               std::span<const std::pair<std::string_view, std::string_view>> presentation,
                               std::string_view style_attribute, const CssAccepts& accepts = {});

/// The value of a property, null if it is not specified.
const std::string* find_value(const SpecifiedStyle& style, std::string_view property);

bool matches(const CssSelector& selector, const CssTree& tree, CssNode node);

}  // namespace rinceau
