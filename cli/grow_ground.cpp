#include "cli/grow_ground.h"

#include <filesystem>

#include <CLI/Error.hpp>

#include "cli/growth_input.h"
#include "cli/messages.h"
#include "files/files.h"
#include "growth/surface/check_shape_grammar.h"
#include "growth/surface/parse_shape_grammar.h"

namespace rinceau {
namespace {

void expect_options_of_kind(const std::vector<std::string>& others, const std::string& kind) {
    if (others.empty()) return;
    throw CLI::ValidationError(others.front(), "is for " + kind);
}

std::vector<std::pair<std::string, Expression>> param_values_of(const std::vector<std::string>& words) {
    std::vector<std::pair<std::string, Expression>> values;
    for (const std::string& word : words) {
        const std::size_t equals = word.find('=');
        const std::string name = word.substr(0, equals);
        values.emplace_back(name, parse_expression(word.substr(equals + 1), {"--set " + name}, {.queries = true}));
    }
    return values;
}

ShapeGrammar adapted(ShapeGrammar grammar, const GrowVerbOptions& options) {
    if (options.size) {
        ShapeSource plane{.name = "plane", .kind = {}, .text = {}, .numbers = {}, .words = {}, .comment = {}, .place = {}};
        const auto written = grammar.options.find("plane");
        if (written != grammar.options.end()) plane = written->second;
        plane.numbers["value"] = number_expression(options.size->x);
        plane.numbers["height"] = number_expression(options.size->y);
        grammar.options["plane"] = plane;
    }
    if (!options.field.empty()) {
        ShapeSource field = field_of_option(options.field);
        if (!grammar.fields.empty()) field.name = grammar.fields.front().name;
        if (grammar.fields.empty()) grammar.fields.emplace_back();
        grammar.fields.front() = std::move(field);
    }
    return with_params(std::move(grammar), param_values_of(options.params));
}

}  // namespace

ShapeSource field_of_option(const std::string& text) {
    const std::string ending = std::filesystem::path(text).extension().string();
    const std::string source = ending == ".json"  ? "file \"" + text + '"'
                               : ending == ".png" ? "image \"" + text + '"'
                                                  : text;
    return parse_shape_grammar("field F1 = " + source, "--field").fields.at(0);
}

ReadNamedFile grammar_files(const GrowVerbOptions& options) {
    return [beside = files_beside(options.input), given = options.field](const std::string& name) {
        return name == given ? read_input(name) : beside(name);
    };
}

GrowInput read_grow_input(const GrowVerbOptions& options) {
    GrowInput input{.label = input_label(options.input), .grammar = {}, .warnings = {}};
    const std::string bytes = read_input(options.input);
    const bool is_called_so = std::filesystem::path(options.input).extension() == ".fgsg";
    if (is_called_so || (!looks_like_drawing(bytes) && looks_like_shape_grammar(bytes))) {
        expect_options_of_kind(options.drawing_only, "drawings and L-systems, and " + input.label + " is a shape grammar");
        ParsedShapeGrammar parsed = read_shape_grammar(bytes, input.label);
        input.mistakes = std::move(parsed.mistakes);
        if (!input.mistakes.empty()) return input;
        ShapeGrammar grammar = adapted(std::move(parsed.grammar), options);
        input.mistakes = shape_grammar_mistakes(grammar);
        input.grammar = std::move(grammar);
        return input;
    }
    expect_options_of_kind(options.shapes_only, "shape grammars (.fgsg), and " + input.label + " is none");
    AnalyzedInput rules = read_rules(options.input, bytes, options.threads);
    input.grammar = std::move(rules.grammar);
    input.warnings = std::move(rules.warnings);
    return input;
}

std::shared_ptr<const SurfaceMesh> read_ground(const GrowVerbOptions& options, std::vector<std::string>& warnings) {
    if (options.surface.empty()) return nullptr;
    return std::make_shared<const SurfaceMesh>(read_surface_file(options.surface, options.repair, warnings));
}

}  // namespace rinceau
