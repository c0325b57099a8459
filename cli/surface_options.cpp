#include "cli/surface_options.h"

#include <cmath>
#include <filesystem>

#include "cli/messages.h"
#include "cli/named_values.h"
#include "files/files.h"
#include "growth/surface/surface_read.h"

namespace rinceau {
namespace {

[[noreturn]] void fail(const std::string& option, const std::string& expected, const std::string& found) {
    throw CLI::ValidationError(option, "expected " + expected + ", found '" + found + "'");
}

}  // namespace

std::vector<double> parse_numbers(const std::string& option, const std::string& expected, const std::string& text,
                                  std::size_t count) {
    std::vector<double> numbers;
    for (const std::string& part : parse_list(option, text)) numbers.push_back(parse_number(option, expected, part));
    if (numbers.size() != count) fail(option, expected, text);
    return numbers;
}

void add_repair_option(CLI::App& verb, bool& repair) {
    verb.add_flag("--repair", repair,
                  "Cut the surface apart where more than two faces meet, and turn faces that turn against their neighbours");
}

void add_plane_option(CLI::App& verb, std::optional<Point>& size, const std::string& help) {
    const auto parse = [&size](const std::string& text) {
        const std::string expected = "a width and a height above 0, up to 1000000, W,H";
        const std::vector<double> sides = parse_numbers("--size", expected, text, 2);
        constexpr double longest = 1e6, shortest = 1e-6;
        for (const double side : sides)
            if (!(side >= shortest && side <= longest)) fail("--size", expected, text);
        size = Point{sides[0], sides[1]};
    };
    verb.add_option_function<std::string>("--size", parse, help)->type_name("W,H");
}

void add_up_option(CLI::App& verb, UpAxis& up, const std::string& help) {
    add_choice<UpAxis>(verb, "--up", up, help, {{"y", UpAxis::y}, {"z", UpAxis::z}}, "y|z");
}

void add_view_option(CLI::App& verb, std::optional<LookFrom>& look, const std::string& help) {
    const auto parse = [&look](const std::string& text) {
        const std::string expected = "a turn and an elevation in degrees, TURN,ELEVATION, the elevation from -90 to 90";
        const std::vector<double> degrees = parse_numbers("--view", expected, text, 2);
        constexpr double straight = 90, most_turns = 1e6;
        if (!(std::abs(degrees[1]) <= straight && std::abs(degrees[0]) <= most_turns)) fail("--view", expected, text);
        look = LookFrom{degrees[0], degrees[1]};
    };
    verb.add_option_function<std::string>("--view", parse, help)->type_name("TURN,ELEVATION");
}

void expect_other_file(const std::string& option, const std::string& output, const std::vector<std::string>& inputs) {
    for (const std::string& input : inputs) {
        std::error_code missing;
        if (!std::filesystem::equivalent(output, input, missing) || missing) continue;
        throw CLI::ValidationError(
            option, "'" + output + "' is the input '" + input + "', which it would replace; give the output another name");
    }
}

SurfaceMesh read_surface_file(const std::string& name, bool repair, std::vector<std::string>& warnings) {
    SurfaceReading reading = read_surface(read_input(name), input_label(name), {.repair = repair, .mesh = {}});
    say_warnings(reading.warnings);
    for (const Warning& warning : reading.warnings) warnings.push_back(located(warning.place, warning.message));
    return std::move(reading.surface);
}

}  // namespace rinceau
