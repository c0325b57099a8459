#include "scene/svg_css.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace rinceau {

namespace {

bool has_word(std::string_view list, std::string_view word) {
    if (word.empty()) return false;
    for (std::size_t at = list.find(word); at != std::string_view::npos; at = list.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || is_svg_space(list[at - 1])) && (end == list.size() || is_svg_space(list[end]))) return true;
    }
    return false;
}

CssPlace place_of(const CssTree& tree, CssNode node) {
    if (tree.place) return tree.place(node);
    CssPlace place;
    const std::string_view name = tree.name(node);
    for (CssNode other = tree.previous(node); other; other = tree.previous(other)) {
        ++place.child;
        if (tree.name(other) == name) ++place.of_type;
    }
    for (CssNode other = tree.next(node); other; other = tree.next(other)) {
        ++place.child_from_end;
        if (tree.name(other) == name) ++place.of_type_from_end;
    }
    return place;
}

bool is_nth(int position, int step, int offset) {
    const int distance = position - offset;
    if (step == 0) return distance == 0;
    return distance % step == 0 && distance / step >= 0;
}

// "en-GB" is in the languages "de,en"; case says nothing. (Selectors 3, section 6.6.3)
bool is_language(std::string_view language, std::string_view ranges) {
    const std::string full = lower_case(language);
    for (std::size_t at = 0; at <= ranges.size();) {
        const std::size_t end = std::min(ranges.find(',', at), ranges.size());
        const std::string range = lower_case(ranges.substr(at, end - at));
        const bool begins = !range.empty() && full.starts_with(range);
        if (begins && (full.size() == range.size() || full[range.size()] == '-')) return true;
        at = end + 1;
    }
    return false;
}

bool attribute_passes(const CssCondition& condition, std::string_view value) {
    const std::string_view wanted = condition.value;
    switch (condition.test) {
        case CssTest::attribute:
            return true;
        case CssTest::attribute_is:
            return value == wanted;
        case CssTest::attribute_word:
            return has_word(value, wanted);
        case CssTest::attribute_dash:
            return value.starts_with(wanted) && (value.size() == wanted.size() || value[wanted.size()] == '-');
        case CssTest::attribute_starts:
            return !wanted.empty() && value.starts_with(wanted);
        case CssTest::attribute_ends:
            return !wanted.empty() && value.ends_with(wanted);
        case CssTest::attribute_contains:
            return !wanted.empty() && value.find(wanted) != std::string_view::npos;
        default:
            return false;
    }
}

bool passes(const CssCondition& condition, const CssTree& tree, CssNode node) {
    switch (condition.test) {
        case CssTest::type:
            return condition.name == "*" || tree.name(node) == condition.name;
        case CssTest::id:
            return tree.attribute(node, "id") == std::string_view(condition.name);
        case CssTest::has_class:
            return has_word(tree.attribute(node, "class").value_or(""), condition.name);
        case CssTest::first_child:
            return !tree.previous(node);
        case CssTest::last_child:
            return !tree.next(node);
        case CssTest::only_child:
            return !tree.previous(node) && !tree.next(node);
        case CssTest::nth_child:
            return is_nth(place_of(tree, node).child, condition.step, condition.offset);
        case CssTest::nth_last_child:
            return is_nth(place_of(tree, node).child_from_end, condition.step, condition.offset);
        case CssTest::nth_of_type:
            return is_nth(place_of(tree, node).of_type, condition.step, condition.offset);
        case CssTest::nth_last_of_type:
            return is_nth(place_of(tree, node).of_type_from_end, condition.step, condition.offset);
        case CssTest::only_of_type: {
            const CssPlace place = place_of(tree, node);
            return place.of_type == 1 && place.of_type_from_end == 1;
        }
        case CssTest::empty:
            return tree.empty && tree.empty(node);
        case CssTest::link:
            return tree.link && tree.link(node);
        case CssTest::language:
            return tree.language && is_language(tree.language(node), condition.value);
        case CssTest::root:
            return !tree.parent(node);
        case CssTest::never:
            return false;
        default: {
            const std::optional<std::string_view> value = tree.attribute(node, condition.name);
            return value && attribute_passes(condition, *value);
        }
    }
}

bool compound_passes(const std::vector<CssCondition>& compound, const CssTree& tree, CssNode node) {
    return std::all_of(compound.begin(), compound.end(),
                       [&](const CssCondition& condition) { return passes(condition, tree, node) != condition.negated; });
}

// Why a match failed tells which other candidates cannot succeed either; without it a search would try all combinations.
enum class Match { found, fails_here, fails_for_siblings, fails_everywhere };

Match match_from(const CssSelector& selector, std::size_t i, const CssTree& tree, CssNode node) {
    if (!compound_passes(selector.compounds[i], tree, node)) return Match::fails_here;
    if (i + 1 == selector.compounds.size()) return Match::found;
    switch (selector.combinators[i]) {
        case CssCombinator::descendant:
            while ((node = tree.parent(node))) {
                const Match match = match_from(selector, i + 1, tree, node);
                if (match == Match::found || match == Match::fails_everywhere) return match;
            }
            return Match::fails_everywhere;
        case CssCombinator::child: {
            const CssNode parent = tree.parent(node);
            if (!parent) return Match::fails_everywhere;
            const Match match = match_from(selector, i + 1, tree, parent);
            return match == Match::found || match == Match::fails_everywhere ? match : Match::fails_here;
        }
        case CssCombinator::adjacent: {
            const CssNode previous = tree.previous(node);
            if (!previous) return Match::fails_for_siblings;
            const Match match = match_from(selector, i + 1, tree, previous);
            return match == Match::fails_for_siblings ? Match::fails_here : match;
        }
        case CssCombinator::sibling:
            while ((node = tree.previous(node))) {
                const Match match = match_from(selector, i + 1, tree, node);
                if (match != Match::fails_here) return match;
            }
            return Match::fails_for_siblings;
    }
    return Match::fails_here;
}

// Declarations in the order of the cascade: later ones win.
struct Candidate {
    bool important = false;
    std::uint32_t specificity = 0;
    std::uint32_t order = 0;
    const CssDeclaration* declaration = nullptr;
};

constexpr std::uint32_t style_attribute_weight = std::numeric_limits<std::uint32_t>::max();

class RuleMatcher {
  public:
    RuleMatcher(const StyleSheet& sheet, const CssTree& tree, CssNode node) : sheet_(sheet), tree_(tree), node_(node) {}

    std::vector<Candidate> candidates() {
        if (sheet_.rules.empty()) return {};
        try_rules(sheet_.others);
        try_indexed(sheet_.by_type, tree_.name(node_));
        if (const auto id = tree_.attribute(node_, "id")) try_indexed(sheet_.by_id, *id);
        if (const auto classes = tree_.attribute(node_, "class")) try_classes(*classes);
        return std::move(candidates_);
    }

  private:
    void try_classes(std::string_view classes) {
        std::vector<std::string_view> seen;
        TextCursor cursor{classes};
        for (skip_space(cursor); !cursor.at_end(); skip_space(cursor)) {
            const std::size_t start = cursor.at;
            while (!cursor.at_end() && !is_svg_space(cursor.peek())) ++cursor.at;
            const std::string_view name = classes.substr(start, cursor.at - start);
            if (std::find(seen.begin(), seen.end(), name) != seen.end()) continue;
            seen.push_back(name);
            try_indexed(sheet_.by_class, name);
        }
    }
    void try_indexed(const std::unordered_map<std::string, std::vector<std::uint32_t>>& index, std::string_view key) {
        const auto found = index.find(std::string(key));
        if (found != index.end()) try_rules(found->second);
    }
    void try_rules(const std::vector<std::uint32_t>& numbers) {
        for (const std::uint32_t number : numbers) {
            const CssRule& rule = sheet_.rules[number];
            if (!matches(rule.selector, tree_, node_)) continue;
            for (const CssDeclaration& declaration : sheet_.blocks[rule.block]) {
                candidates_.push_back({declaration.important, rule.selector.specificity, number, &declaration});
            }
        }
    }

    const StyleSheet& sheet_;
    const CssTree& tree_;
    CssNode node_;
    std::vector<Candidate> candidates_;
};

}  // namespace

bool matches(const CssSelector& selector, const CssTree& tree, CssNode node) {
    return match_from(selector, 0, tree, node) == Match::found;
}

SpecifiedStyle specified_style(const StyleSheet& sheet, const CssTree& tree, CssNode node,
                               std::span<const std::pair<std::string_view, std::string_view>> presentation,
                               std::string_view style_attribute, const CssAccepts& accepts) {
    // Collect all that speaks of this element, weakest first.
    std::vector<Candidate> candidates = RuleMatcher(sheet, tree, node).candidates();
    const std::vector<CssDeclaration> own = parse_declarations(style_attribute);
    for (const CssDeclaration& declaration : own) {
        candidates.push_back({declaration.important, style_attribute_weight, 0, &declaration});
    }
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
        return std::tie(a.important, a.specificity, a.order) < std::tie(b.important, b.specificity, b.order);
    });
    std::vector<std::pair<std::string_view, std::string_view>> all(presentation.begin(), presentation.end());
    for (const Candidate& candidate : candidates)
        all.push_back({candidate.declaration->property, candidate.declaration->value});

    // Keep the strongest value of each property.
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    SpecifiedStyle style;
    for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
        while (end < all.size() && all[end].first == all[first].first) ++end;
        std::size_t chosen = end - 1;
        if (accepts)
            while (chosen > first && !accepts(all[chosen].first, all[chosen].second)) --chosen;
        // The weakest was not asked yet.
        if (chosen == first && end - first > 1 && accepts && !accepts(all[first].first, all[first].second)) chosen = end - 1;
        style.push_back({std::string(all[chosen].first), std::string(all[chosen].second)});
    }
    return style;
}

const std::string* find_value(const SpecifiedStyle& style, std::string_view property) {
    const auto found = std::lower_bound(style.begin(), style.end(), property,
                                        [](const auto& entry, std::string_view name) { return entry.first < name; });
    return found != style.end() && found->first == property ? &found->second : nullptr;
}

}  // namespace rinceau
