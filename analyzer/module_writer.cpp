#include "analyzer/module_writer.h"

#include <array>
#include <charconv>
#include <cmath>

#include "lsystem/turtle_step.h"

namespace rinceau {

double tidy(double value, double slack) {
    if (!(slack > 0) || !std::isfinite(value)) return value;
    if (std::abs(value) <= slack) return 0;
    constexpr int most_digits = 17;
    for (int digits = 1; digits < most_digits; ++digits) {
        std::array<char, 64> text{};
        const auto end =
            std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, digits - 1);
        double rounded = value;
        std::from_chars(text.data(), end.ptr, rounded);
        if (std::abs(rounded - value) <= slack) return rounded;
    }
    return value;
}

ModuleTemplate command(std::string symbol) { return {std::move(symbol), {}, {}}; }

ModuleTemplate command(std::string symbol, double argument) {
    return {std::move(symbol), {number_expression(argument)}, {}};
}

ModuleTemplate command(std::string symbol, const std::string& expression) {
    return {std::move(symbol), {parse_expression(expression)}, {}};
}

void append_turn(std::vector<ModuleTemplate>& modules, double angle, double slack) {
    const double in_degrees = tidy(degrees(wrap_angle(angle)), degrees(slack));
    if (in_degrees > 0) modules.push_back(command("+", in_degrees));
    if (in_degrees < 0) modules.push_back(command("-", -in_degrees));
}

namespace {

constexpr std::size_t odd_angle = 4;  // an angle that is no multiple of 15 degrees reads like so many more digits

/// What a reader has to take in: digits and signs of all arguments, and the commands.
std::size_t reading_length(const std::vector<ModuleTemplate>& modules) {
    std::size_t length = 0;
    for (const ModuleTemplate& module : modules) {
        length += 2;
        const bool turns = module.symbol == "+" || module.symbol == "-";
        for (const Expression& argument : module.arguments) {
            const double value = argument.postfix.front().number;
            length += to_text(argument).size() + (turns && std::fmod(value, 15) != 0 ? odd_angle : 0);
        }
    }
    return length;
}

void append_scale(std::vector<ModuleTemplate>& modules, double scale, double slack) {
    if (std::abs(scale - 1) > slack) modules.push_back(command("*", tidy(scale, slack * scale)));
}

std::vector<ModuleTemplate> polar_move(const Similarity& move, const MoveSlack& slack) {
    std::vector<ModuleTemplate> modules;
    TurtleStep step = to_turtle_step(move, slack.length);
    double advance = tidy(step.advance, slack.length);
    if (pi - std::abs(step.turn) <= slack.turn) {
        step.spin = wrap_angle(step.turn + step.spin);
        step.turn = 0;
        advance = -advance;
    }
    if (advance != 0) {
        append_turn(modules, step.turn, slack.turn);
        modules.push_back(command("f", advance));
    } else {
        step.spin = wrap_angle(step.turn + step.spin);
    }
    append_scale(modules, step.scale, slack.scale);
    append_turn(modules, step.spin, slack.spin);
    if (step.mirrored) modules.push_back(command("|"));
    return modules;
}

/// Along the heading, then sideways.
std::vector<ModuleTemplate> straight_move(const Similarity& move, const MoveSlack& slack) {
    std::vector<ModuleTemplate> modules;
    const TurtleStep step = to_turtle_step(move, slack.length);
    const double ahead = tidy(move.translation.y, slack.length), right = tidy(move.translation.x, slack.length);
    double spin = step.turn + step.spin;
    if (ahead != 0) modules.push_back(command("f", ahead));
    if (right != 0) {
        append_turn(modules, -pi / 2, 0);
        modules.push_back(command("f", right));
        spin += pi / 2;
    }
    append_scale(modules, step.scale, slack.scale);
    append_turn(modules, spin, slack.spin);
    if (step.mirrored) modules.push_back(command("|"));
    return modules;
}

}  // namespace

void append_move(std::vector<ModuleTemplate>& modules, const Similarity& move, const MoveSlack& slack) {
    const std::vector<ModuleTemplate> polar = polar_move(move, slack), straight = straight_move(move, slack);
    const std::vector<ModuleTemplate>& shorter = reading_length(straight) < reading_length(polar) ? straight : polar;
    modules.insert(modules.end(), shorter.begin(), shorter.end());
}

std::vector<ModuleTemplate> bracketed(std::vector<ModuleTemplate> modules) {
    modules.insert(modules.begin(), command("["));
    modules.push_back(command("]"));
    return modules;
}

}  // namespace rinceau
