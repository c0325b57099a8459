#include "cli/replacement_text.h"

#include <algorithm>
#include <filesystem>

#include <CLI/Error.hpp>

#include "files/files.h"
#include "cli/messages.h"
#include "lsystem/grammar_text.h"
#include "scene/svg_read.h"

namespace rinceau {
namespace {

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

bool ends_with(const std::string& text, const std::string& ending) { return lower(text).ends_with(ending); }

/// "my leaf.svg" -> "My_leaf".
std::string symbol_for(const std::string& file) {
    std::string name;
    for (const char c : std::filesystem::path(file).stem().string()) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        name += plain ? c : '_';
    }
    if (!name.empty() && name.front() >= 'a' && name.front() <= 'z')
        name.front() = static_cast<char>(name.front() - 'a' + 'A');
    const bool starts_with_letter = !name.empty() && name.front() >= 'A' && name.front() <= 'Z';
    return starts_with_letter ? name : "Drawing" + name;
}

/// A string of modules, as it stands behind "axiom:".
ModuleTemplates parse_modules(const std::string& text, const std::string& what) {
    try {
        ModuleTemplates string = parse_grammar("lsystem 1\naxiom: " + text).axiom;
        for (ModuleTemplate& module : string) module.place = {};
        return string;
    } catch (const InputError&) {
        throw CLI::ValidationError(
            what,
            "expected a symbol, such as Leaf or Ring(8), a drawing.svg or a grammar.lsys#Symbol, found '" + text + "'");
    }
}

OtherDrawing read_drawing(const std::string& name) {
    SvgReadResult drawing = read_svg(read_input(name), {.file_name = input_label(name), .split_compound_paths = false});
    say_warnings(drawing.warnings);
    return {std::move(drawing.scene.elements), symbol_for(name)};
}

OtherGrammar read_other(const std::string& name, const std::string& modules, const std::string& what) {
    OtherGrammar other{read_grammar(name), {}, symbol_for(name)};
    if (!modules.empty()) other.string = parse_modules(modules, what);
    return other;
}

}  // namespace

Replacement parse_replacement(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        throw CLI::ValidationError("SYMBOL=WITH", "expected a symbol, '=' and what takes its place, found '" + text + "'");
    Replacement replacement{.symbol = text.substr(0, equals), .label = text.substr(equals + 1)};
    const std::string& with = replacement.label;
    const std::size_t hash = lower(with).rfind(".lsys#");
    if (hash != std::string::npos) {
        const std::size_t end_of_file = with.find('#', hash);
        replacement.with = read_other(with.substr(0, end_of_file), with.substr(end_of_file + 1), text);
    } else if (ends_with(with, ".lsys")) {
        replacement.with = read_other(with, "", text);
    } else if (ends_with(with, ".svg") || ends_with(with, ".svgz")) {
        replacement.with = read_drawing(with);
    } else {
        replacement.with = OwnModules{parse_modules(with, text)};
    }
    return replacement;
}

}  // namespace rinceau
