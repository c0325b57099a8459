#include "closed_loop/findings.h"

#include <algorithm>

#include "closed_loop/shapes.h"
#include "lsystem/turtle_commands.h"

namespace rinceau::test {
namespace {

std::string joined(std::vector<std::string> rules) {
    std::ranges::sort(rules);
    std::string text;
    for (const std::string& rule : rules) text += (text.empty() ? "" : "; ") + rule;
    return text;
}

}  // namespace

std::string rules_in_words(const AnalysisReport& report) {
    std::vector<std::string> rules;
    for (const ProductionReport& production : report.productions) {
        std::string rule = production.kind + " of";
        for (const int length : production.lengths) rule += " " + std::to_string(length);
        rules.push_back(std::move(rule));
    }
    return joined(std::move(rules));
}

std::string rules_in_words(const KnownGrammar& known) {
    std::vector<std::string> rules;
    for (const ExpectedRule& rule : known.rules) rules.push_back(rule.kind + " of " + std::to_string(rule.count));
    return joined(std::move(rules));
}

int axiom_symbols(const Grammar& grammar) {
    return static_cast<int>(std::ranges::count_if(
        grammar.axiom, [](const ModuleTemplate& module) { return find_turtle_command(module.symbol) == nullptr; }));
}

bool is_found(const ListedScene& scene, const Analysis& found) {
    const AnalysisReport& report = found.report;
    const int rules = static_cast<int>(report.productions.size());
    const int terminals = static_cast<int>(report.terminals.size());
    const int exceptions = static_cast<int>(found.grammar.exceptions.size());
    const bool few = rules >= scene.rules && rules <= scene.most_rules && axiom_symbols(found.grammar) <= scene.axiom_symbols &&
                     (scene.terminals == 0 || terminals <= scene.terminals);
    const bool regular = scene.family == "noise" || 5 * exceptions <= report.elements;
    return few && regular && report.check.passed;
}

std::vector<KnownScene> scenes_but(const std::vector<std::string>& names) {
    std::vector<KnownScene> scenes = known_scenes();
    std::erase_if(scenes, [&](const KnownScene& known) { return std::ranges::find(names, known.name) != names.end(); });
    return scenes;
}

Scene carried(const Scene& scene, const Similarity& map) {
    Scene result;
    for (const Element& element : scene.elements) {
        result.elements.push_back(placed(element, map));
        result.viewport = including(result.viewport, painted_box(result.elements.back()));
    }
    return result;
}

}  // namespace rinceau::test
