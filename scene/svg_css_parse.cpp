// Style sheet text to rules. CSS 2.1, chapter 4 (blocks, at-rules), Selectors 3, chapters 4 to 8.

#include <algorithm>
#include <utility>

#include "scene/svg_css.h"

namespace rinceau {

namespace {

constexpr std::uint32_t id_weight = 1u << 20;
constexpr std::uint32_t class_weight = 1u << 10;
constexpr int deepest_media = 16;

std::uint32_t weight_of(const CssCondition& condition) {
    if (condition.test == CssTest::id) return id_weight;
    return condition.test == CssTest::type ? (condition.name == "*" ? 0 : 1) : class_weight;
}

// "odd", "even", "3", "2n+1", "-n + 3".
bool read_nth(std::string_view text, CssCondition& condition) {
    std::string compact;
    for (const char c : lower_case(text)) {
        if (!is_svg_space(c)) compact += c;
    }
    if (compact == "odd") compact = "2n+1";
    if (compact == "even") compact = "2n";
    const auto whole = [](std::string_view part) -> std::optional<int> {
        TextCursor cursor{part};
        const std::optional<double> value = read_number(cursor);
        constexpr double largest = 1e6;
        if (!value || !cursor.at_end() || *value != static_cast<int>(std::clamp(*value, -largest, largest)))
            return std::nullopt;
        return static_cast<int>(*value);
    };
    const std::size_t n = compact.find('n');
    std::optional<int> step = 0;
    std::optional<int> offset = 0;
    if (n == std::string::npos) {
        offset = whole(compact);
    } else {
        const std::string factor = compact.substr(0, n);
        step = factor.empty() || factor == "+" ? 1 : factor == "-" ? -1 : whole(factor);
        if (n + 1 < compact.size()) offset = whole(std::string_view(compact).substr(n + 1));
    }
    if (!step || !offset) return false;
    condition.step = *step;
    condition.offset = *offset;
    return true;
}

class SelectorReader {
  public:
    explicit SelectorReader(std::string_view text) : cursor_{trimmed(text)} {}

    std::optional<CssSelector> read() {
        // Left to right as written; the order is turned around at the end.
        CssSelector selector;
        for (;;) {
            std::vector<CssCondition> compound;
            if (!read_compound(compound) || compound.empty()) return std::nullopt;
            for (const CssCondition& condition : compound) selector.specificity += weight_of(condition);
            selector.compounds.push_back(std::move(compound));
            if (cursor_.at_end()) break;
            const std::optional<CssCombinator> combinator = read_combinator();
            if (!combinator) return std::nullopt;
            selector.combinators.push_back(*combinator);
        }
        std::reverse(selector.compounds.begin(), selector.compounds.end());
        std::reverse(selector.combinators.begin(), selector.combinators.end());
        return selector;
    }

  private:
    std::optional<CssCombinator> read_combinator() {
        const std::size_t start = cursor_.at;
        skip_space(cursor_);
        CssCombinator combinator = CssCombinator::descendant;
        if (skip_token(cursor_, ">")) {
            combinator = CssCombinator::child;
        } else if (skip_token(cursor_, "+")) {
            combinator = CssCombinator::adjacent;
        } else if (skip_token(cursor_, "~")) {
            combinator = CssCombinator::sibling;
        } else if (cursor_.at == start) {
            return std::nullopt;
        }
        skip_space(cursor_);
        return combinator;
    }

    bool read_compound(std::vector<CssCondition>& compound) {
        while (!cursor_.at_end()) {
            const char c = cursor_.peek();
            if (is_svg_space(c) || c == '>' || c == '+' || c == '~') return true;
            std::optional<CssCondition> condition = read_condition();
            if (!condition) return false;
            compound.push_back(std::move(*condition));
        }
        return true;
    }

    std::optional<CssCondition> read_condition() {
        if (skip_token(cursor_, ".")) return named(CssTest::has_class);
        if (skip_token(cursor_, "#")) return read_id();
        if (skip_token(cursor_, "[")) return read_attribute();
        if (skip_token(cursor_, ":")) return read_pseudo_class();
        return read_type();
    }

    std::optional<CssCondition> named(CssTest test) {
        std::optional<std::string> name = read_css_identifier(cursor_);
        if (!name) return std::nullopt;
        CssCondition condition{test};
        condition.name = std::move(*name);
        return condition;
    }

    // Ids may start with a digit, as many programs write them, though CSS would not have it.
    std::optional<CssCondition> read_id() {
        CssCondition condition{CssTest::id};
        while (cursor_.peek() >= '0' && cursor_.peek() <= '9') condition.name += cursor_.text[cursor_.at++];
        if (const std::optional<std::string> name = read_css_identifier(cursor_)) condition.name += *name;
        return condition.name.empty() ? std::nullopt : std::optional(condition);
    }

    // A namespace prefix "svg|" or "*|" says nothing here.
    std::optional<CssCondition> read_type() {
        CssCondition condition{CssTest::type};
        for (;;) {
            if (skip_token(cursor_, "*")) {
                condition.name.assign(1, '*');
            } else if (std::optional<std::string> name = read_css_identifier(cursor_)) {
                condition.name = std::move(*name);
            } else if (cursor_.peek() != '|') {
                return std::nullopt;
            }
            if (!skip_token(cursor_, "|")) break;
        }
        return condition;
    }

    std::optional<CssCondition> read_attribute() {
        skip_space(cursor_);
        std::optional<CssCondition> condition = named(CssTest::attribute);
        if (!condition) return std::nullopt;
        skip_space(cursor_);
        if (skip_token(cursor_, "]")) return condition;
        constexpr std::pair<std::string_view, CssTest> operators[] = {
            {"=", CssTest::attribute_is},      {"~=", CssTest::attribute_word}, {"|=", CssTest::attribute_dash},
            {"^=", CssTest::attribute_starts}, {"$=", CssTest::attribute_ends}, {"*=", CssTest::attribute_contains}};
        for (const auto& [token, test] : operators) {
            if (!skip_token(cursor_, token)) continue;
            condition->test = test;
            skip_space(cursor_);
            std::optional<std::string> value = read_css_string(cursor_);
            if (!value) value = read_css_identifier(cursor_);
            if (!value) return std::nullopt;
            condition->value = std::move(*value);
            skip_space(cursor_);
            return skip_token(cursor_, "]") ? condition : std::nullopt;
        }
        return std::nullopt;
    }

    std::optional<CssCondition> read_pseudo_class() {
        const std::optional<std::string> name = read_css_identifier(cursor_);
        if (!name) return std::nullopt;
        const std::string pseudo = lower_case(*name);
        if (std::optional<CssCondition> condition = plain_pseudo_class(pseudo)) return condition;
        if (!skip_token(cursor_, "(")) return std::nullopt;
        const std::size_t end = find_css_end(cursor_.text, cursor_.at, ")");
        if (end == cursor_.text.size()) return std::nullopt;
        const std::string_view inside = trimmed(cursor_.text.substr(cursor_.at, end - cursor_.at));
        cursor_.at = end + 1;
        if (pseudo == "not") return negated(inside);
        if (pseudo == "lang") return in_language(inside);
        return counted(pseudo, inside);
    }

    // Those without an argument.
    static std::optional<CssCondition> plain_pseudo_class(std::string_view pseudo) {
        constexpr std::pair<std::string_view, CssTest> plain[] = {{"first-child", CssTest::first_child},
                                                                  {"last-child", CssTest::last_child},
                                                                  {"only-child", CssTest::only_child},
                                                                  {"only-of-type", CssTest::only_of_type},
                                                                  {"empty", CssTest::empty},
                                                                  {"link", CssTest::link},
                                                                  {"any-link", CssTest::link},
                                                                  {"root", CssTest::root},
                                                                  {"hover", CssTest::never},
                                                                  {"active", CssTest::never},
                                                                  {"focus", CssTest::never},
                                                                  {"visited", CssTest::never},
                                                                  {"target", CssTest::never}};
        for (const auto& [text, test] : plain) {
            if (pseudo == text) return CssCondition{test};
        }
        if (pseudo == "first-of-type") return counted("nth-of-type", "1");
        if (pseudo == "last-of-type") return counted("nth-last-of-type", "1");
        return std::nullopt;
    }

    static std::optional<CssCondition> counted(std::string_view pseudo, std::string_view inside) {
        constexpr std::pair<std::string_view, CssTest> counting[] = {{"nth-child", CssTest::nth_child},
                                                                     {"nth-last-child", CssTest::nth_last_child},
                                                                     {"nth-of-type", CssTest::nth_of_type},
                                                                     {"nth-last-of-type", CssTest::nth_last_of_type}};
        for (const auto& [text, test] : counting) {
            CssCondition condition{test};
            if (pseudo == text) return read_nth(inside, condition) ? std::optional(condition) : std::nullopt;
        }
        return std::nullopt;
    }

    // "en", "'de-AT', fr": identifiers or strings.
    static std::optional<CssCondition> in_language(std::string_view inside) {
        CssCondition condition{CssTest::language};
        TextCursor cursor{inside};
        do {
            skip_space(cursor);
            std::optional<std::string> range = read_css_string(cursor);
            if (!range) range = read_css_identifier(cursor);
            if (!range) return std::nullopt;
            condition.value += (condition.value.empty() ? "" : ",") + *range;
            skip_space(cursor);
        } while (skip_token(cursor, ","));
        return cursor.at_end() ? std::optional(condition) : std::nullopt;
    }

    // One simple selector inside :not(), no :not() again.
    static std::optional<CssCondition> negated(std::string_view inside) {
        if (lower_case(inside.substr(0, 5)) == ":not(") return std::nullopt;
        SelectorReader reader(inside);
        std::optional<CssCondition> condition = reader.read_condition();
        if (!condition || !reader.cursor_.at_end()) return std::nullopt;
        condition->negated = true;
        return condition;
    }

    TextCursor cursor_;
};

// Does the drawing, shown on a screen, belong to one of these media?
bool media_apply(std::string_view list) {
    if (trimmed(list).empty()) return true;
    for (std::size_t at = 0; at <= list.size();) {
        const std::size_t end = std::min(list.find(',', at), list.size());
        const std::string medium = lower_case(trimmed(list.substr(at, end - at)));
        if (medium == "all" || medium == "screen" || medium == "only screen") return true;
        at = end + 1;
    }
    return false;
}

void add_fault(StyleSheet& sheet, const std::string& fault) {
    if (std::find(sheet.faults.begin(), sheet.faults.end(), fault) == sheet.faults.end()) sheet.faults.push_back(fault);
}

void index_rule(StyleSheet& sheet, std::uint32_t number) {
    const std::vector<CssCondition>& subject = sheet.rules[number].selector.compounds.front();
    const auto find = [&](CssTest test) -> const CssCondition* {
        for (const CssCondition& condition : subject) {
            if (condition.test == test && !condition.negated && condition.name != "*") return &condition;
        }
        return nullptr;
    };
    if (const CssCondition* id = find(CssTest::id)) {
        sheet.by_id[id->name].push_back(number);
    } else if (const CssCondition* by_class = find(CssTest::has_class)) {
        sheet.by_class[by_class->name].push_back(number);
    } else if (const CssCondition* type = find(CssTest::type)) {
        sheet.by_type[type->name].push_back(number);
    } else {
        sheet.others.push_back(number);
    }
}

// A faulty selector makes its whole group faulty. (CSS 2.1, section 4.1.7)
void add_rule(StyleSheet& sheet, std::string_view selectors, std::string_view block) {
    std::vector<CssSelector> group;
    for (std::size_t at = 0; at <= selectors.size();) {
        const std::size_t end = find_css_end(selectors, at, ",");
        std::optional<CssSelector> selector = SelectorReader(selectors.substr(at, end - at)).read();
        if (!selector) {
            add_fault(sheet, "style rule skipped, selector not understood: \"" + std::string(trimmed(selectors)) + "\"");
            return;
        }
        group.push_back(std::move(*selector));
        at = end + 1;
    }
    const auto block_number = static_cast<std::uint32_t>(sheet.blocks.size());
    sheet.blocks.push_back(parse_declarations(block));
    for (CssSelector& selector : group) {
        sheet.rules.push_back({std::move(selector), block_number});
        index_rule(sheet, static_cast<std::uint32_t>(sheet.rules.size() - 1));
    }
}

void add_rules(StyleSheet& sheet, std::string_view text, int depth);

// An at-rule from its '@' on; returns where the next rule starts.
std::size_t add_at_rule(StyleSheet& sheet, std::string_view text, std::size_t at, int depth) {
    const std::size_t end = find_css_end(text, at, ";{");
    TextCursor name{text.substr(at + 1, end - at - 1)};
    const std::string keyword = lower_case(read_css_identifier(name).value_or(""));
    const bool harmless = keyword == "charset" || keyword == "namespace" || keyword == "font-face" || keyword == "keyframes";
    if (end == text.size() || text[end] == ';') {
        if (!harmless) add_fault(sheet, "style rule skipped: @" + keyword);
        return end + 1;
    }
    const std::size_t close = find_css_end(text, end + 1, "}");
    if (keyword == "media") {
        const bool apply = media_apply(name.text.substr(name.at)) && depth < deepest_media;
        if (apply) add_rules(sheet, text.substr(end + 1, close - end - 1), depth + 1);
    } else if (!harmless) {
        add_fault(sheet, "style rule skipped: @" + keyword);
    }
    return close + 1;
}

void add_rules(StyleSheet& sheet, std::string_view text, int depth) {
    for (std::size_t at = 0; at < text.size();) {
        if (is_svg_space(text[at]) || text[at] == ';' || text[at] == '}') {
            ++at;
        } else if (text[at] == '@') {
            at = add_at_rule(sheet, text, at, depth);
        } else {
            const std::size_t open = find_css_end(text, at, "{");
            if (open == text.size()) {
                add_fault(sheet, "style sheet ends within a rule");
                return;
            }
            const std::size_t close = find_css_end(text, open + 1, "}");
            add_rule(sheet, text.substr(at, open - at), text.substr(open + 1, close - open - 1));
            at = close + 1;
        }
    }
}

}  // namespace

StyleSheet parse_style_sheets(std::span<const std::string> sheets) {
    StyleSheet result;
    for (const std::string& sheet : sheets) add_rules(result, without_css_comments(sheet), 0);
    return result;
}

}  // namespace rinceau
