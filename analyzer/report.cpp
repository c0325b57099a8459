#include "analyzer/report.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "analyzer/rule_comment.h"

namespace rinceau {

namespace {

std::string modules_text(const std::vector<ModuleTemplate>& modules) {
    std::string text;
    for (const ModuleTemplate& module : modules) {
        if (!text.empty()) text += ' ';
        text += module.symbol;
        if (module.arguments.empty()) continue;
        text += '(';
        for (std::size_t k = 0; k < module.arguments.size(); ++k) text += (k > 0 ? "," : "") + to_text(module.arguments[k]);
        text += ')';
    }
    return text;
}

std::string production_text(const Production& production) {
    std::string text = production.symbol;
    if (!production.parameters.empty()) {
        text += '(';
        for (std::size_t k = 0; k < production.parameters.size(); ++k) text += (k > 0 ? "," : "") + production.parameters[k];
        text += ')';
    }
    if (production.condition) text += " : " + to_text(*production.condition);
    return text + " -> " + modules_text(production.successor);
}

}  // namespace

void fill_report(AnalysisReport& report, const OrderedRules& ordered, const WrittenGrammar& written, const Grammar& grammar,
                 const Instancing& instancing) {
    const RuleSet& rules = ordered.rules;
    report.elements = static_cast<int>(instancing.instances.size());
    report.axiom = modules_text(grammar.axiom);

    // Terminals: parts of looks that have a name.
    std::vector<int> instances(instancing.looks.size(), 0), mirrored(instancing.looks.size(), 0);
    for (const Instance& instance : instancing.instances) {
        ++instances[static_cast<std::size_t>(instance.look)];
        mirrored[static_cast<std::size_t>(instance.look)] += instance.pose.mirrored ? 1 : 0;
        report.verbatim += instancing.looks[static_cast<std::size_t>(instance.look)].verbatim.empty() ? 0 : 1;
    }
    std::map<std::string, std::size_t> look_of_symbol;
    for (std::size_t look = 0; look < instancing.looks.size(); ++look) {
        if (!written.symbol_of_part[look].empty()) look_of_symbol[written.symbol_of_part[look]] = look;
    }
    for (const Terminal& terminal : grammar.terminals) {
        const std::size_t look = look_of_symbol.at(terminal.symbol);
        const SymmetryGroup& symmetry = instancing.looks[look].symmetry;
        const auto rotations = std::ranges::count_if(symmetry.elements, [](const Similarity& s) { return !s.mirrored; });
        report.terminals.push_back(
            {terminal.symbol, instances[look], symmetry.continuous ? 0 : static_cast<int>(rotations), mirrored[look]});
    }

    // Productions: counts over all items that are in use.
    std::map<std::string, ProductionReport> by_symbol;
    std::vector<int> open = ordered.roots;
    std::vector<char> inner(rules.items.size(), 0);
    const auto rule_of_item = [&](int i) {
        return rules.parts[static_cast<std::size_t>(rules.items[static_cast<std::size_t>(i)].part)].rule;
    };
    while (!open.empty()) {
        const int index = open.back();
        const Item& item = rules.items[static_cast<std::size_t>(index)];
        open.pop_back();
        std::ranges::copy_if(item.members, std::back_inserter(open), [](int member) { return member >= 0; });
        const Part& part = rules.parts[static_cast<std::size_t>(item.part)];
        if (part.rule < 0) continue;
        // The trees within a tree are no uses of their own.
        for (const int member : item.members) {
            if (member >= 0) inner[static_cast<std::size_t>(member)] = rule_of_item(member) == part.rule;
        }
        if (inner[static_cast<std::size_t>(index)]) continue;
        const Rule& rule = rules.rules[static_cast<std::size_t>(part.rule)];
        ProductionReport& production = by_symbol[written.symbol_of_part[static_cast<std::size_t>(item.part)]];
        production.kind = kind_name(rule.kind);
        const int length = rule.kind == RuleKind::group ? static_cast<int>(part.children.size()) : part.count;
        if (std::ranges::find(production.lengths, length) == production.lengths.end()) production.lengths.push_back(length);
        ++production.instances;
    }
    for (const Production& production : grammar.productions) {
        ProductionReport entry = by_symbol[production.symbol];
        entry.symbol = production.symbol;
        entry.body = production_text(production);
        std::ranges::sort(entry.lengths);
        report.productions.push_back(std::move(entry));
    }
}

}  // namespace rinceau
