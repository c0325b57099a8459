#include "lsystem/edit_group.h"

#include <algorithm>
#include <optional>
#include <set>

#include "lsystem/grammar_names.h"
#include "lsystem/moved_exceptions.h"
#include "lsystem/plain_rules.h"
#include "lsystem/production_order.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {
namespace {

ModuleTemplates selected(const Grammar& grammar, const GroupOptions& options) {
    const ModuleTemplates& string = string_at(grammar, options.string);
    const auto refuse = [](const std::string& expected) { throw InputError({}, "expected " + expected); };
    if (options.first < 0 || options.last < options.first || static_cast<std::size_t>(options.last) >= string.size())
        refuse("modules of the string to group, the first not behind the last");
    ModuleTemplates modules(string.begin() + options.first, string.begin() + options.last + 1);
    int depth = 0;
    bool draws = false;
    for (const ModuleTemplate& module : modules) {
        depth += (module.symbol == "[") - (module.symbol == "]");
        if (depth < 0) break;
        draws = draws || find_turtle_command(module.symbol) == nullptr;
    }
    if (depth != 0) refuse("whole pairs of brackets to group");
    if (!draws) refuse("a symbol among the modules to group");
    if (is_context_sensitive(grammar)) refuse("a grammar where neighbours do not count, to group modules");
    if (options.string.in != StringPlace::In::production) return modules;
    const Production& production = grammar.productions[static_cast<std::size_t>(options.string.index)];
    if (production.kind == ProductionKind::homomorphism) refuse("no homomorphism, to group modules");
    if (std::ranges::count(modules, production.symbol, &ModuleTemplate::symbol) > 0)
        refuse("modules to group without " + production.symbol + ", which continues the rule");
    return modules;
}

/// Those of the production's names that the modules use, in its order.
std::vector<std::string> parameters_in(const Grammar& grammar, const StringPlace& place, const ModuleTemplates& modules) {
    if (place.in != StringPlace::In::production) return {};
    std::set<std::string> used;
    for (const ModuleTemplate& module : modules)
        for (const Expression& argument : module.arguments)
            for (const Expression::Node& node : argument.postfix)
                if (node.op == Expression::Op::name) used.insert(node.name);
    std::vector<std::string> parameters;
    for (const std::string& name : names_in(grammar.productions[static_cast<std::size_t>(place.index)]))
        if (used.contains(name) && std::ranges::count(parameters, name) == 0) parameters.push_back(name);
    return parameters;
}

}  // namespace

EditResult group_modules(const Grammar& grammar, const GroupOptions& options) {
    const ModuleTemplates modules = selected(grammar, options);
    const std::vector<std::string> known = symbols_of(grammar);
    const std::string name = free_name(options.name.empty() ? "Group" : options.name,
                                       [&](const std::string& wanted) { return std::ranges::count(known, wanted) > 0; });
    Production rule{.symbol = name, .parameters = parameters_in(grammar, options.string, modules), .successor = modules};
    ModuleTemplate use{name, {}, {}};
    for (const std::string& parameter : rule.parameters) use.arguments.push_back(name_expression(parameter));
    EditResult result{grammar, {}};
    ModuleTemplates& string = string_at(result.grammar, options.string);
    string.erase(string.begin() + options.first, string.begin() + options.last + 1);
    string.insert(string.begin() + options.first, std::move(use));
    const bool in_rule = options.string.in == StringPlace::In::production;
    const auto behind =
        in_rule ? result.grammar.productions.begin() + options.string.index + 1 : result.grammar.productions.begin();
    result.grammar.productions.insert(behind, std::move(rule));
    const std::vector<Exception> moved = moved_exceptions(grammar, result.grammar, name);
    for (std::size_t i = 0; i < moved.size(); ++i) result.grammar.exceptions[i].address = moved[i].address;
    result.changes.push_back(std::to_string(modules.size()) + (modules.size() == 1 ? " module is" : " modules are") +
                             " the rule " + name + " now");
    if (draws_random_numbers(grammar)) result.changes.push_back("what is drawn at random is drawn anew");
    return result;
}

}  // namespace rinceau
