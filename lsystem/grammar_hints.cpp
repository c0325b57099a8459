#include "lsystem/grammar_hints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "lsystem/expression_functions.h"
#include "lsystem/production_order.h"

namespace rinceau {

namespace {

class HintFinder {
  public:
    HintFinder(const Grammar& grammar, const std::string& file_name) : grammar_(grammar), file_name_(file_name) {
        for (const Production& production : grammar.productions) productions_[production.symbol].push_back(&production);
        for (const Constant& constant : grammar.constants) constants_.insert(constant.name);
        come_to(grammar.axiom);
        for (const Exception& exception : grammar.exceptions) come_to(exception.successor);
        while (!waiting_.empty()) {
            const std::string_view symbol = waiting_.back();
            waiting_.pop_back();
            for (const Production* production : productions_[symbol]) come_to(production->successor);
        }
    }

    std::vector<Warning> hints() {
        hint_of_symbols();
        hint_of_constants();
        hint_of_styles();
        hint_of_parameters();
        hint_of_ignored();
        std::ranges::stable_sort(hints_, [](const Warning& a, const Warning& b) {
            return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
        });
        return std::move(hints_);
    }

  private:
    const Grammar& grammar_;
    const std::string& file_name_;
    std::map<std::string_view, std::vector<const Production*>> productions_;
    std::set<std::string_view> constants_;
    std::set<std::string_view> reached_;
    std::vector<std::string_view> waiting_;
    std::set<int> styles_;    // that strings and terminals name
    bool any_style_ = false;  // an expression may name each
    std::vector<Warning> hints_;

    void hint(const SourcePlace& place, const std::string& message) {
        if (place.file == file_name_) hints_.push_back({place, message});
    }

    void come_to(const std::vector<ModuleTemplate>& string) {
        for (const ModuleTemplate& module : string) {
            if (module.symbol == ";") see_style(module);
            if (reached_.insert(module.symbol).second) waiting_.push_back(module.symbol);
        }
    }

    void see_style(const ModuleTemplate& module) {
        for (const Expression& argument : module.arguments) {
            const bool number = argument.postfix.size() == 1 && argument.postfix.front().op == Expression::Op::number;
            if (number && std::abs(argument.postfix.front().number) < 1e9) {  // fits an int
                styles_.insert(static_cast<int>(argument.postfix.front().number));
            } else {
                any_style_ = true;
            }
        }
    }

    void hint_of_symbols() {
        for (const Production& production : grammar_.productions) {
            if (reached_.contains(production.symbol)) continue;
            hint(production.place, "nothing that the axiom leads to has the symbol " + production.symbol +
                                       ": the production is never applied");
        }
        for (const Terminal& terminal : grammar_.terminals) {
            if (reached_.contains(terminal.symbol)) continue;
            hint(terminal.place,
                 "nothing that the axiom leads to has the symbol " + terminal.symbol + ": the terminal is never drawn");
        }
    }

    void hint_of_constants() {
        std::set<std::string_view> named;
        const auto see = [&](const Expression& expression) {
            for (const Expression::Node& node : expression.postfix) {
                if (node.op == Expression::Op::name) named.insert(node.name);
            }
        };
        const auto see_all = [&](const std::vector<ModuleTemplate>& string) {
            for (const ModuleTemplate& module : string) std::ranges::for_each(module.arguments, see);
        };
        see_all(grammar_.axiom);
        for (const Constant& constant : grammar_.constants) see(constant.value);
        for (const Exception& exception : grammar_.exceptions) see_all(exception.successor);
        for (const Production& production : grammar_.productions) {
            see_all(production.successor);
            if (production.condition) see(*production.condition);
            if (production.weight) see(*production.weight);
        }
        for (const Constant& constant : grammar_.constants) {
            if (!named.contains(constant.name)) hint(constant.place, "no expression uses the constant " + constant.name);
        }
    }

    void hint_of_styles() {
        for (const Terminal& terminal : grammar_.terminals) styles_.insert(terminal.style);
        for (const NumberedStyle& style : grammar_.styles) {
            if (any_style_ || styles_.contains(style.number)) continue;
            hint(style.place, "no terminal and no ;(" + std::to_string(style.number) + ") uses the style " +
                                  std::to_string(style.number));
        }
    }

    void hint_of_parameters() {
        for (const Production& production : grammar_.productions) {
            for (const std::string& name : names_in(production)) {
                if (!constants_.contains(name) && !named_constant(name)) continue;
                hint(production.place, "the parameter " + name + " hides the constant " + name +
                                           " in this production: name one of them otherwise");
            }
        }
    }

    void hint_of_ignored() {
        const bool in_context = std::ranges::any_of(grammar_.productions, [](const Production& production) {
            return !production.left_context.empty() || !production.right_context.empty();
        });
        if (in_context || grammar_.ignored.empty()) return;
        hint({file_name_, 1, 1}, "no production has a context: 'ignore' changes nothing");
    }
};

}  // namespace

std::vector<Warning> grammar_hints(const Grammar& grammar, const std::string& file_name) {
    return HintFinder(grammar, file_name).hints();
}

}  // namespace rinceau
