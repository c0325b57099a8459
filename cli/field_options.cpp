#include "cli/field_options.h"

#include <algorithm>
#include <cmath>

#include "cli/named_values.h"
#include "cli/number_range.h"
#include "files/files.h"
#include "files/output_file.h"
#include "growth/surface/field_smooth.h"

namespace rinceau {
namespace {

[[noreturn]] void fail(const std::string& option, const std::string& message) {
    throw CLI::ValidationError(option, message);
}

std::string names_of_elements() {
    std::vector<std::string> names;
    for (const int n : {2, 1, 4})
        for (const FieldElementKind kind : field_element_kinds(n))
            if (std::ranges::find(names, name_of(kind)) == names.end()) names.emplace_back(name_of(kind));
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

int parse_vertex(const std::string& option, const std::string& text) {
    constexpr double most = 1e9;
    const double vertex = parse_number(option, "the number of a vertex", text);
    if (vertex < 0 || vertex > most || vertex != std::floor(vertex))
        fail(option, "expected the number of a vertex, found '" + text + "'");
    return static_cast<int>(vertex);
}

ElementWord parse_element(const std::string& text) {
    const std::string option = "--element", expected = "TYPE,VERTEX[,ANGLE[,DECAY[,WEIGHT]]]";
    const std::vector<std::string> parts = parse_list(option, text);
    constexpr std::size_t most_parts = 5;
    if (parts.size() < 2 || parts.size() > most_parts) fail(option, "expected " + expected + ", found '" + text + "'");
    const auto kind = field_element_kind(parts[0]);
    if (!kind) fail(option, "expected one of " + names_of_elements() + ", found '" + parts[0] + "'");
    ElementWord element{.kind = *kind, .vertex = parse_vertex(option, parts[1])};
    const auto number = [&](std::size_t i, const char* what, double otherwise) {
        return i < parts.size() ? parse_number(option, what, parts[i]) : otherwise;
    };
    element.angle = number(2, "an angle in degrees", element.angle);
    element.decay = number(3, "a decay above 0", element.decay);
    element.weight = number(4, "a weight above 0", element.weight);
    return element;
}

SmoothingRegion parse_region(const std::string& text) {
    const std::string option = "--smooth-at";
    const std::vector<std::string> parts = parse_list(option, text);
    if (parts.size() != 3) fail(option, "expected VERTEX,RADIUS,ROUNDS, found '" + text + "'");
    const double radius = parse_number(option, "a radius above 0", parts[1]);
    const double rounds = parse_number(option, "a number of rounds", parts[2]);
    if (!(radius > 0)) fail(option, "expected a radius above 0, found '" + parts[1] + "'");
    if (!(rounds >= 1 && rounds <= most_smoothing_rounds))
        fail(option, "expected 1 to " + std::to_string(most_smoothing_rounds) + " rounds, found '" + parts[2] + "'");
    return {parse_vertex(option, parts[0]), radius, static_cast<int>(rounds)};
}

/// "spiral x=1 y=2 angle=30": a kind, perhaps a file, and numbers.
FieldSource parse_source(const std::string& text) {
    FieldSource source{.place = {"--source"}};
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string word = text.substr(at, end - at);
        at = end + 1;
        if (word.empty()) continue;
        const std::size_t equals = word.find('=');
        if (source.kind.empty())
            source.kind = word;
        else if (equals != std::string::npos)
            source.numbers[word.substr(0, equals)] = parse_number("--source", "a number", word.substr(equals + 1));
        else
            source.text = word;
    }
    return source;
}

void add_sources(CLI::App& verb, FieldVerbOptions& options) {
    const auto add = [&](const std::string& name, const std::string& kind, const std::string& help) {
        verb.add_option_function<std::string>(
                name,
                [&options, kind, name](const std::string& file) {
                    options.sources.push_back({.kind = kind, .text = file, .place = {name}});
                },
                help)
            ->type_name("FILE");
    };
    verb.add_option_function<std::vector<std::string>>(
            "--element",
            [&options](const std::vector<std::string>& words) {
                for (const std::string& word : words) options.elements.push_back(parse_element(word));
            },
            "Design: " + names_of_elements() +
                "; at a vertex (counted from 0), turned by degrees from the way of +x, fading by exp(-DECAY distance / "
                "diagonal of the surface) (3), with a weight (1); may be repeated")
        ->type_name("TYPE,VERTEX[,ANGLE[,DECAY[,WEIGHT]]] ..");
    add("--elements", "elements", "Design: elements from a file (.json), by vertices or places in space");
    add("--field", "file", "A field from a file (.json), to smooth, convert or look at");
    add("--image", "image", "Along the edges of a picture (.png) that lies in x and y");
    verb.add_flag_callback(
        "--curvature", [&options] { options.sources.push_back({.kind = "curvature", .place = {"--curvature"}}); },
        "The surface's curvature tensor");
    verb.add_flag_callback(
        "--smoothest", [&options] { options.sources.push_back({.kind = "smoothest", .place = {"--smoothest"}}); },
        "The field that turns least");
    verb.add_option_function<std::string>(
            "--source", [&options](const std::string& text) { options.sources.push_back(parse_source(text)); },
            "Any source as grammars write it: 'spiral x=1 y=2 angle=30', 'direction y=1', 'image cat.png sigma=2'")
        ->type_name("TEXT");
    verb.add_option_function<int>(
            "--n",
            [&options](int n) {
                options.n = n;
                options.n_given = true;
            },
            "For --element and --smoothest: 1 vectors, 2 tensors or line fields (default), 4 crosses")
        ->check(CLI::IsMember({1, 2, 4}))
        ->type_name("1|2|4");
}

void add_smoothing(CLI::App& verb, FieldVerbOptions& options) {
    constexpr double widest = 100;
    verb.add_option("--smooth", options.smooth,
                    "Then smooth over so many diagonals of the surface: 0.03 a little, 1 all over")
        ->check(number_between(0, widest))
        ->type_name("R");
    verb.add_option("--rounds", options.rounds, "Then smooth by rounds, each vertex half-way to its neighbours' mean")
        ->check(CLI::Range(0, most_smoothing_rounds))
        ->type_name("K");
    verb.add_option_function<std::vector<std::string>>(
            "--smooth-at",
            [&options](const std::vector<std::string>& words) {
                for (const std::string& word : words) options.regions.push_back(parse_region(word));
            },
            "Then smooth by rounds within a radius (diagonals) of a vertex; may be repeated")
        ->type_name("VERTEX,RADIUS,ROUNDS ..");
}

void add_outputs(CLI::App& verb, FieldVerbOptions& options) {
    verb.add_option(
            "-o", options.outputs,
            "Output: .json (the field), .png (a look at it: its lines, and singular points yellow for wedges, blue for "
            "trisectors), .svg (the same, of the plane), .obj, .ply or .glb (lines and points as meshes); may be "
            "repeated; without it JSON on standard output")
        ->type_name("FILE ..");
    add_choice<FieldFrame>(verb, "--frame", options.frame,
                           "Values in .json as vectors in space (default), which fit the mesh in any order of its faces, or "
                           "against the vertices' edges",
                           {{"space", FieldFrame::space}, {"edge", FieldFrame::edge}}, "space|edge");
    verb.add_option("--report", options.report, "Also write singular points, indices and times (.json)")->type_name("FILE");
    constexpr double narrowest = 0.002, widest = 1;
    verb.add_option("--lines", options.spacing, "Pictures: distance between lines, diagonals of the surface (0.0125)")
        ->check(number_between(narrowest, widest))
        ->type_name("D");
    verb.add_flag("--minor", options.minor, "Pictures: also the lines across");
    verb.add_flag_callback(
        "--no-points", [&options] { options.points = false; }, "Pictures: without singular points");
    add_up_option(verb, options.up, "The axis that points up in .png and .glb: y (default) or z");
    add_view_option(
        verb, options.view,
        "Where a .png is seen from: so far round the up axis from the front, and so far above (30,20; planes from "
        "above)");
    verb.add_option("--width", options.width, "Width of a .png in pixels")
        ->check(CLI::Range(1, widest_png))
        ->capture_default_str()
        ->type_name("PX");
}

/// A field may be written over the file that it is from.
void expect_free_name(const std::string& option, const std::string& output, const FieldVerbOptions& options) {
    std::vector<std::string> inputs{options.surface};
    for (const FieldSource& source : options.sources)
        if (source.kind != "file" || option != "-o") inputs.push_back(source.text);
    expect_other_file(option, output, inputs);
    expect_writable(output);
}

}  // namespace

void add_field_options(CLI::App& verb, FieldVerbOptions& options) {
    verb.add_option("MESH", options.surface, "The surface (.obj, .off, .ply)")->type_name("FILE");
    add_plane_option(verb, options.size, "Instead of a surface, a piece of the plane about the origin");
    add_repair_option(verb, options.repair);
    add_sources(verb, options);
    add_smoothing(verb, options);
    add_outputs(verb, options);
}

void expect_field_options(const FieldVerbOptions& options) {
    if (options.surface.empty() != options.size.has_value())
        throw CLI::ValidationError("MESH", "expected a surface, or --size for a piece of the plane, and not both");
    const std::size_t sources = options.sources.size() + (options.elements.empty() ? 0 : 1);
    if (sources != 1)
        throw CLI::ValidationError("field", sources == 0
                                                ? "expected what the field is made of: --element, --elements, --field, "
                                                  "--curvature, --image, --smoothest or --source"
                                                : "expected one source of the field, found " + std::to_string(sources) +
                                                      "; smooth or look at one at a time");
    const bool takes_n = !options.elements.empty() || options.sources.front().kind == "smoothest";
    if (options.n_given && !takes_n) fail("--n", "is for --element and --smoothest");
    for (const std::string& output : options.outputs) {
        const FileFormat format = format_of(output, FileFormat::json);
        if (format != FileFormat::json && format != FileFormat::png && format != FileFormat::svg &&
            format != FileFormat::obj && format != FileFormat::ply && format != FileFormat::glb)
            fail("-o", "expected a name that ends in .json, .png, .svg, .obj, .ply or .glb, found '" + output + "'");
        expect_free_name("-o", output, options);
    }
    if (options.report.empty()) return;
    if (format_of(options.report, FileFormat::json) != FileFormat::json)
        fail("--report", "expected a name that ends in .json, found '" + options.report + "'");
    if (std::ranges::find(options.outputs, options.report) != options.outputs.end())
        fail("--report", "expected another file than that of -o, found '" + options.report + "'");
    expect_free_name("--report", options.report, options);
}

}  // namespace rinceau
