#include "files/replacement_text.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "files/files.h"
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

/// "vine.lsys#Leaf": a file and modules; one of both may be empty.
struct WithParts {
    std::string file;
    std::string modules;
};

WithParts parts_of(const std::string& with) {
    const std::size_t hash = lower(with).rfind(".lsys#");
    if (hash != std::string::npos) {
        const std::size_t end_of_file = with.find('#', hash);
        return {with.substr(0, end_of_file), with.substr(end_of_file + 1)};
    }
    const bool file = ends_with(with, ".lsys") || ends_with(with, ".svg") || ends_with(with, ".svgz");
    return file ? WithParts{with, ""} : WithParts{"", with};
}

/// A string of modules, as it stands behind "axiom:".
ModuleTemplates parse_modules(const std::string& text) {
    try {
        ModuleTemplates string = parse_grammar("lsystem 1\naxiom: " + text).axiom;
        for (ModuleTemplate& module : string) module.place = {};
        return string;
    } catch (const InputError&) {
        throw InputError(
            {}, "expected a symbol, such as Leaf or Ring(8), a drawing.svg or a grammar.lsys#Symbol, found '" + text + "'");
    }
}

}  // namespace

void expect_replacement_text(const std::string& with) { parse_modules(parts_of(with).modules); }

WrittenReplacement read_replacement(const std::string& symbol, const std::string& with) {
    WrittenReplacement read{{.symbol = symbol, .label = with}, {}};
    const WithParts parts = parts_of(with);
    ModuleTemplates modules = parse_modules(parts.modules);
    if (parts.file.empty()) {
        read.replacement.with = OwnModules{std::move(modules)};
    } else if (ends_with(parts.file, ".lsys")) {
        read.replacement.with = OtherGrammar{read_grammar(parts.file), std::move(modules), symbol_for(parts.file)};
    } else {
        const std::string label = input_label(parts.file);
        SvgReadResult drawing = read_svg(read_input(parts.file), {.file_name = label, .split_compound_paths = false});
        read.warnings = std::move(drawing.warnings);
        read.replacement.with = OtherDrawing{std::move(drawing.scene.elements), symbol_for(parts.file)};
    }
    return read;
}

}  // namespace rinceau
