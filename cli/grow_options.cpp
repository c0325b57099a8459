#include "cli/grow_options.h"

#include <algorithm>
#include <array>

#include "cli/number_range.h"
#include "files/files.h"
#include "files/output_file.h"

namespace rinceau {
namespace {

constexpr double largest_length = 1e9;

[[noreturn]] void fail(const std::string& option, const std::string& message) {
    throw CLI::ValidationError(option, message);
}

void add_ground_options(CLI::App& verb, GrowVerbOptions& options) {
    verb.add_option("--on", options.surface, "The surface to grow on (.obj, .off, .ply); without it, a piece of the plane")
        ->type_name("MESH");
    add_repair_option(verb, options.repair);
    add_plane_option(verb, options.size,
                     "Without --on: size of the piece of the plane, which is about the origin (1,1 unless the grammar says "
                     "otherwise)");
    verb.add_option("--field", options.field,
                    "The field that guides: a file of `rinceau field` (.json), or a source as grammars write it, such as "
                    "'smoothest n=4' or curvature; in a shape grammar it takes the place of the first field")
        ->type_name("FIELD");
}

void add_limits(CLI::App& verb, GrowVerbOptions& options) {
    verb.add_option("--seed", options.seed, "For what is random; the same seed gives the same bytes")
        ->capture_default_str()
        ->type_name("N");
    constexpr long most_shapes = 100'000'000;
    verb.add_option("--max-shapes", options.max_shapes,
                    "Stop with status 3 at so many shapes, placed and waiting (1000000 "
                    "unless the grammar says otherwise)")
        ->check(CLI::Range(1L, most_shapes))
        ->type_name("N");
    verb.add_option("--seconds", options.seconds, "Stop with status 3 after so long")
        ->check(CLI::PositiveNumber)
        ->type_name("S");
    verb.add_flag("--keep-partial", options.keep_partial,
                  "Write what stands when a limit is reached; without it nothing is written then");
}

void add_output_options(CLI::App& verb, GrowVerbOptions& options) {
    verb.add_option("-o", options.output,
                    "Output: .obj, .ply, .glb (small: copies are instances), .png (a look at it), .svg (in the plane); "
                    "without it OBJ on standard output, in the plane SVG")
        ->type_name("FILE");
    verb.add_option("--report", options.report, "Also write figures about it (.json)")->type_name("FILE");
    verb.add_flag("--with-surface", options.with_surface, "Also write the surface itself; pictures always show it");
    add_choice<GlbInstancing>(
        verb, "--instancing", options.instancing,
        "Copies in .glb: gpu (default; by EXT_mesh_gpu_instancing), nodes (for viewers without it), merge (triangles of "
        "their own)",
        {{"gpu", GlbInstancing::gpu}, {"nodes", GlbInstancing::nodes}, {"merge", GlbInstancing::merge}}, "gpu|nodes|merge");
    add_up_option(verb, options.up, "The axis that points up in pictures and .glb: y (default) or z");
    add_view_option(verb, options.view,
                    "Where a picture is seen from: so far round the up axis from the front, and so far above; without it, "
                    "from where the pattern faces");
    verb.add_option("--width", options.width, "Width of a .png in pixels")
        ->check(CLI::Range(1, widest_png))
        ->type_name("PX");
}

void add_shape_options(CLI::App& verb, GrowVerbOptions& options) {
    verb.add_option_function<std::vector<std::string>>(
            "--set",
            [&options](const std::vector<std::string>& words) {
                for (const std::string& word : words)
                    if (word.find('=') == 0 || word.find('=') == std::string::npos)
                        fail("--set", "expected NAME=VALUE, found '" + word + "'");
                options.params.insert(options.params.end(), words.begin(), words.end());
                options.shapes_only.push_back("--set");
            },
            "Shape grammars: another value of a param, a number or an expression; may be repeated")
        ->type_name("NAME=VALUE ..");
}

void add_drawing_options(CLI::App& verb, GrowVerbOptions& options) {
    GrowDrawingOptions& drawing = options.drawing;
    std::vector<std::string>& noted = options.drawing_only;
    const auto number = [&](const std::string& name, double& value, double low, double high, const std::string& help,
                            const std::string& type) {
        verb.add_option_function<double>(
                name,
                [&value, &noted, name](double given) {
                    value = given;
                    noted.push_back(name);
                },
                help)
            ->check(number_between(low, high))
            ->type_name(type);
    };
    verb.add_option_function<int>(
            "--vertex",
            [&options, &noted](int vertex) {
                options.vertex = vertex;
                noted.push_back("--vertex");
            },
            "Drawings: begin at this vertex of the surface, counted from 0")
        ->check(CLI::NonNegativeNumber)
        ->type_name("N");
    verb.add_option_function<std::string>(
            "--at",
            [&options, &noted](const std::string& text) {
                const std::vector<double> numbers = parse_numbers("--at", "a place in space, X,Y,Z", text, 3);
                options.at = SpacePoint{numbers[0], numbers[1], numbers[2]};
                noted.push_back("--at");
            },
            "Drawings: begin at the vertex nearest to this place")
        ->type_name("X,Y,Z");
    number(
        "--scale", drawing.scale, 1 / largest_length, largest_length,
        "Drawings: length on the surface of a unit of the drawing; without it, the drawing's diagonal becomes half of the "
        "surface's",
        "S");
    constexpr double turn = 360;
    number("--heading", drawing.heading, -turn, turn,
           "Drawings: degrees that the drawing's up is turned counter-clockwise from the field, or from the surface's up",
           "DEGREES");
    number("--follow", drawing.follow, 0, 1,
           "Drawings: how far growth follows the field: 0 = not at all, 1 = keeping its angle to it (0.4)", "W");
    add_choice<LayGroups>(
        verb, "--lay", drawing.lay,
        "Drawings: lay whole groups flat where they fit (auto, default), every element by itself (never), or always groups",
        {{"auto", LayGroups::automatic}, {"never", LayGroups::never}, {"always", LayGroups::always}}, "auto|never|always",
        &noted);
    number("--height", drawing.height, 0, largest_length,
           "Drawings: raise the elements by so much, with walls; 0 (default) = flat", "H");
    verb.add_flag_callback(
        "--meet-itself",
        [&drawing, &noted] {
            drawing.meet_itself = true;
            noted.push_back("--meet-itself");
        },
        "Drawings: keep elements that overlap on the surface but not in the drawing");
    constexpr int deepest = 100000;
    verb.add_option_function<int>(
            "--depth",
            [&drawing, &noted](int depth) {
                drawing.depth = depth;
                noted.push_back("--depth");
            },
            "Drawings: derivation depth instead of the grammar's own")
        ->check(CLI::Range(0, deepest))
        ->type_name("N");
}

}  // namespace

void add_grow_options(CLI::App& verb, GrowVerbOptions& options) {
    verb.add_option(
            "GRAMMAR", options.input,
            "A shape grammar (.fgsg), an L-system (.lsys, .json) or a drawing (.svg), whose rules are found first; - "
            "for standard input")
        ->required()
        ->type_name("FILE");
    add_ground_options(verb, options);
    add_output_options(verb, options);
    add_shape_options(verb, options);
    add_limits(verb, options);
    add_drawing_options(verb, options);
}

void expect_grow_options(const GrowVerbOptions& options) {
    const bool plane = options.surface.empty();
    if (plane && options.repair) fail("--repair", "is for a surface: add --on MESH");
    if (!plane && options.size) fail("--size", "is for growth in the plane: leave out --on or this");
    if (!plane && options.surface == "-" && options.input == "-")
        fail("--on", "expected a file: standard input is the grammar already");
    if (options.vertex && options.at) fail("--at", "expected one place: leave out --vertex or this");
    const FileFormat format = format_of(options.output, plane ? FileFormat::svg : FileFormat::obj);
    constexpr std::array<FileFormat, 5> written{FileFormat::obj, FileFormat::ply, FileFormat::glb, FileFormat::png,
                                                FileFormat::svg};
    if (std::ranges::find(written, format) == written.end())
        fail("-o", "expected a name that ends in .obj, .ply, .glb, .png or .svg, found '" + options.output + "'");
    if (format == FileFormat::svg && !plane)
        fail("-o", "expected .obj, .ply, .glb or .png for growth on a surface, found '" + options.output + "'");
    expect_other_file("-o", options.output, {options.input, options.surface, options.field});
    expect_writable(options.output);
    if (options.report.empty()) return;
    expect_other_file("--report", options.report, {options.input, options.surface, options.field});
    if (format_of(options.report, FileFormat::json) != FileFormat::json)
        fail("--report", "expected a name that ends in .json, found '" + options.report + "'");
    expect_writable(options.report);
}

}  // namespace rinceau
