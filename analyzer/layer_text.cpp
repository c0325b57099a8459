#include "analyzer/layer_text.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "lsystem/turtle_commands.h"

namespace rinceau {
namespace {

constexpr std::string_view layer_symbol = "z";

ModuleTemplate layer_command(int by) { return {.symbol = std::string(layer_symbol), .arguments = {number_expression(by)}}; }

/// The number of a z command whose argument is plain.
std::optional<int> plain_layer(const ModuleTemplate& module) {
    if (module.symbol != layer_symbol || module.arguments.size() != 1) return std::nullopt;
    const auto& postfix = module.arguments.front().postfix;
    const bool negative = postfix.size() == 2 && postfix[1].op == Expression::Op::negate;
    if (!(postfix.size() == 1 || negative) || postfix[0].op != Expression::Op::number) return std::nullopt;
    const int value = static_cast<int>(postfix[0].number);
    return negative ? -value : value;
}

/// Is anything drawn behind the module in the scope of a z before it? In the axiom, the end of the string is the end of all.
bool layer_must_end(const std::vector<ModuleTemplate>& string, std::size_t position, bool axiom) {
    for (std::size_t i = position + 1; i < string.size(); ++i) {
        if (string[i].symbol == "]") return false;
        if (string[i].symbol == "[" || find_turtle_command(string[i].symbol) == nullptr) return true;
    }
    return !axiom;
}

/// Appends the module, raised.
void append_raised(std::vector<ModuleTemplate>& string, const ModuleTemplate& module, int by, bool must_end) {
    const std::optional<int> before = string.empty() || must_end ? std::nullopt : plain_layer(string.back());
    if (before) string.pop_back();
    if (by + before.value_or(0) != 0) string.push_back(layer_command(by + before.value_or(0)));
    string.push_back(module);
    if (must_end) string.push_back(layer_command(-by));
}

/// `layers` of one string, sorted by position.
std::vector<ModuleTemplate> raised(const std::vector<ModuleTemplate>& string, std::span<const SiteLayer> layers) {
    std::vector<ModuleTemplate> result;
    auto next = layers.begin();
    for (std::size_t i = 0; i < string.size(); ++i) {
        if (next == layers.end() || next->site.position != static_cast<int>(i)) {
            result.push_back(string[i]);
            continue;
        }
        if (!next->expression.postfix.empty())
            result.push_back({.symbol = std::string(layer_symbol), .arguments = {next->expression}});
        append_raised(result, string[i], next->by, layer_must_end(string, i, next->site.string == -1));
        ++next;
    }
    return result;
}

std::vector<ModuleTemplate>& mutable_string(Grammar& grammar, int string) {
    if (string >= 0) return grammar.productions[static_cast<std::size_t>(string)].successor;
    if (string == -1) return grammar.axiom;
    return grammar.exceptions[static_cast<std::size_t>(exception_string - string)].successor;
}

}  // namespace

Grammar with_layers(const Grammar& grammar, const std::vector<SiteLayer>& sites,
                    const std::vector<AddressLayer>& exceptions) {
    Grammar layered = grammar;
    std::vector<SiteLayer> ordered = sites;
    std::sort(ordered.begin(), ordered.end(), [](const SiteLayer& a, const SiteLayer& b) {
        return a.site.string != b.site.string ? a.site.string < b.site.string : a.site.position < b.site.position;
    });
    for (auto first = ordered.begin(); first != ordered.end();) {
        const auto end =
            std::find_if(first, ordered.end(), [&](const SiteLayer& s) { return s.site.string != first->site.string; });
        mutable_string(layered, first->site.string) = raised(string_at(grammar, first->site), {first, end});
        first = end;
    }
    for (const AddressLayer& layer : exceptions) {
        const std::vector<ModuleTemplate>& string = string_at(grammar, layer.site);
        const auto position = static_cast<std::size_t>(layer.site.position);
        Exception exception{.address = layer.address};
        append_raised(exception.successor, string[position], layer.by,
                      layer_must_end(string, position, layer.site.string == -1));
        layered.exceptions.push_back(std::move(exception));
    }
    return layered;
}

}  // namespace rinceau
