#include "cli/arrange_settings.h"

#include <map>

#include "cli/growth_output.h"
#include "cli/named_values.h"
#include "cli/number_range.h"
#include "files/files.h"
#include "files/output_file.h"
#include "geometry/angle.h"

namespace rinceau {
namespace {

constexpr double longest_side = 1e6;  // px of a canvas
constexpr double longest_time = 1e6;  // seconds
constexpr double largest_priority = 1000;
constexpr double largest_weight = 1000;
constexpr std::size_t most_elements = 1'000'000;
constexpr int most_threads = 1024;

Point parse_size(const std::string& text) {
    const std::vector<std::string> parts = parse_list("--size", text);
    const std::string expected = "W,H, two lengths up to 1000000";
    if (parts.size() != 2) throw CLI::ValidationError("--size", "expected " + expected + ", found '" + text + "'");
    const Point size{parse_number("--size", expected, parts[0]), parse_number("--size", expected, parts[1])};
    if (!(size.x > 0 && size.x <= longest_side && size.y > 0 && size.y <= longest_side))
        throw CLI::ValidationError("--size", "expected " + expected + ", found '" + text + "'");
    return size;
}

/// "PATH.svg,RADIUS"; the name may have commas.
void parse_spray(const std::string& text, ArrangeSettings& settings) {
    const std::size_t comma = text.rfind(',');
    const std::string expected = "PATH.svg,RADIUS";
    if (comma == std::string::npos || comma == 0)
        throw CLI::ValidationError("--spray", "expected " + expected + ", found '" + text + "'");
    settings.spray = text.substr(0, comma);
    settings.spray_radius = parse_number("--spray", expected, std::string_view(text).substr(comma + 1));
    if (!(settings.spray_radius > 0))
        throw CLI::ValidationError("--spray", "expected a radius above 0, found '" + text + "'");
}

std::vector<std::pair<int, int>> parse_flips(const std::string& text) {
    const auto element = [](std::string_view part, const std::string& whole) {
        const double number = parse_number("--flip-edges", "pairs of elements like 3-7,5-9", part);
        if (!(number >= 0 && number <= most_elements) || number != static_cast<int>(number))
            throw CLI::ValidationError("--flip-edges", "expected pairs of elements like 3-7,5-9, found '" + whole + "'");
        return static_cast<int>(number);
    };
    std::vector<std::pair<int, int>> flips;
    for (const std::string& part : parse_list("--flip-edges", text)) {
        const std::size_t dash = std::min(part.find('-'), part.size());
        const std::string_view view(part);
        const std::string_view second = dash < part.size() ? view.substr(dash + 1) : std::string_view();
        flips.emplace_back(element(view.substr(0, dash), part), element(second, part));
    }
    return flips;
}

JitterOptions parse_jitter(const std::string& text) {
    // Angles in degrees.
    constexpr double half_circle = 180;
    JitterOptions jitter;
    for (const auto& [name, value] : parse_named_values(
             {.option = "--jitter", .names = {"angle", "scale", "color"}, .low = 0, .high = half_circle}, text)) {
        if (name != "angle" && value > 1)
            throw CLI::ValidationError("--jitter", "expected " + name + " from 0 to 1, found '" + text + "'");
        if (name == "angle") jitter.angle = radians(value);
        if (name == "scale") jitter.scale = value;
        if (name == "color") jitter.color = value;
    }
    return jitter;
}

MatchWeights parse_match_weights(const std::string& text) {
    if (text == "paper") return paper_weights();
    MatchWeights weights;
    const NamedValues format{.option = "--weights",
                             .names = {"distance", "symbol", "same", "repeat", "balance"},
                             .low = 0,
                             .high = largest_weight};
    for (const auto& [name, value] : parse_named_values(format, text)) {
        if (name == "distance") weights.distance = value;
        if (name == "symbol") weights.symbol = value;
        if (name == "same") weights.sub_id = value;
        if (name == "repeat") weights.repeat = value;
        if (name == "balance") weights.balance = value;
    }
    return weights;
}

/// An option whose text is read while the command line is parsed.
template <class Read>
CLI::Option* add_read_option(CLI::App& verb, const std::string& name, const std::string& help, const std::string& type,
                             Read read) {
    return verb.add_option_function<std::string>(name, read, help)->type_name(type);
}

void add_ground_options(CLI::App& verb, ArrangeSettings& settings) {
    verb.add_option("--count", settings.count, "How many elements to grow; the canvas fits what is drawn")
        ->check(CLI::Range(std::size_t{1}, most_elements))
        ->type_name("N");
    verb.add_option("--region", settings.region,
                    "Grow inside the closed outlines of this drawing; one inside another is a hole")
        ->type_name("SVG");
    add_read_option(verb, "--spray", "Grow below a round brush that follows the lines of this drawing", "SVG,RADIUS",
                    [&settings](const std::string& text) { parse_spray(text, settings); });
    add_read_option(verb, "--size",
                    "Width and height of the canvas in px; without --count, --region and --spray it is filled", "W,H",
                    [&settings](const std::string& text) { settings.size = parse_size(text); });
    verb.add_option("--boundary", settings.boundary, "No element crosses the lines of this drawing")->type_name("SVG");
}

void add_mode_options(CLI::App& verb, ArrangeSettings& settings) {
    const std::map<std::string, RotationMode> modes{
        {"fixed", RotationMode::fixed}, {"rotate", RotationMode::rotate}, {"flow", RotationMode::flow}};
    CLI::Option* mode = verb.add_option("--mode", settings.growth.mode,
                                        "Elements keep their angles, turn to fit their neighbours best, or follow a flow")
                            ->transform(CLI::CheckedTransformer(modes).description(""))
                            ->type_name("fixed|rotate|flow");
    CLI::Option* flow = add_read_option(
        verb, "--flow", "The strokes of this drawing show the flow that the exemplar's x axis follows; means --mode flow",
        "SVG", [&settings, mode](const std::string& name) {
            settings.flow = name;
            if (mode->count() == 0) settings.growth.mode = RotationMode::flow;
        });
    verb.add_flag("--undirected", settings.undirected, "Strokes of the flow have neither beginning nor end")->needs(flow);
}

void add_exemplar_options(CLI::App& verb, ArrangeSettings& settings) {
    add_read_option(verb, "--element", "Whatever these symbols of the grammar draw is one element each", "SYMBOL,..",
                    [&settings](const std::string& text) { settings.raised = parse_list("--element", text); });
    CLI::Option* tile = verb.add_flag_callback(
        "--tile", [&settings] { settings.tile = true; },
        "The exemplar's canvas is a tile that repeats; without it, if the drawing looks so");
    verb.add_flag_callback(
            "--no-tile", [&settings] { settings.tile = false; }, "The exemplar's canvas is no tile, whatever it looks like")
        ->excludes(tile);
    add_read_option(verb, "--flip-edges",
                    "Neighbours to be exchanged in the exemplar: the other diagonal of the two triangles beside an edge; "
                    "elements as --numbering shows them",
                    "3-7,..", [&settings](const std::string& text) { settings.flips = parse_flips(text); });
    verb.add_option("--numbering", settings.numbering,
                    "Where to draw the exemplar's neighbours, its elements numbered (.svg)")
        ->type_name("FILE");
}

void add_matching_options(CLI::App& verb, ArrangeSettings& settings) {
    add_read_option(verb, "--priority", "Symbols that grow before others near by; all others have 0", "SYMBOL=N,..",
                    [&settings](const std::string& text) {
                        settings.priorities = parse_named_values(
                            {.option = "--priority", .low = -largest_priority, .high = largest_priority}, text);
                    });
    const std::map<std::string, RingMatching> matchings{{"nearest", RingMatching::nearest},
                                                        {"cyclic", RingMatching::cyclic}};
    verb.add_option("--matching", settings.growth.matching,
                    "Neighbours are compared with the nearest ones of the exemplar, or in turn as Ijiri et al. 2008 do")
        ->transform(CLI::CheckedTransformer(matchings).description(""))
        ->type_name("nearest|cyclic");
    add_read_option(
        verb, "--weights",
        "What counts in a comparison: distance, another symbol, the same element of the drawing as a neighbour (same) or "
        "near by (repeat), shares of symbols (balance); or paper: 1, 1, 100, 0, 0",
        "distance=..,..", [&settings](const std::string& text) { settings.growth.weights = parse_match_weights(text); });
    const std::map<std::string, bool> coherences{{"free", false}, {"copy", true}};
    verb.add_option("--coherence", settings.growth.two_rings, "Vary the exemplar, or copy its parts as closely as can be")
        ->transform(CLI::CheckedTransformer(coherences).description(""))
        ->type_name("free|copy");
    verb.add_flag_callback(
        "--no-relax", [&settings] { settings.growth.relax = false; }, "Do not even out distances");
    verb.add_flag_callback(
        "--no-finish", [&settings] { settings.growth.finish = false; }, "Do not repair an irregular arrangement at the end");
    add_read_option(
        verb, "--jitter",
        "Random turns up to so many degrees, sizes up to 1 + scale and down to 1 / (1 + scale), and colours (0 to 1)",
        "angle=..,scale=..,color=..", [&settings](const std::string& text) { settings.jitter = parse_jitter(text); });
}

void add_output_options(CLI::App& verb, ArrangeSettings& settings) {
    verb.add_option("-o,--output", settings.output,
                    "The picture (.svg, .png, .pdf) or a grammar of it (.lsys, .json); without it, SVG to standard output")
        ->type_name("FILE");
    verb.add_option("--connectivity", settings.connectivity, "Where to draw which elements are neighbours (.svg)")
        ->type_name("FILE");
    verb.add_option("--report", settings.report,
                    "Where to write how like the exemplar it is (.json, as docs/arrange_report.schema.json says)")
        ->type_name("FILE");
    verb.add_option("--seed", settings.growth.seed, "For what is random; the same seed gives the same bytes")
        ->capture_default_str()
        ->type_name("N");
    verb.add_option("--threads", settings.growth.threads,
                    "Threads; 0 = one per processor; the result is the same for any number")
        ->check(CLI::Range(0, most_threads))
        ->capture_default_str()
        ->type_name("N");
    verb.add_option("--seconds", settings.seconds, "Longest time of growth; what stands by then is written, exit status 3")
        ->check(number_between(0, longest_time))
        ->type_name("T");
}

void expect_svg(const std::string& option, const std::string& name) {
    if (format_of(name, FileFormat::svg) != FileFormat::svg)
        throw CLI::ValidationError(option, "expected a name that ends in .svg, found '" + name + "'");
    expect_writable(name);
}

}  // namespace

void add_arrange_options(CLI::App& verb, ArrangeSettings& settings) {
    verb.add_option("EXEMPLAR", settings.input,
                    "The example: a drawing (.svg, .svgz) or a grammar (.lsys, .json), or - for standard input")
        ->required();
    add_output_options(verb, settings);
    add_ground_options(verb, settings);
    add_mode_options(verb, settings);
    add_exemplar_options(verb, settings);
    add_matching_options(verb, settings);
}

void expect_consistent(const ArrangeSettings& settings) {
    expect_growth_output(settings.output);
    expect_svg("--connectivity", settings.connectivity);
    expect_svg("--numbering", settings.numbering);
    if (format_of(settings.report, FileFormat::json) != FileFormat::json)
        throw CLI::ValidationError("--report", "expected a name that ends in .json, found '" + settings.report + "'");
    expect_writable(settings.report);
    if (settings.growth.mode == RotationMode::flow && settings.flow.empty())
        throw CLI::ValidationError("--mode", "flow needs --flow with the strokes that show it");
    if (settings.growth.mode != RotationMode::flow && !settings.flow.empty())
        throw CLI::ValidationError("--flow", "is for --mode flow");
    if (!settings.region.empty() && settings.size)
        throw CLI::ValidationError("--size", "does not go with --region: the canvas is that of the region's drawing");
}

}  // namespace rinceau
