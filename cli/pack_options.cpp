#include "cli/pack_options.h"

#include <algorithm>
#include <array>
#include <map>

#include "cli/named_values.h"
#include "cli/number_range.h"
#include "files/output_file.h"
#include "geometry/angle.h"

namespace rinceau {
namespace {

constexpr int widest_png = 32767;  // librsvg's and cairo's limit

[[noreturn]] void fail(const std::string& option, const std::string& message) {
    throw CLI::ValidationError(option, message);
}

std::vector<double> parse_numbers(const std::string& option, const std::string& expected, const std::string& text) {
    std::vector<double> numbers;
    for (const std::string& part : parse_list(option, text)) numbers.push_back(parse_number(option, expected, part));
    return numbers;
}

Point parse_size(const std::string& text) {
    const std::string expected = "a width and a height above 0, W,H";
    const std::vector<double> numbers = parse_numbers("--size", expected, text);
    if (numbers.size() != 2 || !(numbers[0] > 0 && numbers[1] > 0))
        fail("--size", "expected " + expected + ", found '" + text + "'");
    return {numbers[0], numbers[1]};
}

void parse_scale(const std::string& text, AggregateOptions& fill) {
    const std::string expected = "a scale above 0, or two, MIN,MAX";
    const std::vector<double> numbers = parse_numbers("--scale", expected, text);
    if (numbers.size() > 2 || !(numbers.front() > 0 && numbers.front() <= numbers.back()))
        fail("--scale", "expected " + expected + ", found '" + text + "'");
    fill.min_scale = numbers.front();
    fill.max_scale = numbers.back();
}

/// "0,90,180" or "-20..20".
void parse_angles(const std::string& text, PackAngles& angles) {
    const std::string expected = "degrees: A,B,.. or LOW..HIGH";
    constexpr double degree = pi / 180;
    const std::size_t dots = text.find("..");
    if (dots == std::string::npos) {
        for (const double angle : parse_numbers("--angles", expected, text)) angles.only.push_back(degree * angle);
        return;
    }
    const std::vector<double> low = parse_numbers("--angles", expected, text.substr(0, dots));
    const std::vector<double> high = parse_numbers("--angles", expected, text.substr(dots + 2));
    if (low.size() != 1 || high.size() != 1 || low[0] > high[0])
        fail("--angles", "expected " + expected + ", found '" + text + "'");
    angles.low = degree * low[0];
    angles.high = degree * high[0];
}

/// `type` lists the words: "dome|cone".
template <class Value>
void add_choice(CLI::App& verb, const std::string& name, Value& value, const std::string& help,
                const std::map<std::string, Value>& choices, const std::string& type) {
    const auto choose = [&value, name, choices, type](const std::string& word) {
        const auto chosen = choices.find(word);
        if (chosen == choices.end()) fail(name, "expected " + type + ", found '" + word + "'");
        value = chosen->second;
    };
    verb.add_option_function<std::string>(name, choose, help)->type_name(type);
}

void add_domain(CLI::App& verb, PackVerbOptions& options) {
    verb.add_option_function<std::string>(
            "--size", [&options](const std::string& text) { options.size = parse_size(text); },
            "Fill a rectangle of this width and height")
        ->type_name("W,H");
    verb.add_option("--region", options.region,
                    "Fill what the closed outlines of a drawing (.svg) enclose; an outline inside another is a hole")
        ->type_name("FILE");
    verb.add_flag("--tile", options.tile,
                  "With --size: what leaves on one side comes in on the other, a tile without a seam");
}

void add_shape_options(CLI::App& verb, PackVerbOptions& options) {
    verb.add_option("--element", options.raised,
                    "A symbol of the rules behind the drawing (rinceau analyze) whose every expansion is one shape")
        ->delimiter(',')
        ->type_name("SYMBOL,..");
    verb.add_option("--margin", options.exclusive.margin,
                    "Distance that is kept around every shape; negative: how far shapes may reach over each other")
        ->capture_default_str()
        ->type_name("M");
    add_choice<bool>(verb, "--holes", options.exclusive.keep_holes,
                     "Holes of shapes: others may stand in them, or not (default)", {{"keep", true}, {"fill", false}},
                     "keep|fill");
    verb.add_option(
            "--regions", options.drawn_regions,
            "Drawings (.svg) of the areas that shapes keep for themselves, a closed outline for each shape in the order "
            "of the shapes, drawn over them: one for all of SHAPES, or one for each; circle: the circle about each shape")
        ->delimiter(',')
        ->type_name("FILE,..|circle");
    verb.add_option_function<std::string>(
            "--shares",
            [&options](const std::string& text) {
                options.shares = parse_named_values({.option = "--shares", .high = 1e6}, text);
            },
            "How many of each shape, in proportion; 1 for those that are not named")
        ->type_name("SYMBOL=N,..");
    verb.add_option("--share-tolerance", options.fill.share_tolerance,
                    "How far shares may be missed for a denser filling: 0 = strictly in turn, 1 = whatever fits")
        ->check(number_between(0, 1))
        ->capture_default_str()
        ->type_name("T");
}

void add_placing_options(CLI::App& verb, PackVerbOptions& options) {
    verb.add_option_function<std::string>(
            "--scale", [&options](const std::string& text) { parse_scale(text, options.fill); },
            "Sizes of the shapes, times what is drawn: one, or from MIN to MAX")
        ->type_name("MIN,MAX");
    verb.add_option_function<std::string>(
            "--angles", [&options](const std::string& text) { parse_angles(text, options.fill.angles); },
            "Angles of the shapes, degrees counter-clockwise from how they are drawn: some, or a range; without it, any")
        ->type_name("A,B,..|LOW..HIGH");
    verb.add_option("--flow", options.flow, "Strokes (.svg) that angles are measured from, instead of the horizontal")
        ->type_name("FILE");
    verb.add_option("--density", options.density,
                    "A picture (.png) laid over it all: dark places are filled, white ones stay free")
        ->type_name("FILE");
}

void add_method_options(CLI::App& verb, PackVerbOptions& options) {
    add_choice<PackMethod>(verb, "--method", options.fill.method,
                           "settle (default): shapes are slid and turned into gaps; gaps, naive: the paper's methods",
                           {{"settle", PackMethod::settle}, {"gaps", PackMethod::gaps}, {"naive", PackMethod::naive}},
                           "settle|gaps|naive");
    add_choice<PackQuality>(verb, "--quality", options.fill.quality,
                            "fast (default), or best: shapes also grow into their gaps, and all is shaken and filled again",
                            {{"fast", PackQuality::fast}, {"best", PackQuality::best}}, "fast|best");
    verb.add_option("--stop", options.fill.stop, "Failures in a row after which it is full; 0 = the method's own")
        ->capture_default_str()
        ->type_name("N");
    verb.add_option("--count", options.fill.max_count, "Most shapes to be placed")
        ->check(CLI::PositiveNumber)
        ->capture_default_str()
        ->type_name("N");
    verb.add_option("--seed", options.fill.seed, "For what is random; the same seed gives the same bytes")
        ->capture_default_str()
        ->type_name("N");
    constexpr int most_threads = 1024;
    verb.add_option("--threads", options.threads, "Threads; 0 = one per processor; the result is the same for any number")
        ->check(CLI::Range(0, most_threads))
        ->capture_default_str()
        ->type_name("N");
    verb.add_option("--seconds", options.seconds, "Fill for so long at most; what stands by then is written (status 3)")
        ->check(CLI::PositiveNumber)
        ->type_name("T");
}

void add_relief_options(CLI::App& verb, PackVerbOptions& options) {
    verb.add_option("--height-map", options.height_map,
                    "Also write a relief, 16 bits (.png): shapes are ridges, gaps are furrows")
        ->type_name("FILE");
    verb.add_option("--shaded", options.shaded, "Also write a picture of the relief in light (.png)")->type_name("FILE");
    add_choice<CristaProfile>(
        verb, "--profile", options.relief.profile, "Shape of a ridge: dome (default), plateau or cone",
        {{"dome", CristaProfile::dome}, {"plateau", CristaProfile::plateau}, {"cone", CristaProfile::cone}},
        "dome|plateau|cone");
    constexpr double deepest = 0.99;
    verb.add_option("--depth", options.relief.depth, "Depth of the furrows, as a share of all height")
        ->check(number_between(0, deepest))
        ->capture_default_str()
        ->type_name("D");
    verb.add_option("--sulci", options.sulci,
                    "Drawings (.svg) of furrows that are sunk in where the shapes stand, drawn over them as with --regions")
        ->delimiter(',')
        ->type_name("FILE,..");
}

void expect_ending(const std::string& option, const std::string& name, FileFormat format, const std::string& ending) {
    if (!name.empty() && format_of(name, FileFormat::unknown) != format)
        fail(option, "expected a name that ends in " + ending + ", found '" + name + "'");
    if (!name.empty()) expect_writable(name);
}

void expect_output(const PackVerbOptions& options) {
    const FileFormat format = format_of(options.output, FileFormat::svg);
    constexpr std::array<FileFormat, 7> written{FileFormat::svg,  FileFormat::png, FileFormat::pdf, FileFormat::lsys,
                                                FileFormat::json, FileFormat::obj, FileFormat::glb};
    if (std::ranges::find(written, format) == written.end())
        fail("-o",
             "expected a name that ends in .svg, .lsys, .json, .png, .pdf, .obj or .glb, found '" + options.output + "'");
    expect_writable(options.output);
    if ((format == FileFormat::obj || format == FileFormat::glb) && options.meshes.empty() && !from_meshes(options))
        fail("-o", "expected --meshes with a mesh for each shape beside '" + options.output + "'");
    expect_ending("--height-map", options.height_map, FileFormat::png, ".png");
    expect_ending("--shaded", options.shaded, FileFormat::png, ".png");
    expect_ending("--report", options.report, FileFormat::json, ".json");
}

}  // namespace

bool from_meshes(const PackVerbOptions& options) {
    return std::ranges::all_of(options.shapes,
                               [](const std::string& name) { return format_of(name, FileFormat::svg) == FileFormat::obj; });
}

bool keeps_circles(const PackVerbOptions& options) { return options.drawn_regions == std::vector<std::string>{"circle"}; }

void add_pack_options(CLI::App& verb, PackVerbOptions& options) {
    verb.add_option(
            "SHAPES", options.shapes,
            "A drawing (.svg, .svgz, or - for standard input), of which each figure is a shape; several drawings: each "
            "is one; or meshes (.obj), which are packed on the ground")
        ->required();
    verb.add_option("-o,--output", options.output,
                    "The aggregate (.svg, .png, .pdf), its grammar (.lsys), its placements (.json) or meshes (.obj, .glb); "
                    "without it, SVG to standard output")
        ->type_name("FILE");
    add_domain(verb, options);
    add_shape_options(verb, options);
    add_placing_options(verb, options);
    add_method_options(verb, options);
    verb.add_option("--meshes", options.meshes,
                    "A mesh (.obj) for each shape, which stands in its place in .obj, .glb and .png: as large as fits the "
                    "shape's box")
        ->delimiter(',')
        ->type_name("FILE,..");
    add_choice<UpAxis>(verb, "--up", options.up, "Which axis of meshes points up: y (default) or z",
                       {{"y", UpAxis::y}, {"z", UpAxis::z}}, "y|z");
    add_relief_options(verb, options);
    verb.add_option("--width", options.width,
                    "Width of pictures in pixels; without it, that of the drawing, 900 for meshes, 1024 for a relief")
        ->check(CLI::Range(1, widest_png))
        ->type_name("W");
    verb.add_option("--report", options.report,
                    "Where to write what was reached (.json, as docs/pack_report.schema.json says)")
        ->type_name("FILE");
}

void expect_pack_options(const PackVerbOptions& options) {
    if (options.size.has_value() == !options.region.empty())
        fail("--size",
             "expected either --size W,H or --region FILE, found " + std::string(options.size ? "both" : "neither"));
    if (options.tile && !options.size) fail("--tile", "is for --size only");
    const bool meshes = from_meshes(options);
    const auto is_mesh = [](const std::string& name) { return format_of(name, FileFormat::svg) == FileFormat::obj; };
    if (!meshes && std::ranges::any_of(options.shapes, is_mesh)) fail("SHAPES", "expected drawings or meshes, found both");
    if (meshes && !options.meshes.empty()) fail("--meshes", "is for shapes from drawings only");
    if (meshes && !options.drawn_regions.empty() && !keeps_circles(options))
        fail("--regions", "is for shapes from drawings only");
    if (meshes && !options.sulci.empty()) fail("--sulci", "is for shapes from drawings only");
    if (!options.sulci.empty() && options.height_map.empty() && options.shaded.empty())
        fail("--sulci", "is for --height-map and --shaded only");
    expect_output(options);
}

}  // namespace rinceau
