// docs/analysis.md, 7.1. From the terminals up: the styles that a production's terminals need become its parameters; what
// its copies ask for becomes a column that the production above has to say, as shortly as it can.

#include "analyzer/colouring.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "analyzer/colour_pattern.h"
#include "analyzer/derivation_tree.h"
#include "analyzer/repetition.h"
#include "analyzer/terminals.h"
#include "analyzer/tint_text.h"
#include "lsystem/interpret.h"

namespace rinceau {

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// ---- which style has which number ----

struct Palette {
    std::vector<NumberedStyle> styles;
    std::vector<std::vector<int>> number;  ///< by look and tint; empty for looks without tints
    std::map<std::string, int> own;        ///< of terminals with tints: their own style
};

/// Styles of looks with tints, in order of derivation; then those of the other terminals.
Palette palette_of(const WrittenGrammar& written, const Instancing& instancing) {
    Palette palette;
    for (const Look& look : instancing.looks) palette.number.emplace_back(look.tints.size(), 0);
    for (const int element : written.element_of_leaf) {
        const Instance& instance = instancing.instances[index(element)];
        const Look& look = instancing.looks[index(instance.look)];
        if (look.tints.empty()) continue;
        int& number = palette.number[index(instance.look)][index(instance.tint)];
        if (number > 0) continue;
        const Style style = terminal_style(look.tints[index(instance.tint)], written.terminal_anchor[index(instance.look)]);
        number = style_number(palette.styles, style);
    }
    for (std::size_t look = 0; look < instancing.looks.size(); ++look) {
        if (palette.number[look].empty() || written.symbol_of_part[look].empty()) continue;
        const Style own = terminal_style(instancing.looks[look].unit_style, written.terminal_anchor[look]);
        palette.own[written.symbol_of_part[look]] = style_number(palette.styles, own);
    }
    return palette;
}

const Style& style_of(const Grammar& grammar, int number) {
    return std::ranges::find(grammar.styles, number, &NumberedStyle::number)->style;
}

void renumber_styles(Grammar& grammar, Palette& palette) {
    for (Terminal& terminal : grammar.terminals) {
        if (terminal.style > 0) terminal.style = style_number(palette.styles, style_of(grammar, terminal.style));
    }
    grammar.styles = palette.styles;
}

// ---- productions as the derivation uses them ----

struct SymbolUse {
    std::vector<int> owners;  ///< nodes of the tree: copies of the production
    std::vector<int> sites;   ///< in its successors
    std::set<std::string> calls;
    std::optional<Repetition> repetition;
    std::vector<TintParameter> parameters;
};

class Colouring {
  public:
    Colouring(const WrittenGrammar& written, const Instancing& instancing, const Palette& palette)
        : grammar_(written.grammar), own_(palette.own), styles_(static_cast<Tint>(palette.styles.size())), leaves_(interpret(written.grammar, {.addresses = true, .trails = true})) {
        std::ranges::sort(leaves_, {}, &Placement::order);
        tree_ = derivation_tree(grammar_, leaves_);
        constexpr double beside_address = 12;  // a line to be looked up, and what stands there
        exception_bits_ = beside_address + std::log2(static_cast<double>(std::max<std::size_t>(2, leaves_.size())));
        arguments_.resize(tree_.nodes.size());
        for (std::size_t leaf = 0; leaf < leaves_.size() && leaf < written.element_of_leaf.size(); ++leaf) {
            const Instance& instance = instancing.instances[index(written.element_of_leaf[leaf])];
            const std::vector<int>& numbers = palette.number[index(instance.look)];
            if (!numbers.empty()) arguments_[index(tree_.node_of_leaf[leaf])] = {numbers[index(instance.tint)]};
        }
        for (const Exception& exception : grammar_.exceptions) taken_.insert(exception.address);
    }

    bool run() {
        collect_uses();
        const std::optional<std::vector<std::string>> order = callees_first();
        if (!order) return false;
        for (const std::string& symbol : *order) colour_production(symbol);
        for (std::size_t site = 0; site < tree_.sites.size(); ++site) {
            if (tree_.sites[site].string < 0) spell_out(static_cast<int>(site));
        }
        return true;
    }

    const TintEdits& edits() const { return edits_; }

  private:
    const DerivedModule& node(int n) const { return tree_.nodes[index(n)]; }
    const ModuleSite& site(int s) const { return tree_.sites[index(s)]; }
    const ModuleTemplate& module_at(int s) const { return string_at(grammar_, site(s))[index(site(s).position)]; }

    void collect_uses() {
        for (const Production& production : grammar_.productions) symbols_[production.symbol];
        nodes_of_site_.resize(tree_.sites.size());
        for (std::size_t n = 1; n < tree_.nodes.size(); ++n) {
            const DerivedModule& at = tree_.nodes[n];
            nodes_of_site_[index(at.site)].push_back(static_cast<int>(n));
            if (site(at.site).string <= exception_string) replaced_.insert(at.parent);
            const auto use = symbols_.find(module_at(at.site).symbol);
            if (use != symbols_.end()) use->second.owners.push_back(static_cast<int>(n));
        }
        for (std::size_t s = 0; s < tree_.sites.size(); ++s) {
            if (tree_.sites[s].string < 0) continue;
            SymbolUse& use = symbols_[grammar_.productions[index(tree_.sites[s].string)].symbol];
            use.sites.push_back(static_cast<int>(s));
            use.calls.insert(module_at(static_cast<int>(s)).symbol);
        }
        for (auto& [symbol, use] : symbols_) use.repetition = repetition_of(grammar_, symbol);
    }

    std::optional<std::vector<std::string>> callees_first() const {
        std::vector<std::string> order;
        std::set<std::string> done;
        while (order.size() < symbols_.size()) {
            const std::size_t before = order.size();
            for (const auto& [symbol, use] : symbols_) {
                const bool ready = std::ranges::all_of(use.calls, [&, own = symbol](const std::string& call) {
                    return call == own || done.contains(call) || !symbols_.contains(call);
                });
                if (ready && done.insert(symbol).second) order.push_back(symbol);
            }
            if (order.size() == before) return std::nullopt;
        }
        return order;
    }

    struct Column {
        int site = 0;
        std::size_t argument = 0;
        TintColumn uses;
        std::vector<int> nodes;  ///< by use
        std::size_t tints = 0;   ///< how many different ones
    };

    /// The counter's value at the call, if it can be told; else as many repetitions as are there.
    int repetitions(int owner, const Repetition& repetition, int seen) const {
        const ModuleTemplate& call = module_at(node(owner).site);
        if (call.arguments.empty() || call.arguments.front().postfix.size() != 1) return seen;
        Expression::Node value = call.arguments.front().postfix.front();
        for (const Constant& constant : grammar_.constants) {
            if (value.op == Expression::Op::name && constant.name == value.name && constant.value.postfix.size() == 1)
                value = constant.value.postfix.front();
        }
        if (value.op != Expression::Op::number || value.name == repetition.counter) return seen;
        return static_cast<int>(std::lround(value.number));
    }

    std::vector<int> counts_of_owners(const SymbolUse& use, const std::map<int, int>& owner_index) const {
        std::vector<int> counts(use.owners.size(), 0);
        if (!use.repetition) return counts;
        for (const int s : use.sites) {
            for (const int n : nodes_of_site_[index(s)]) {
                int& count = counts[index(owner_index.at(node(n).parent))];
                count = std::max(count, turn_of(tree_, leaves_, n, *use.repetition) + 1);
            }
        }
        for (std::size_t k = 0; k < counts.size(); ++k)
            counts[k] = repetitions(use.owners[k], *use.repetition, counts[k]);
        return counts;
    }

    std::vector<Column> columns_of(const SymbolUse& use) const {
        std::map<int, int> owner_index;
        for (std::size_t k = 0; k < use.owners.size(); ++k) owner_index[use.owners[k]] = static_cast<int>(k);
        const std::vector<int> counts = counts_of_owners(use, owner_index);
        std::vector<Column> columns;
        for (const int s : use.sites) {
            std::size_t arguments = 0;
            for (const int n : nodes_of_site_[index(s)]) arguments = std::max(arguments, arguments_[index(n)].size());
            for (std::size_t argument = 0; argument < arguments; ++argument) {
                Column column{.site = s, .argument = argument};
                column.uses.owners = static_cast<int>(use.owners.size());
                if (use.repetition) column.uses.counter = use.repetition->counter;
                column.uses.counts = counts;
                if (!symbols_.contains(module_at(s).symbol)) column.uses.styles = styles_;
                std::set<Tint> tints;
                for (const int n : nodes_of_site_[index(s)]) {
                    if (replaced_.contains(n) || arguments_[index(n)].empty()) continue;
                    const int owner = owner_index.at(node(n).parent);
                    const int turn = use.repetition ? turn_of(tree_, leaves_, n, *use.repetition) : 0;
                    const int m = use.repetition ? counts[index(owner)] - turn : 0;
                    column.uses.uses.push_back({owner, m, arguments_[index(n)][argument]});
                    column.nodes.push_back(n);
                    tints.insert(arguments_[index(n)][argument]);
                }
                column.tints = tints.size();
                columns.push_back(std::move(column));
            }
        }
        return columns;
    }

    std::string free_name(const std::string& symbol, const SymbolUse& use) const {
        std::set<std::string> names;
        for (const Constant& constant : grammar_.constants) names.insert(constant.name);
        for (const Production& production : grammar_.productions) {
            if (production.symbol == symbol) names.insert(production.parameters.begin(), production.parameters.end());
        }
        for (const TintParameter& parameter : use.parameters) names.insert(parameter.name);
        for (int round = 0;; ++round) {
            for (const char letter : std::string("cdghknstuvw")) {
                std::string name(1, letter);
                if (round > 0) name += std::to_string(round);
                if (!names.contains(name)) return name;
            }
        }
    }

    void colour_production(const std::string& symbol) {
        SymbolUse& use = symbols_.at(symbol);
        std::vector<Column> columns = columns_of(use);
        // What takes most values first: the others may follow from it.
        std::vector<std::size_t> order(columns.size());
        for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
        std::ranges::stable_sort(order, {}, [&](std::size_t k) { return -static_cast<long>(columns[k].tints); });
        for (const std::size_t k : order) {
            const Column& column = columns[k];
            const std::string name = free_name(symbol, use);
            TintPattern pattern = shortest_pattern(column.uses, use.parameters, name, exception_bits_);
            for (const int departure : pattern.departures) depart(column.nodes[index(departure)]);
            if (!pattern.parameter.empty()) {
                use.parameters.push_back({name, std::move(pattern.parameter)});
                edits_.parameters[symbol].push_back(name);
            }
            write(column, std::move(pattern.expression));
        }
        for (std::size_t k = 0; k < use.owners.size(); ++k) {
            for (const TintParameter& parameter : use.parameters)
                arguments_[index(use.owners[k])].push_back(parameter.values[k]);
        }
    }

    /// A terminal draws in its own style unless it is told another one.
    bool is_own(int s, const Expression& expression) const {
        const auto own = own_.find(module_at(s).symbol);
        return own != own_.end() && expression == number_expression(own->second);
    }

    void write(const Column& column, Expression expression) {
        if (is_own(column.site, expression)) return;
        const ModuleSite& at = site(column.site);
        TintArguments& arguments = edits_.sites[{at.string, at.position}];
        arguments.resize(std::max(arguments.size(), column.argument + 1), number_expression(0));
        arguments[column.argument] = std::move(expression);
    }

    /// In the axiom, and in exceptions, everything stands once.
    void spell_out(int s) {
        for (const int n : nodes_of_site_[index(s)]) {
            TintArguments arguments = literals(arguments_[index(n)]);
            if (arguments.empty() || is_own(s, arguments.front())) continue;
            edits_.sites[{site(s).string, site(s).position}] = std::move(arguments);
        }
    }

    static TintArguments literals(const std::vector<Tint>& values) {
        TintArguments arguments;
        for (const Tint value : values) arguments.push_back(number_expression(static_cast<double>(value)));
        return arguments;
    }

    bool uses_constants_only(int s) const {
        if (site(s).string < 0) return true;
        const std::vector<std::string>& parameters = grammar_.productions[index(site(s).string)].parameters;
        for (const Expression& argument : module_at(s).arguments) {
            for (const Expression::Node& part : argument.postfix) {
                if (part.op == Expression::Op::name && std::ranges::find(parameters, part.name) != parameters.end()) return false;
            }
        }
        return true;
    }

    /// The module is not what the rule says: an exception, if there is room for one. (Else its leaves get theirs.)
    void depart(int n) {
        const DerivedModule& at = node(n);
        const std::vector<int>& leaf_address = leaves_[index(at.leaf)].address;
        std::vector<int> address(leaf_address.begin(), leaf_address.begin() + at.address_length);
        if (!uses_constants_only(at.site) || !taken_.insert(address).second) return;
        edits_.exceptions.push_back({std::move(address), site(at.site), literals(arguments_[index(n)])});
    }

    const Grammar& grammar_;
    const std::map<std::string, int>& own_;  ///< styles of terminals
    Tint styles_;                            ///< how many there are to choose from
    std::vector<Placement> leaves_;          ///< in order of derivation
    DerivationTree tree_;
    double exception_bits_ = 0;
    std::vector<std::vector<Tint>> arguments_;  ///< what each node asks for
    std::map<std::string, SymbolUse> symbols_;
    std::vector<std::vector<int>> nodes_of_site_;
    std::set<int> replaced_;
    std::set<std::vector<int>> taken_;
    TintEdits edits_;
};

/// Leaves whose style is still another get exceptions.
void mend_leaves(Grammar& grammar, const std::vector<int>& wanted, const std::map<std::string, int>& own) {
    std::map<std::vector<int>, std::size_t> exception_at;
    for (std::size_t e = 0; e < grammar.exceptions.size(); ++e) exception_at[grammar.exceptions[e].address] = e;
    for (const Placement& leaf : interpret(grammar, {.addresses = true})) {
        const int number = wanted[index(leaf.order)];
        if (number == 0) continue;
        const std::string& symbol = grammar.terminals[index(leaf.terminal)].symbol;
        if ((leaf.style == 0 ? own.at(symbol) : leaf.style) == number) continue;
        const ModuleTemplate choice{.symbol = ";", .arguments = {number_expression(number)}};
        const auto known = exception_at.find(leaf.address);
        if (known == exception_at.end()) {
            grammar.exceptions.push_back(
                {.address = leaf.address, .successor = {choice, {.symbol = symbol, .arguments = {}}}});
            continue;
        }
        std::vector<ModuleTemplate>& successor = grammar.exceptions[known->second].successor;
        const auto drawn = std::ranges::find(successor, symbol, &ModuleTemplate::symbol);
        successor.insert(drawn, choice);
    }
}

}  // namespace

std::optional<WrittenGrammar> with_colours(WrittenGrammar written, const Instancing& instancing) {
    const auto has_tints = [](const Look& look) { return !look.tints.empty(); };
    if (std::ranges::none_of(instancing.looks, has_tints)) return written;
    Palette palette = palette_of(written, instancing);
    Colouring colouring(written, instancing, palette);
    if (!colouring.run()) return std::nullopt;
    Grammar grammar = with_tints(written.grammar, colouring.edits());
    renumber_styles(grammar, palette);
    std::vector<int> wanted;
    for (const int element : written.element_of_leaf) {
        const Instance& instance = instancing.instances[index(element)];
        const std::vector<int>& numbers = palette.number[index(instance.look)];
        wanted.push_back(numbers.empty() ? 0 : numbers[index(instance.tint)]);
    }
    mend_leaves(grammar, wanted, palette.own);
    for (const auto& [symbol, names] : colouring.edits().parameters)
        written.tint_arguments[symbol] = static_cast<int>(names.size());
    written.grammar = std::move(grammar);
    return written;
}

}  // namespace rinceau
