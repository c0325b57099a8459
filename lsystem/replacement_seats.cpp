#include "lsystem/replacement_seats.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

namespace rinceau {

namespace {

double largest_extent(const Measure& measure) { return std::max(diagonal(measure.box), abs(measure.move.translation)); }

/// No farther apart than `share` of a length.
bool near(const Similarity& a, const Similarity& b, double size, double share) {
    return a.mirrored == b.mirrored && abs(a.linear - b.linear) <= share * abs(b.linear) &&
           abs(a.translation - b.translation) <= share * size;
}

constexpr double rounding = 1e-12;  // of a turtle's way, in its length
constexpr double visible = 1e-5;    // of a fit, in the size of a thing

bool same_move(const Measure& a, const Measure& b, double size) {
    return near(a.move, b.move, size, rounding) && a.colouring == b.colouring && a.layer == b.layer;
}

ModuleTemplates move_modules(const Seat& seat) {
    if (same_move(seat.old, Measure{}, seat.size)) return {};
    ModuleTemplates string = turtle_modules(seat.old.move, seat.size, exact_digits);
    const auto numbers = [](std::initializer_list<int> values) {
        std::vector<Expression> expressions;
        for (const int value : values) expressions.push_back(number_expression(value));
        return expressions;
    };
    const auto paint = [&](const char* command, const std::optional<Color>& color) {
        if (color) string.push_back({command, numbers({color->red, color->green, color->blue}), {}});
    };
    const Colouring& colouring = seat.old.colouring;
    if (colouring.style != 0) string.push_back({";", numbers({colouring.style}), {}});
    paint("fill", colouring.repaint.fill);
    paint("stroke", colouring.repaint.stroke);
    if (seat.old.layer != 0) string.push_back({"z", numbers({seat.old.layer}), {}});
    return string;
}

void append(ModuleTemplates& string, const ModuleTemplates& part) { string.insert(string.end(), part.begin(), part.end()); }

}  // namespace

ModuleTemplate with_arguments(const std::string& symbol, const std::vector<double>& arguments) {
    ModuleTemplate module{symbol, {}, {}};
    for (const double value : arguments) module.arguments.push_back(number_expression(value));
    return module;
}

const Measure& OldMeasures::of(const std::vector<double>& arguments) {
    const auto found = known_.find(arguments);
    if (found != known_.end()) return found->second;
    constexpr std::size_t most = 256;
    if (known_.size() == most) {
        throw InputError({}, "expected at most " + std::to_string(most) + " sets of numbers with which " + symbol_ +
                                 " stands, found more: replace it at single addresses, or replace what it draws");
    }
    const ModuleTemplate module = with_arguments(symbol_, arguments);
    Measure measured = measure(grammar_, {module}, options_);
    if (draws_random_numbers(grammar_)) {
        DeriveOptions other = options_;
        constexpr std::uint64_t any_seeds[] = {7, 77};
        for (const std::uint64_t seed : any_seeds) {
            other.seed = seed;
            if (same_move(measured, measure(grammar_, {module}, other), largest_extent(measured))) continue;
            throw InputError({}, "expected " + symbol_ +
                                     " to move the turtle by the same way each time, found a way of random "
                                     "numbers, on which what stands behind it depends: put " +
                                     symbol_ + " in brackets, or replace what it draws");
        }
    }
    return known_.emplace(arguments, measured).first->second;
}

std::optional<Measure> OldMeasures::of(const ModuleTemplate& module) const {
    try {
        return measure(grammar_, {module}, options_);
    } catch (const InputError&) {
        return std::nullopt;  // its arguments are not known here
    }
}

ModuleTemplates content_string(const Content& content, const ModuleTemplate& module) {
    ModuleTemplates string = content.string;
    if (!content.given_arguments && content.arities.contains(module.arguments.size()) && string.size() == 1) {
        string.front().arguments = module.arguments;
    }
    return string;
}

Seat seat_of(const Grammar& grammar, const Content& content, const ModuleTemplate& module, const Measure& old,
             const ReplaceOptions& options) {
    Seat seat{.old = old};
    const bool is_drawing = content.outlines > 0;
    const ModuleTemplates string = content_string(content, module);
    const Measure measured = measure(grammar, string, options.derive);
    const Similarity turned = is_drawing ? Similarity{} : rotate(radians(options.turn));
    Box box = measured.box;
    if (!is_drawing && options.turn != 0) {
        ModuleTemplates turned_string = string;
        turned_string.insert(turned_string.begin(), {"+", {number_expression(options.turn)}, {}});
        box = measure(grammar, turned_string, options.derive).box;
    }
    const bool as_it_is = options.fit == ReplaceFit::none && !is_drawing;
    seat.map = (as_it_is ? Similarity{} : fitted(box, old.box, options.fit)) * turned;
    seat.size = std::max({largest_extent(old), largest_extent(measured), abs(seat.map.translation)});
    if (near(seat.map, {}, seat.size, visible)) seat.map = {};
    seat.same_move = seat.map == Similarity{} && same_move(measured, old, seat.size);
    return seat;
}

bool same_seat(const Seat& a, const Seat& b) {
    return near(a.map, b.map, std::max(a.size, b.size), visible) && same_move(a.old, b.old, std::max(a.size, b.size)) &&
           a.same_move == b.same_move;
}

ModuleTemplates without_colouring(const std::vector<Colouring>& in_force) {
    ModuleTemplates string;
    const auto any = [&](auto is_in_force) { return std::ranges::any_of(in_force, is_in_force); };
    if (any([](const Colouring& one) { return one.style != 0; })) string.push_back({";", {number_expression(0)}, {}});
    if (any([](const Colouring& one) { return one.repaint.fill.has_value(); })) string.push_back({"fill", {}, {}});
    if (any([](const Colouring& one) { return one.repaint.stroke.has_value(); })) string.push_back({"stroke", {}, {}});
    return string;
}

ModuleTemplates seated(const ModuleTemplates& content, const Seat& seat, const ModuleTemplates& before, bool last) {
    ModuleTemplates body;
    if (!content.empty()) {
        body = turtle_modules(seat.map, seat.size);
        append(body, before);
    }
    const bool bare = body.empty();
    append(body, content);
    if (last || (bare && seat.same_move)) return body;

    ModuleTemplates string;
    if (!content.empty()) {
        string.push_back({"[", {}, {}});
        append(string, body);
        string.push_back({"]", {}, {}});
    }
    append(string, move_modules(seat));
    return string;
}

}  // namespace rinceau
