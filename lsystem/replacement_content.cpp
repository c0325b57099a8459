#include "lsystem/replacement_content.h"

#include <algorithm>

#include "lsystem/drawing_terminals.h"
#include "lsystem/measure_symbol.h"
#include "lsystem/merge_grammar.h"
#include "lsystem/similar_name.h"
#include "lsystem/turtle_commands.h"
#include "lsystem/unfolded_exceptions.h"

namespace rinceau {

namespace {

bool is_command(const ModuleTemplate& module) { return find_turtle_command(module.symbol) != nullptr; }

bool is_one_symbol(const ModuleTemplates& string) { return string.size() == 1 && !is_command(string.front()); }

std::set<std::size_t> arities_of(const Grammar& grammar, const std::string& symbol) {
    std::set<std::size_t> arities;
    for (const Production& production : grammar.productions) {
        if (production.symbol == symbol) arities.insert(production.parameters.size());
    }
    return arities;
}

class ContentMaker {
  public:
    ContentMaker(const Grammar& grammar, const ReplaceOptions& options)
        : before_(options.resolve ? options.resolve(grammar) : grammar), options_(options), result_{.grammar = grammar} {
        const std::vector<std::string> symbols = symbols_of(before_);
        taken_.insert(symbols.begin(), symbols.end());
    }

    WithContents make(const std::vector<Replacement>& replacements, const std::vector<Box>& places) {
        for (std::size_t i = 0; i < replacements.size(); ++i) {
            const Replacement& replacement = replacements[i];
            Content content =
                std::visit([&](const auto& with) { return content_of(with, replacement, places[i]); }, replacement.with);
            result_.contents.push_back(std::move(content));
        }
        return std::move(result_);
    }

  private:
    Grammar before_;
    const ReplaceOptions& options_;
    WithContents result_;
    std::set<std::string> taken_;
    std::string nothing_;  // the symbol that is erased, once there is one

    Content content_of(const OwnModules& own, const Replacement& replacement, const Box&) {
        if (own.string.empty()) return nothing();
        Content content = symbol_content(before_, own.string, replacement.label);
        // one symbol takes the place of one, so that addresses and random numbers elsewhere stay
        if (!is_one_symbol(own.string)) content.string = {own_production(replacement.symbol, std::move(content.string))};
        return content;
    }

    Content nothing() {
        Content content{.given_arguments = true};
        if (before_.exceptions.empty() && !draws_random_numbers(before_)) return content;
        if (nothing_.empty()) nothing_ = own_production("Nothing", {}).symbol;
        content.string = {{nothing_, {}, {}}};
        return content;
    }

    Content content_of(const OtherGrammar& other, const Replacement& replacement, const Box&) {
        Content content;
        if (other.string.empty()) {
            content = whole(other);
        } else {
            content = symbol_content(other.grammar, other.string, replacement.label);
            take(merge_grammar(std::move(result_.grammar), other.grammar, content.string), content);
        }
        content.foreign = true;
        return content;
    }

    /// The axiom becomes a production.
    Content whole(const OtherGrammar& other) {
        Content content;
        const Grammar plain = unfolded_exceptions(other.grammar);
        take(merge_grammar(std::move(result_.grammar), plain, plain.axiom), content);
        content.string = {own_production(other.name, std::move(content.string))};
        return content;
    }

    void take(MergedGrammar merged, Content& content) {
        result_.grammar = std::move(merged.grammar);
        content.string = std::move(merged.string);
        for (const auto& [old_name, name] : merged.symbols) taken_.insert(name);
    }

    ModuleTemplate own_production(const std::string& wanted, ModuleTemplates successor) {
        const std::string name = new_name(wanted);
        result_.grammar.productions.push_back({.symbol = name, .successor = std::move(successor)});
        return {name, {}, {}};
    }

    Content content_of(const OtherDrawing& drawing, const Replacement& replacement, const Box& place) {
        if (drawing.elements.empty()) {
            throw InputError(
                {replacement.label},
                "expected a drawing with something in it, found none: nothing can take the place of " + replacement.symbol);
        }
        const Similarity turned = rotate(radians(options_.turn));
        Box box;
        for (const Element& element : drawing.elements) {
            Element copy = element;
            copy.paths = transformed(element.paths, turned);
            box = including(box, visible_box({copy}));
        }
        const Box seat = is_empty(place) ? Box{{0, 0}, {0, 0}} : place;
        const std::string name = new_name(drawing.name, drawing.elements.size());
        const Similarity fit = fitted(box, seat, options_.fit);
        result_.grammar = with_drawing(std::move(result_.grammar), drawing.elements, fit * turned, name);
        for (std::size_t part = 1; part <= drawing.elements.size(); ++part) taken_.insert(part_name(name, part));
        return {.string = {{name, {}, {}}},
                .given_arguments = true,
                .foreign = true,
                .outlines = static_cast<int>(drawing.elements.size()),
                .scale = scale_of(fit)};
    }

    /// Neither it nor the names of its parts are taken.
    std::string new_name(const std::string& wanted, std::size_t parts = 0) {
        std::string name = free_name(wanted, [&](const std::string& candidate) {
            if (taken_.contains(candidate)) return true;
            for (std::size_t part = 1; part <= parts; ++part) {
                if (taken_.contains(part_name(candidate, part))) return true;
            }
            return false;
        });
        taken_.insert(name);
        return name;
    }

    /// A symbol takes the numbers that are written, or those with which it stands in its own grammar.
    Content symbol_content(const Grammar& grammar, const ModuleTemplates& string, const std::string& label) {
        Content content{.string = string, .given_arguments = true};
        if (string.empty()) return content;
        const std::vector<std::string> known = symbols_of(grammar);
        for (const ModuleTemplate& module : string) {
            if (is_command(module) || std::ranges::count(known, module.symbol) > 0) continue;
            throw InputError({}, "expected a symbol of the grammar in '" + label + "', found '" + module.symbol + "'" +
                                     instead_of(module.symbol, known));
        }
        if (!is_one_symbol(string)) return content;
        content.arities = arities_of(grammar, string.front().symbol);
        content.given_arguments = !string.front().arguments.empty();
        if (content.given_arguments || content.arities.empty() || content.arities.contains(0)) return content;
        const std::string& symbol = string.front().symbol;
        const std::vector<SymbolInstance> instances = find_instances(grammar, symbol, {symbol}, options_.derive);
        if (!instances.empty() && instances.front().measured) {
            for (const double value : instances.front().arguments)
                content.string.front().arguments.push_back(number_expression(value));
        }
        return content;
    }
};

}  // namespace

WithContents with_contents(const Grammar& grammar, const std::vector<Replacement>& replacements,
                           const std::vector<Box>& places, const ReplaceOptions& options) {
    return ContentMaker(grammar, options).make(replacements, places);
}

}  // namespace rinceau
