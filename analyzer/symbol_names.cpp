#include "analyzer/symbol_names.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "analyzer/rule_comment.h"
#include "lsystem/number_text.h"

namespace rinceau {

namespace {

/// Ids that drawing programs give by themselves.
constexpr std::array machine_words{
    "arc",     "artboard", "circle", "clip",   "clippath", "combined", "compound", "curve",    "defs",  "element",
    "ellipse", "fill",     "glyph", "group",  "image",  "item",     "layer",    "line",     "mask",     "node",  "object",
    "outline", "oval",     "page",  "patch",  "path",   "pattern",  "polygon",  "polyline", "rect",     "rectangle",
    "shape",   "stroke",   "style", "subtract", "surface", "svg",   "svgid",    "symbol",   "text",     "tspan", "union",
    "use",     "vector",   "xmlid"};

constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
constexpr char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// "window" of "window-12"; nothing if what comes before the number is no word.
std::optional<std::string> word_of(std::string_view id) {
    constexpr std::size_t shortest = 3, longest = 24;
    constexpr std::string_view ours = "lsystem-";  // pictures of grammars carry their symbols as "lsystem-Window"
    if (id.starts_with(ours)) id.remove_prefix(ours.size());
    while (!id.empty() && !is_letter(id.back())) id.remove_suffix(1);
    std::string word, small;
    bool vowel = false;
    for (const char c : id) {
        const bool joint = c == '-' || c == '_' || c == ' ' || c == '.';
        if (!is_letter(c) && !joint) return {};
        word += joint ? '_' : c;
        small += lower(c);
        vowel = vowel || std::string_view("aeiouy").find(lower(c)) != std::string_view::npos;
    }
    if (word.size() < shortest || word.size() > longest || !vowel || !is_letter(word.front())) return {};
    if (std::ranges::find(machine_words, small) != machine_words.end()) return {};
    word.front() = upper(word.front());
    return word;
}

/// The word that all of a look's elements share, by look.
std::vector<std::optional<std::string>> words_of_looks(const Instancing& instancing, const Scene& scene) {
    std::vector<std::optional<std::string>> words(instancing.looks.size());
    std::vector<bool> seen(instancing.looks.size(), false);
    for (std::size_t e = 0; e < instancing.instances.size(); ++e) {
        const auto look = static_cast<std::size_t>(instancing.instances[e].look);
        const bool first = !seen[look];
        seen[look] = true;
        if (!first && !words[look]) continue;
        const std::optional<std::string> word = word_of(scene.elements[e].id);
        if (first || word != words[look]) words[look] = first ? word : std::nullopt;
    }
    return words;
}

/// Gives out each name once.
class Names {
  public:
    std::string numbered(const std::string& word) {
        int& count = counts_[word];
        for (;;) {
            ++count;
            std::string name = count == 1 ? word : word + std::to_string(count);
            if (take(name)) return name;
        }
    }
    bool take(const std::string& name) {
        if (taken_.count(name) > 0 || taken_.count(name + count_ending) > 0) return false;
        if (name.ends_with(count_ending)) return false;  // the constants of rings
        return taken_.insert(name).second;
    }

  private:
    static constexpr const char* count_ending = "_count";
    std::set<std::string> taken_;
    std::map<std::string, int> counts_;
};

}  // namespace

std::string terminal_letter(int index) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
    const auto count = static_cast<int>(letters.size());
    const std::string letter(1, letters[static_cast<std::size_t>(index % count)]);
    return index < count ? letter : letter + std::to_string(index / count);
}

std::vector<std::string> look_names(const Instancing& instancing, const Scene& scene) {
    const std::vector<std::optional<std::string>> words = words_of_looks(instancing, scene);
    Names given;
    std::vector<std::string> names;
    int letters = 0;
    for (const std::optional<std::string>& word : words) {
        names.push_back(word ? given.numbered(*word) : terminal_letter(letters++));
    }
    return names;
}

int named_kinds(const Instancing& instancing, const Scene& scene) {
    std::vector<std::set<std::string>> words(instancing.looks.size());
    for (std::size_t e = 0; e < instancing.instances.size(); ++e) {
        const auto word = word_of(scene.elements[e].id);
        if (word) words[static_cast<std::size_t>(instancing.instances[e].look)].insert(*word);
    }
    std::size_t kinds = 0;
    for (const std::set<std::string>& of_look : words) kinds += std::max<std::size_t>(1, of_look.size());
    return static_cast<int>(kinds);
}

std::vector<std::string> symbol_names(const RuleSet& rules, const std::vector<bool>& in_use,
                                      const std::vector<int>& top_down, const std::vector<RuleUse>& uses,
                                      const std::vector<std::string>& look_names) {
    Names given;
    std::vector<std::string> names(rules.parts.size());
    for (std::size_t p = 0; p < rules.parts.size(); ++p) {
        if (rules.parts[p].look < 0 || !in_use[p]) continue;
        names[p] = look_names[static_cast<std::size_t>(rules.parts[p].look)];
        given.take(names[p]);
    }
    std::map<int, std::string> of_rule;
    for (const int each : top_down) {
        const auto p = static_cast<std::size_t>(each);
        const Part& part = rules.parts[p];
        if (!in_use[p]) continue;
        const bool alone = rules.rules[static_cast<std::size_t>(part.rule)].kind == RuleKind::linear;
        std::string& known = of_rule[part.rule];
        names[p] = !alone && !known.empty() ? known : given.numbered(rule_name(rules, part, uses));
        known = names[p];
    }
    return names;
}

}  // namespace rinceau
