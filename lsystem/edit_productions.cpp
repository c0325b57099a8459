#include "lsystem/edit_productions.h"

#include <algorithm>
#include <cmath>

#include "geometry/index.h"
#include "lsystem/fit_box.h"
#include "lsystem/grammar_names.h"
#include "lsystem/grammar_text.h"
#include "lsystem/measure_symbol.h"
#include "lsystem/similar_name.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

ModuleTemplate module(const std::string& symbol) { return {symbol, {}, {}}; }
ModuleTemplate module(const std::string& symbol, double argument) { return {symbol, {number_expression(argument)}, {}}; }

void append(ModuleTemplates& string, const ModuleTemplates& more) { string.insert(string.end(), more.begin(), more.end()); }

void expect_production(const Grammar& grammar, int production) {
    if (production >= 0 && at(production) < grammar.productions.size()) return;
    throw InputError({}, "expected the number of a production from 0 to " +
                             std::to_string(static_cast<int>(grammar.productions.size()) - 1) + ", found " +
                             std::to_string(production));
}

bool has_drawing(const Grammar& grammar, const std::string& symbol) {
    return std::ranges::count(grammar.terminals, symbol, &Terminal::symbol) > 0;
}

/// A use of the symbol: with the arguments with which it is first written, if these are numbers.
ModuleTemplates use_of(const Grammar& grammar, const std::string& symbol) {
    constexpr double some = 3;  // repetitions
    const auto is_number = [](const Expression& argument) {
        return argument.postfix.size() == 1 && argument.postfix.front().op == Expression::Op::number;
    };
    std::vector<const ModuleTemplates*> strings{&grammar.axiom};
    for (const Production& production : grammar.productions) strings.push_back(&production.successor);
    for (const ModuleTemplates* string : strings) {
        for (const ModuleTemplate& written : *string) {
            if (written.symbol == symbol && std::ranges::all_of(written.arguments, is_number)) return {written};
        }
    }
    ModuleTemplate use = module(symbol);
    const auto production = std::ranges::find(grammar.productions, symbol, &Production::symbol);
    if (production != grammar.productions.end())
        use.arguments.assign(production->parameters.size(), number_expression(some));
    return {use};
}

/// Writes the new production and its use.
class ProductionMaker {
  public:
    ProductionMaker(const Grammar& grammar, const AddProductionOptions& options) : grammar_(grammar) {
        for (const std::string& symbol : elements_of(options)) elements_.push_back(use_of(grammar, symbol));
        for (const ModuleTemplates& element : elements_) append(all_, bracketed(element));
        box_ = measure(grammar, all_).box;
        production_.symbol = name_for(options);
        use_ = module(production_.symbol);
        write(options.shape);
    }

    Production production() const { return production_; }

    /// In the middle of the picture, behind what the axiom does.
    ModuleTemplates use() const {
        const Box& canvas = grammar_.canvas;
        const Point middle = is_empty(canvas) ? Point{} : 0.5 * (canvas.low + canvas.high);
        const Point own = is_empty(extent_) ? Point{} : 0.5 * (extent_.low + extent_.high);
        const Similarity move = inverse(measure(grammar_, grammar_.axiom).move) * translate(middle - own);
        ModuleTemplates string = turtle_modules(move, std::max(width(canvas), height(canvas)), use_digits);
        string.push_back(use_);
        return bracketed(string);
    }

  private:
    static constexpr int use_digits = 4;
    static constexpr double room = 1.1;      ///< of an element's size, for each in a row
    static constexpr double some_size = 10;  ///< of what draws nothing
    const Grammar& grammar_;
    std::vector<ModuleTemplates> elements_;
    ModuleTemplates all_;  ///< on top of each other
    Box box_;              ///< of them
    Production production_;
    ModuleTemplate use_;
    Box extent_;  ///< of what the use draws, roughly

    static ModuleTemplates bracketed(const ModuleTemplates& string) {
        ModuleTemplates result{module("[")};
        append(result, string);
        result.push_back(module("]"));
        return result;
    }

    std::vector<std::string> elements_of(const AddProductionOptions& options) const {
        const std::vector<std::string> known = symbols_of(grammar_);
        for (const std::string& element : options.elements) {
            if (std::ranges::count(known, element) == 0)
                throw InputError({},
                                 "expected a symbol of the grammar, found '" + element + "'" + instead_of(element, known));
        }
        if (!options.elements.empty() || options.shape == ProductionShape::empty) return options.elements;
        if (grammar_.terminals.empty())
            throw InputError({}, "expected a symbol that is drawn, found none: open a drawing or write a terminal first");
        return {grammar_.terminals.front().symbol};
    }

    std::string name_for(const AddProductionOptions& options) const {
        constexpr const char* names[] = {"Part", "Row", "Ring", "Tree", "Group"};
        const std::string wanted = options.symbol.empty() ? names[static_cast<int>(options.shape)] : options.symbol;
        if (!may_name_symbol(wanted))
            throw InputError({},
                             "expected a name for the new symbol: a letter, then letters, digits and '_', and no command; "
                             "found '" +
                                 wanted + "'");
        const std::vector<std::string> known = symbols_of(grammar_);
        return free_name(wanted, [&](const std::string& name) {
            return std::ranges::count(known, name) > 0 || std::ranges::count(grammar_.constants, name, &Constant::name) > 0;
        });
    }

    double across() const { return is_empty(box_) || width(box_) <= 0 ? some_size : width(box_); }
    double along() const { return is_empty(box_) || height(box_) <= 0 ? some_size : height(box_); }

    static double short_number(double value) {
        constexpr int digits = 3;
        return rounded_factor(value, digits);
    }

    void write(ProductionShape shape) {
        if (shape == ProductionShape::sequence) write_sequence();
        if (shape == ProductionShape::ring) write_ring();
        if (shape == ProductionShape::branching) write_tree();
        if (shape == ProductionShape::group) production_.successor = all_;
        if (shape == ProductionShape::group) extent_ = box_;
    }

    /// P(m) : m > 0 -> ..; the module that goes on.
    ModuleTemplate counted(double count) {
        production_.parameters = {"m"};
        production_.condition = parse_expression("m > 0");
        use_.arguments = {number_expression(count)};
        return {production_.symbol, {parse_expression("m-1")}, {}};
    }

    void write_sequence() {
        constexpr double count = 5;
        constexpr double quarter = 90;
        const ModuleTemplate next = counted(count);
        const double step = short_number(room * across());
        production_.successor = all_;
        append(production_.successor, {module("-", quarter), module("f", step), module("+", quarter), next});
        extent_ = including(box_, Box{box_.low + Point{(count - 1) * step, 0}, box_.high + Point{(count - 1) * step, 0}});
    }

    void write_ring() {
        constexpr double count = 6;
        constexpr double turn = 360 / count;
        const ModuleTemplate next = counted(count);
        const double radius = short_number(room * std::max(across(), along()));  // six sides are as long as the radius
        production_.successor = {module("["), module("f", radius)};
        append(production_.successor, all_);
        append(production_.successor, {module("]"), module("+", turn), next});
        extent_ = Box{{-radius, -radius}, {radius, radius}};
    }

    void write_tree() {
        constexpr double levels = 4;
        constexpr double turn = 25;
        constexpr double scale = 0.75;
        const ModuleTemplate next = counted(levels);
        const double reach = is_empty(box_) || box_.high.y <= 0 ? along() : box_.high.y;
        production_.successor = all_;
        production_.successor.push_back(module("f", short_number(reach)));
        for (const char* side : {"+", "-"})
            append(production_.successor, bracketed({module(side, turn), module("*", scale), next}));
        extent_ = Box{{-reach, 0}, {reach, reach / (1 - scale)}};
    }
};

/// Where the symbol is used but in its own productions.
std::vector<std::string> users_of(const Grammar& grammar, const std::string& symbol) {
    std::vector<std::string> users;
    const auto uses = [&](const ModuleTemplates& string) {
        return std::ranges::count(string, symbol, &ModuleTemplate::symbol) > 0;
    };
    if (uses(grammar.axiom)) users.push_back("the axiom");
    for (const Production& production : grammar.productions) {
        const bool context = std::ranges::count(production.left_context, symbol, &ContextModule::symbol) > 0 ||
                             std::ranges::count(production.right_context, symbol, &ContextModule::symbol) > 0;
        if (production.symbol == symbol || (!context && !uses(production.successor))) continue;
        if (std::ranges::count(users, production.symbol) == 0) users.push_back(production.symbol);
    }
    const bool excepted =
        std::ranges::any_of(grammar.exceptions, [&](const Exception& exception) { return uses(exception.successor); });
    if (excepted) users.push_back("exceptions");
    return users;
}

std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t most_named = 5;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), most_named); ++i) text += (i > 0 ? ", " : "") + names[i];
    return names.size() > most_named ? text + ", .." : text;
}

bool same_key(const Production& a, const Production& b) {
    return a.symbol == b.symbol && a.parameters.size() == b.parameters.size();
}

}  // namespace

EditResult add_production(const Grammar& grammar, const AddProductionOptions& options) {
    const ProductionMaker maker(grammar, options);
    const Production production = maker.production();
    EditResult result{grammar, {"new: " + statement_text(production)}};
    auto& productions = result.grammar.productions;
    const bool behind = options.before < 0 || at(options.before) >= productions.size();
    productions.insert(behind ? productions.end() : productions.begin() + options.before, production);
    if (options.in_axiom) append(result.grammar.axiom, maker.use());
    return result;
}

std::string reason_to_keep(const Grammar& grammar, int index) {
    expect_production(grammar, index);
    const Production& production = grammar.productions[at(index)];
    const auto alike =
        std::ranges::count_if(grammar.productions, [&](const Production& other) { return same_key(other, production); });
    if (alike > 1 || has_drawing(grammar, production.symbol)) return {};
    const std::vector<std::string> users = users_of(grammar, production.symbol);
    if (users.empty()) return {};
    return production.symbol + " is used in " + listed(users) + ", and nothing else says what it is";
}

EditResult remove_production(const Grammar& grammar, int index, bool uses, const ReplaceOptions& options) {
    const std::string reason = reason_to_keep(grammar, index);
    const Production& production = grammar.productions[at(index)];
    if (!reason.empty() && !uses)
        throw InputError(production.place,
                         "expected a production that can be removed: " + reason + "; remove its uses, too");
    if (!reason.empty()) return replace_symbols(grammar, {{.symbol = production.symbol, .with = OwnModules{}}}, options);
    const UsedNames before = used_names(grammar);
    EditResult result{grammar, {"removed: " + statement_text(production)}};
    result.grammar.productions.erase(result.grammar.productions.begin() + index);
    WithoutLeftovers rest = without_leftovers(std::move(result.grammar), before);
    if (!rest.removed.empty()) result.changes.push_back("no longer used and removed: " + listed(rest.removed));
    result.grammar = std::move(rest.grammar);
    return result;
}

EditResult move_production(const Grammar& grammar, int production, int to) {
    expect_production(grammar, production);
    expect_production(grammar, to);
    EditResult result{grammar, {}};
    auto& productions = result.grammar.productions;
    const Production moved = productions[at(production)];
    productions.erase(productions.begin() + production);
    productions.insert(productions.begin() + to, moved);
    if (to == production) return result;
    result.changes.push_back(moved.symbol + " moved " + (to < production ? "up" : "down"));
    const auto begin = grammar.productions.begin() + std::min(production, to);
    const auto end = grammar.productions.begin() + std::max(production, to) + 1;
    const auto cases = std::count_if(begin, end, [&](const Production& other) { return same_key(other, moved); });
    if (cases > 1) result.changes.push_back("the productions of " + moved.symbol + " are tried in another order now");
    return result;
}

EditResult comment_production(const Grammar& grammar, int production, const std::string& comment) {
    expect_production(grammar, production);
    EditResult result{grammar, {}};
    result.grammar.productions[at(production)].comment = comment;
    return result;
}

EditResult rename_symbol(const Grammar& grammar, const std::string& from, const std::string& to) {
    const std::vector<std::string> known = symbols_of(grammar);
    if (std::ranges::count(known, from) == 0)
        throw InputError({}, "expected a symbol of the grammar, found '" + from + "'" + instead_of(from, known));
    const bool own = has_drawing(grammar, from) || std::ranges::count(grammar.productions, from, &Production::symbol) > 0;
    if (!own && !grammar.uses.empty())
        throw InputError({},
                         "expected a symbol of this grammar, found '" + from + "', which comes from a file that it uses");
    if (from == to) return {grammar, {}};
    if (!may_name_symbol(to))
        throw InputError({}, "expected a name for " + from +
                                 ": a letter, then letters, digits and '_', and no command or "
                                 "word of the language; found '" +
                                 to + "'");
    if (std::ranges::count(known, to) > 0)
        throw InputError({}, "expected a name for " + from + " that is free, found '" + to + "', which is another symbol");
    EditResult result{grammar, {from + " is called " + to + " now"}};
    const auto rename = [&](std::string& symbol) {
        if (symbol == from) symbol = to;
    };
    const auto rename_all = [&](auto& modules) {
        for (auto& module : modules) rename(module.symbol);
    };
    rename_all(result.grammar.axiom);
    for (Production& production : result.grammar.productions) {
        rename(production.symbol);
        rename_all(production.left_context);
        rename_all(production.right_context);
        rename_all(production.successor);
    }
    for (Exception& exception : result.grammar.exceptions) rename_all(exception.successor);
    rename_all(result.grammar.terminals);
    for (std::string& symbol : result.grammar.ignored) rename(symbol);
    return result;
}

}  // namespace rinceau
