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
        const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, digits - 1);
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

void append_move(std::vector<ModuleTemplate>& modules, const Similarity& move, const MoveSlack& slack) {
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
    if (std::abs(step.scale - 1) > slack.scale) {
        modules.push_back(command("*", tidy(step.scale, slack.scale * step.scale)));
    }
    append_turn(modules, step.spin, slack.spin);
    if (step.mirrored) modules.push_back(command("|"));
}

std::vector<ModuleTemplate> bracketed(std::vector<ModuleTemplate> modules) {
    modules.insert(modules.begin(), command("["));
    modules.push_back(command("]"));
    return modules;
}

}  // namespace rinceau
