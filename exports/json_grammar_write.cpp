#include "exports/json_grammar.h"
#include "exports/json_style.h"
#include "lsystem/expression.h"
#include "scene/svg_write.h"

namespace rinceau {

namespace {

Json corners_json(const Box& box) {
    if (is_empty(box)) return nullptr;
    return {{"left", box.low.x}, {"top", -box.high.y}, {"right", box.high.x}, {"bottom", -box.low.y}};
}

void add_text(Json& json, const char* key, const std::string& text) {
    if (!text.empty()) json[key] = text_json(text);
}

Json module_json(const ModuleTemplate& module) {
    Json json{{"symbol", module.symbol}};
    for (const Expression& argument : module.arguments) json["arguments"].push_back(to_text(argument));
    return json;
}

Json modules_json(const std::vector<ModuleTemplate>& modules) {
    Json json = Json::array();
    for (const ModuleTemplate& module : modules) json.push_back(module_json(module));
    return json;
}

Json context_json(const std::vector<ContextModule>& context) {
    Json json = Json::array();
    for (const ContextModule& module : context) {
        json.push_back({{"symbol", module.symbol}});
        if (!module.parameters.empty()) json.back()["parameters"] = module.parameters;
    }
    return json;
}

const char* kind_text(ProductionKind kind) {
    switch (kind) {
        case ProductionKind::decomposition:
            return "decomposition";
        case ProductionKind::homomorphism:
            return "homomorphism";
        case ProductionKind::rewriting:
            break;
    }
    return "rewriting";
}

Json production_json(const Production& production) {
    Json json{{"symbol", production.symbol}};
    if (production.kind != ProductionKind::rewriting) json["kind"] = kind_text(production.kind);
    if (!production.parameters.empty()) json["parameters"] = production.parameters;
    if (!production.left_context.empty()) json["left"] = context_json(production.left_context);
    if (!production.right_context.empty()) json["right"] = context_json(production.right_context);
    if (production.condition) json["condition"] = to_text(*production.condition);
    json["successor"] = modules_json(production.successor);
    if (production.weight) json["weight"] = to_text(*production.weight);
    add_text(json, "comment", production.comment);
    return json;
}

Json terminal_json(const Terminal& terminal) {
    Json json{{"symbol", terminal.symbol}};
    if (terminal.style != 0) json["style"] = terminal.style;
    if (!terminal.paths.empty()) json["path"] = svg_path_data(terminal.paths);
    add_text(json, "id", terminal.id);
    if (!is_empty(terminal.verbatim_box)) json["box"] = corners_json(terminal.verbatim_box);
    add_text(json, "verbatim", terminal.verbatim);
    add_text(json, "comment", terminal.comment);
    return json;
}

/// One item a line.
template <class Items, class ToJson>
void append_list(std::string& text, const char* key, const Items& items, ToJson to_json) {
    if (items.empty()) return;
    std::string lines;
    for (const auto& item : items) lines += (lines.empty() ? "\n  " : ",\n  ") + to_json(item).dump();
    text += std::string(",\n \"") + key + "\": [" + lines + ']';
}

template <class Value>
void append_value(std::string& text, const char* key, const Value& value) {
    text += std::string(",\n \"") + key + "\": " + Json(value).dump();
}

}  // namespace

Export to_json(const Grammar& grammar, const ExportOptions&) {
    std::string text = "{\"format\": \"rinceau-grammar\", \"version\": 1";
    if (!grammar.title.empty()) append_value(text, "title", text_json(grammar.title));
    append_list(text, "comments", grammar.comments, text_json);
    append_value(text, "canvas", corners_json(grammar.canvas));
    if (!grammar.sized) append_value(text, "sized", false);
    if (grammar.seed) append_value(text, "seed", *grammar.seed);
    append_list(text, "uses", grammar.uses, [](const Use& use) {
        Json json{{"file", text_json(use.file)}};
        if (!use.prefix.empty()) json["prefix"] = use.prefix;
        add_text(json, "comment", use.comment);
        return json;
    });
    if (!grammar.ignored.empty()) append_value(text, "ignored", grammar.ignored);
    append_list(text, "constants", grammar.constants, [](const Constant& constant) {
        Json json{{"name", constant.name}, {"value", to_text(constant.value)}};
        add_text(json, "comment", constant.comment);
        return json;
    });
    append_list(text, "axiom", grammar.axiom, module_json);
    append_list(text, "productions", grammar.productions, production_json);
    append_list(text, "exceptions", grammar.exceptions, [](const Exception& exception) {
        Json json{{"address", exception.address}, {"successor", modules_json(exception.successor)}};
        add_text(json, "comment", exception.comment);
        return json;
    });
    append_list(text, "styles", grammar.styles, [](const NumberedStyle& style) {
        Json json{{"number", style.number}};
        json.update(style_json(style.style));
        add_text(json, "comment", style.comment);
        return json;
    });
    append_list(text, "terminals", grammar.terminals, terminal_json);
    return {.bytes = text + "}\n"};
}

}  // namespace rinceau
