#include "analyzer/tint_text.h"

#include <algorithm>

#include "analyzer/module_writer.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

bool is_command(const ModuleTemplate& module) { return find_turtle_command(module.symbol) != nullptr; }

/// Is anything drawn behind the position that a style set there would reach?
bool style_reaches_on(const std::vector<ModuleTemplate>& string, std::size_t position) {
    for (std::size_t i = position + 1; i < string.size(); ++i) {
        if (string[i].symbol == "]") return false;
        if (string[i].symbol == "[" || !is_command(string[i])) return true;
    }
    return false;
}

bool has_production(const Grammar& grammar, const std::string& symbol) {
    return std::ranges::any_of(grammar.productions, [&](const Production& p) { return p.symbol == symbol; });
}

/// Appends the module with its style chosen.
void append_tinted(std::vector<ModuleTemplate>& string, ModuleTemplate module, const TintArguments& arguments, bool production,
                   bool reaches_on) {
    if (production) {
        module.arguments.insert(module.arguments.end(), arguments.begin(), arguments.end());
        string.push_back(std::move(module));
        return;
    }
    std::vector<ModuleTemplate> tinted;
    tinted.push_back({.symbol = ";", .arguments = arguments});
    tinted.push_back(std::move(module));
    if (reaches_on) tinted = bracketed(std::move(tinted));
    string.insert(string.end(), tinted.begin(), tinted.end());
}

class Editor {
  public:
    Editor(const Grammar& grammar, const TintEdits& edits) : grammar_(grammar), edits_(edits) {}

    /// `self`: symbol whose production this is; empty otherwise.
    std::vector<ModuleTemplate> edited(const std::vector<ModuleTemplate>& string, int number, const std::string& self) const {
        std::vector<ModuleTemplate> result;
        for (std::size_t i = 0; i < string.size(); ++i) {
            const auto edit = edits_.sites.find({number, static_cast<int>(i)});
            if (!self.empty() && string[i].symbol == self) {
                result.push_back(handed_on(string[i]));
            } else if (edit == edits_.sites.end()) {
                result.push_back(string[i]);
            } else {
                append_tinted(result, string[i], edit->second, has_production(grammar_, string[i].symbol),
                              style_reaches_on(string, i));
            }
        }
        return result;
    }

    std::vector<std::string> new_parameters(const std::string& symbol) const {
        const auto found = edits_.parameters.find(symbol);
        return found == edits_.parameters.end() ? std::vector<std::string>{} : found->second;
    }

  private:
    ModuleTemplate handed_on(ModuleTemplate call) const {
        for (const std::string& name : new_parameters(call.symbol)) call.arguments.push_back(name_expression(name));
        return call;
    }

    const Grammar& grammar_;
    const TintEdits& edits_;
};

}  // namespace

Grammar with_tints(const Grammar& grammar, const TintEdits& edits) {
    Grammar result = grammar;
    const Editor editor(grammar, edits);
    result.axiom = editor.edited(grammar.axiom, -1, "");
    for (std::size_t p = 0; p < grammar.productions.size(); ++p) {
        Production& production = result.productions[p];
        production.successor = editor.edited(grammar.productions[p].successor, static_cast<int>(p), production.symbol);
        for (const std::string& name : editor.new_parameters(production.symbol)) production.parameters.push_back(name);
    }
    for (std::size_t e = 0; e < grammar.exceptions.size(); ++e) {
        result.exceptions[e].successor =
            editor.edited(grammar.exceptions[e].successor, exception_string - static_cast<int>(e), "");
    }
    for (const TintException& added : edits.exceptions) {
        Exception exception{.address = added.address};
        const std::vector<ModuleTemplate>& string = string_at(grammar, added.site);
        const auto position = static_cast<std::size_t>(added.site.position);
        append_tinted(exception.successor, string[position], added.arguments,
                      has_production(grammar, string[position].symbol), style_reaches_on(string, position));
        result.exceptions.push_back(std::move(exception));
    }
    return result;
}

}  // namespace rinceau
