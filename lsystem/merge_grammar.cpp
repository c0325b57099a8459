#include "lsystem/merge_grammar.h"

#include <algorithm>
#include <utility>

#include "lsystem/prefix_names.h"
#include "lsystem/style_text.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

std::set<std::string> parameters_of(const Production& production) {
    std::set<std::string> names(production.parameters.begin(), production.parameters.end());
    for (const auto* context : {&production.left_context, &production.right_context}) {
        for (const ContextModule& module : *context) names.insert(module.parameters.begin(), module.parameters.end());
    }
    return names;
}

const Style* style_of(const Grammar& grammar, int number) {
    const auto found = std::ranges::find(grammar.styles, number, &NumberedStyle::number);
    return found == grammar.styles.end() ? nullptr : &found->style;
}

bool same_look(const Grammar& a, const Terminal& first, const Grammar& b, const Terminal& second) {
    if (first.verbatim != second.verbatim || first.paths != second.paths || first.id != second.id) return false;
    if (!first.verbatim.empty()) return first.verbatim_box == second.verbatim_box;
    const Style* one = style_of(a, first.style);
    const Style* other = style_of(b, second.style);
    return style_text(one != nullptr ? *one : Style{}) == style_text(other != nullptr ? *other : Style{});
}

int highest_style(const Grammar& grammar) {
    int highest = 0;
    for (const NumberedStyle& style : grammar.styles) highest = std::max(highest, style.number);
    return highest;
}

class Merger {
  public:
    Merger(Grammar grammar, const Grammar& donor, const ModuleTemplates& string)
        : result_{.grammar = std::move(grammar)}, donor_(donor), used_(used_names(donor, string)) {
        name_symbols();
        name_constants();
        name_styles();
        result_.string = renamed(string, {});
    }

    MergedGrammar merge() {
        Grammar& grammar = result_.grammar;
        for (const Constant& constant : donor_.constants) {
            if (!used_.constants.contains(constant.name)) continue;
            Constant copy = constant;
            copy.name = constants_.at(constant.name);
            copy.value = renamed(constant.value, {});
            grammar.constants.push_back(std::move(copy));
        }
        for (const Production& production : donor_.productions) {
            if (used_.symbols.contains(production.symbol)) grammar.productions.push_back(renamed(production));
        }
        for (const Terminal& terminal : donor_.terminals) add_terminal(terminal);
        for (const std::string& symbol : donor_.ignored) {
            if (used_.symbols.contains(symbol)) grammar.ignored.push_back(result_.symbols.at(symbol));
        }
        return std::move(result_);
    }

  private:
    MergedGrammar result_;
    const Grammar& donor_;
    UsedNames used_;
    std::map<std::string, std::string> constants_;
    std::map<int, int> styles_;
    std::set<std::string> shared_;

    bool has_productions(const Grammar& grammar, const std::string& symbol) const {
        return std::ranges::count(grammar.productions, symbol, &Production::symbol) > 0;
    }

    bool is_shared(const std::string& symbol) const {
        if (has_productions(result_.grammar, symbol) || has_productions(donor_, symbol)) return false;
        const auto here = std::ranges::find(result_.grammar.terminals, symbol, &Terminal::symbol);
        const auto there = std::ranges::find(donor_.terminals, symbol, &Terminal::symbol);
        return here != result_.grammar.terminals.end() && there != donor_.terminals.end() &&
               same_look(result_.grammar, *here, donor_, *there);
    }

    void name_symbols() {
        const std::vector<std::string> here = symbols_of(result_.grammar);
        std::set<std::string> taken(here.begin(), here.end());
        for (const Use& use : result_.grammar.uses) taken.insert(use.prefix);
        for (const std::string& symbol : symbols_of(donor_)) {
            if (!used_.symbols.contains(symbol) && !stands_in_context(symbol)) continue;
            if (is_shared(symbol)) {
                shared_.insert(symbol);
                result_.symbols[symbol] = symbol;
                continue;
            }
            const std::string name = free_name(symbol, [&](const std::string& wanted) { return taken.contains(wanted); });
            taken.insert(name);
            result_.symbols[symbol] = name;
        }
    }

    bool stands_in_context(const std::string& symbol) const {
        return std::ranges::any_of(donor_.productions, [&](const Production& production) {
            return std::ranges::count(production.left_context, symbol, &ContextModule::symbol) > 0 ||
                   std::ranges::count(production.right_context, symbol, &ContextModule::symbol) > 0;
        });
    }

    /// A constant must not be hidden by a parameter of a production that uses it, here or there.
    void name_constants() {
        std::set<std::string> taken;
        for (const Constant& constant : result_.grammar.constants) taken.insert(constant.name);
        for (const Grammar* grammar : {&std::as_const(result_.grammar), &donor_}) {
            for (const Production& production : grammar->productions) taken.merge(parameters_of(production));
        }
        for (const Constant& constant : donor_.constants) {
            if (!used_.constants.contains(constant.name)) continue;
            const std::string name =
                free_name(constant.name, [&](const std::string& wanted) { return taken.contains(wanted); });
            taken.insert(name);
            constants_[constant.name] = name;
        }
    }

    void name_styles() {
        int largest = highest_style(result_.grammar);
        for (const NumberedStyle& style : donor_.styles) {
            if (!used_.any_style && !used_.styles.contains(style.number)) continue;
            const std::string text = style_text(style.style);
            const auto same = std::ranges::find_if(
                result_.grammar.styles, [&](const NumberedStyle& known) { return style_text(known.style) == text; });
            if (!used_.any_style && same != result_.grammar.styles.end()) {
                styles_[style.number] = same->number;
                continue;
            }
            const int number = used_.any_style ? style.number : ++largest;
            styles_[style.number] = number;
            NumberedStyle copy = style;
            copy.number = number;
            result_.grammar.styles.push_back(std::move(copy));
        }
    }

    std::string name_of(const std::string& symbol) const {
        const auto found = result_.symbols.find(symbol);
        return found == result_.symbols.end() ? symbol : found->second;
    }

    Expression renamed(Expression expression, const std::set<std::string>& parameters) const {
        for (Expression::Node& node : expression.postfix) {
            if (node.op != Expression::Op::name || parameters.contains(node.name)) continue;
            const auto found = constants_.find(node.name);
            if (found != constants_.end()) node.name = found->second;
        }
        return expression;
    }

    ModuleTemplates renamed(ModuleTemplates string, const std::set<std::string>& parameters) const {
        for (ModuleTemplate& module : string) {
            for (Expression& argument : module.arguments) argument = renamed(std::move(argument), parameters);
            if (module.symbol == ";") renumber(module);
            if (find_turtle_command(module.symbol) == nullptr) module.symbol = name_of(module.symbol);
        }
        return string;
    }

    /// A computed number has been raised with the whole donor.
    void renumber(ModuleTemplate& module) const {
        const double* literal = literal_argument(module);
        const auto found = literal != nullptr ? styles_.find(static_cast<int>(*literal)) : styles_.end();
        if (found != styles_.end()) module.arguments.front() = number_expression(found->second);
    }

    Production renamed(Production production) const {
        const std::set<std::string> parameters = parameters_of(production);
        production.symbol = name_of(production.symbol);
        if (production.condition) production.condition = renamed(std::move(*production.condition), parameters);
        if (production.weight) production.weight = renamed(std::move(*production.weight), parameters);
        production.successor = renamed(std::move(production.successor), parameters);
        for (auto* context : {&production.left_context, &production.right_context}) {
            for (ContextModule& module : *context) module.symbol = name_of(module.symbol);
        }
        return production;
    }

    void add_terminal(const Terminal& terminal) {
        if (!used_.symbols.contains(terminal.symbol) || shared_.contains(terminal.symbol)) return;
        Terminal copy = terminal;
        copy.symbol = name_of(terminal.symbol);
        const auto style = styles_.find(terminal.style);
        if (style != styles_.end()) copy.style = style->second;
        result_.grammar.terminals.push_back(std::move(copy));
    }
};

}  // namespace

MergedGrammar merge_grammar(Grammar grammar, const Grammar& donor, const ModuleTemplates& string) {
    if (!used_names(donor, string).any_style) return Merger(std::move(grammar), donor, string).merge();
    // where a style's number is computed, all keep their distances; the string goes with them as an axiom
    Grammar raised = donor;
    raised.axiom = string;
    raised = with_styles_raised(std::move(raised), highest_style(grammar));
    return Merger(std::move(grammar), raised, raised.axiom).merge();
}

}  // namespace rinceau
