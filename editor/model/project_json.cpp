#include <filesystem>
#include <limits>
#include <utility>

#include "editor/model/project.h"
#include "exports/json_text.h"
#include "lsystem/grammar_text.h"
#include "lsystem/resolve_uses.h"
#include "scene/svg_read.h"
#include "scene/svg_write.h"

namespace rinceau {
namespace {

constexpr const char* format_name = "rinceau-project";
constexpr int newest_version = 1;

// ---- writing

/// The folder that used files are named from: that of the grammar that names them.
std::filesystem::path folder_of_uses(const Grammar& grammar) {
    return grammar.uses.empty() ? std::filesystem::path()
                                : std::filesystem::path(grammar.uses.front().place.file).parent_path();
}

Json used_json(const Document& document) {
    const auto folder = folder_of_uses(*document.grammar);
    Json used = Json::object();
    for (const auto& [name, text] : *document.used) {
        const std::string relative = folder.empty() ? name : std::filesystem::path(name).lexically_relative(folder).string();
        used[relative] = text_json(text);
    }
    return used;
}

Json grouping_json(const std::vector<GroupingWish>& grouping) {
    Json wishes = Json::array();
    for (const GroupingWish& wish : grouping) {
        const char* kind = wish.kind == GroupingKind::together ? "together" : "apart";
        wishes.push_back({{"kind", kind}, {"elements", wish.elements}});
    }
    return wishes;
}

Json analysis_json(const AnalyzeOptions& options) {
    return {{"tolerance", options.tolerance},
            {"similarity",
             {{"tolerance", options.similarity.tolerance},
              {"tolerance_of_diagonal", options.similarity.tolerance_of_diagonal},
              {"mirrored_copies", options.similarity.mirrored_copies}}},
            {"weights",
             {{"count", options.weights.count},
              {"nearness", options.weights.nearness},
              {"similarity", options.weights.similarity},
              {"length", options.weights.length}}},
            {"objective", options.objective == Objective::bits ? "bits" : "paper"},
            {"symmetrize", options.symmetrize},
            {"stochastic", options.stochastic},
            {"grouping", grouping_json(options.grouping)}};
}

Json stamp_json(const FileStamp& stamp) {
    // As it is read: a time before 1970 as a number without a sign.
    return {{"modified", std::to_string(static_cast<std::uint64_t>(stamp.modified))},
            {"bytes", std::to_string(stamp.bytes)},
            {"node", std::to_string(stamp.node)}};
}

Json origin_json(const ProjectOrigin& origin) {
    Json json{{"path", text_json(origin.path)}};
    if (origin.stamp) json["stamp"] = stamp_json(*origin.stamp);
    return json;
}

// ---- reading

GroupingWish wish_in(const JsonValue& value) {
    value.expect_keys({"kind", "elements"});
    const JsonValue kind = value.member("kind");
    if (kind.text() != "together" && kind.text() != "apart") kind.fail("\"together\" or \"apart\"");
    GroupingWish wish{kind.text() == "together" ? GroupingKind::together : GroupingKind::apart, {}};
    value.member("elements").each([&](const JsonValue& element) {
        wish.elements.push_back(element.whole(0, std::numeric_limits<int>::max()));
    });
    return wish;
}

AnalyzeOptions analysis_in(const JsonValue& value) {
    AnalyzeOptions options;
    value.expect_keys({"tolerance", "similarity", "weights", "objective", "symmetrize", "stochastic", "grouping"});
    options.tolerance = value.member("tolerance").number();
    const JsonValue similarity = value.member("similarity");
    options.similarity.tolerance = similarity.member("tolerance").number();
    options.similarity.tolerance_of_diagonal = similarity.member("tolerance_of_diagonal").number();
    options.similarity.mirrored_copies = similarity.member("mirrored_copies").truth();
    const JsonValue weights = value.member("weights");
    options.weights.count = weights.member("count").number();
    options.weights.nearness = weights.member("nearness").number();
    options.weights.similarity = weights.member("similarity").number();
    options.weights.length = weights.member("length").number();
    const JsonValue objective = value.member("objective");
    if (objective.text() != "bits" && objective.text() != "paper") objective.fail("\"bits\" or \"paper\"");
    options.objective = objective.text() == "bits" ? Objective::bits : Objective::paper;
    options.symmetrize = value.member("symmetrize").truth();
    options.stochastic = value.member("stochastic").truth();
    if (value.has("grouping"))
        value.member("grouping").each([&](const JsonValue& wish) { options.grouping.push_back(wish_in(wish)); });
    return options;
}

/// A whole number that JSON's own numbers may be too small for, as text.
std::uint64_t large_number(const JsonValue& value) {
    const std::string text = value.text();
    constexpr std::size_t most_digits = 19;
    if (text.empty() || text.size() > most_digits + 1 || text.find_first_not_of("0123456789") != std::string::npos)
        value.fail("a whole number in quotes");
    try {
        return std::stoull(text);
    } catch (const std::out_of_range&) {
        value.fail("a whole number below 2^64");
    }
}

DeriveOptions derivation_in(const JsonValue& value) {
    DeriveOptions derive;
    value.expect_keys({"depth", "seed"});
    constexpr int deepest = 1'000'000;
    derive.depth = value.member("depth").whole(-1, deepest);
    if (value.has("seed")) derive.seed = large_number(value.member("seed"));
    return derive;
}

ViewTransform view_in(const JsonValue& value) {
    ViewTransform view;
    value.expect_keys({"x", "y", "zoom"});
    view.center = {value.member("x").number(), value.member("y").number()};
    view.zoom = value.member("zoom").number();
    if (!(view.zoom > 0)) value.member("zoom").fail("a number above 0");
    return view;
}

ProjectOrigin origin_in(const JsonValue& value) {
    ProjectOrigin origin{.path = value.member("path").text()};
    if (!value.has("stamp")) return origin;
    const JsonValue stamp = value.member("stamp");
    origin.stamp = FileStamp{static_cast<std::int64_t>(large_number(stamp.member("modified"))),
                             large_number(stamp.member("bytes")), large_number(stamp.member("node"))};
    return origin;
}

UsedFiles used_in(const JsonValue& value, const std::filesystem::path& folder) {
    UsedFiles used;
    if (!value.json().is_object()) value.fail("an object");
    for (const auto& [name, text] : value.json().items())
        used[(folder / name).lexically_normal().string()] = value.member(name).text();
    return used;
}

Document grammar_in(const JsonValue& value, const std::string& path) {
    Document document = empty_document();
    if (value.has("used")) {
        document.used =
            std::make_shared<const UsedFiles>(used_in(value.member("used"), std::filesystem::path(path).parent_path()));
    }
    const std::string text = value.member("grammar").text();
    Grammar grammar;
    try {
        grammar = parse_grammar(text, path);
    } catch (const InputError& error) {
        const std::string message = std::string(error.what()).substr(located(error.place(), {}).size());
        throw InputError({path}, "grammar, line " + std::to_string(error.place().line) + ", column " +
                                     std::to_string(error.place().column) + ": " + message);
    }
    return with_grammar(document, std::move(grammar));
}

std::shared_ptr<const Scene> drawing_in(const JsonValue& value, const std::string& path) {
    return std::make_shared<const Scene>(read_svg(value.text(), {.file_name = path + " (drawing)"}).scene);
}

}  // namespace

std::string to_json(const Project& project) {
    const Document& document = project.document;
    Json json{{"format", format_name}, {"version", newest_version}, {"grammar", text_json(to_text(*document.grammar))}};
    if (document.used && !document.grammar->uses.empty()) json["used"] = used_json(document);
    json["analysis"] = analysis_json(document.analysis);
    json["derive"] = {{"depth", document.derive.depth}};
    if (document.derive.seed) json["derive"]["seed"] = std::to_string(*document.derive.seed);
    json["locked"] = document.locked;
    if (project.view)
        json["view"] = {{"x", project.view->center.x}, {"y", project.view->center.y}, {"zoom", project.view->zoom}};
    if (project.origin) json["origin"] = origin_json(*project.origin);
    if (document.drawing) json["drawing"] = text_json(write_svg(*document.drawing));
    constexpr int indentation = 1;
    return json.dump(indentation) + '\n';
}

Project parse_project(std::string_view text, const std::string& path) {
    const Json json = parse_json_document(text, path);
    const JsonValue value(json, path);
    if (value.member("format").text() != format_name) value.member("format").fail("\"rinceau-project\"");
    const JsonValue version = value.member("version");
    constexpr int versions = 1'000'000;
    if (version.whole(1, versions) > newest_version)
        throw InputError({path}, "was saved by a newer Rinceau (version " + std::to_string(version.whole(1, versions)) +
                                     " of the format; this one reads up to " + std::to_string(newest_version) +
                                     "): open it with that");
    value.expect_keys({"format", "version", "grammar", "used", "analysis", "derive", "locked", "view", "origin", "drawing"});
    Project project{.document = grammar_in(value, path)};
    Document& document = project.document;
    if (value.has("analysis")) document.analysis = analysis_in(value.member("analysis"));
    if (value.has("derive")) document.derive = derivation_in(value.member("derive"));
    if (value.has("locked"))
        value.member("locked").each([&](const JsonValue& name) { document.locked.insert(name.text()); });
    if (value.has("view")) project.view = view_in(value.member("view"));
    if (value.has("origin")) project.origin = origin_in(value.member("origin"));
    if (value.has("drawing")) document.drawing = drawing_in(value.member("drawing"), path);
    return project;
}

bool looks_like_project(std::string_view text) {
    constexpr std::size_t head = 200;  // the format is named first
    return text.substr(0, head).find(format_name) != std::string_view::npos;
}

}  // namespace rinceau
