// Turtle interpretation (Stava et al. 2010, Table 1; mirror, style, layer and colours added).

#include "lsystem/interpret.h"

#include <algorithm>
#include <cmath>

#include "lsystem/expression_functions.h"
#include "lsystem/stream.h"

namespace rinceau {

namespace {

struct TurtleState {
    Similarity pose;
    int style = 0;
    int layer = 0;
    Repaint repaint;
};

/// Visit: void (Placement&), which may take the placement.
template <class Visit>
class Turtle {
  public:
    Turtle(const CompiledGrammar& grammar, const InterpretOptions& options, Visit visit)
        : grammar_(grammar), options_(options), visit_(visit) {}

    void command(const CompiledModule& module, std::span<const double> arguments) {
        const double argument = arguments.empty() ? 0 : arguments.front();
        switch (static_cast<TurtleCommand>(module.symbol)) {
            case TurtleCommand::left:
                turn(module.constant ? module.turn : turn_by(argument));
                break;
            case TurtleCommand::right:
                turn(module.constant ? module.turn : turn_by(-argument));
                break;
            case TurtleCommand::forward:
                state_.pose.translation += state_.pose.linear * flipped_if(state_.pose.mirrored, {0, argument});
                break;
            case TurtleCommand::scale:
                if (!(argument > 0)) fail(module, "expected a scale above 0", argument);
                state_.pose.linear = argument * state_.pose.linear;
                break;
            case TurtleCommand::mirror:
                state_.pose = state_.pose * mirror_about_heading();
                break;
            case TurtleCommand::push:
                stack_.push_back(state_);
                break;
            case TurtleCommand::pop:
                pop(module);
                break;
            case TurtleCommand::style:
                set_style(module, argument);
                break;
            case TurtleCommand::layer:
                raise(module, argument);
                break;
            case TurtleCommand::fill:
                state_.repaint.fill = color_of(arguments);
                break;
            case TurtleCommand::stroke:
                state_.repaint.stroke = color_of(arguments);
                break;
        }
    }

    void leaf(const CompiledModule& module, std::span<const double>, const StreamPlace& place) {
        const int terminal = grammar_.terminal_of[static_cast<std::size_t>(module.symbol)];
        if (terminal < 0) return;
        check_range(module);
        placement_.terminal = terminal;
        placement_.style = state_.style;
        placement_.repaint = state_.repaint;
        placement_.layer = state_.layer;
        placement_.pose = state_.pose;
        placement_.production = production_of(place);
        if (options_.addresses) {
            placement_.address.reserve(place.address_front.size() + 1);
            placement_.address = place.address_front;
            placement_.address.push_back(place.number);
        }
        if (options_.trails) {
            placement_.trail.reserve(place.trail_front.size() + 1);
            placement_.trail = place.trail_front;
            placement_.trail.push_back(place.occurrence);
        }
        visit_(placement_);
        ++placement_.order;
    }

    void exception(int) {}

    const Similarity& pose() const { return state_.pose; }

  private:
    /// What an exception draws belongs to the production that placed the module it replaces.
    static int production_of(const StreamPlace& place) {
        constexpr int axiom = -1;  // exceptions are below
        if (place.occurrence.production >= axiom) return place.occurrence.production;
        for (std::size_t k = place.trail_front.size(); k-- > 0;) {
            if (place.trail_front[k].production >= axiom) return place.trail_front[k].production;
        }
        return axiom;
    }

    const CompiledGrammar& grammar_;
    const InterpretOptions& options_;
    Visit visit_;
    TurtleState state_;
    std::vector<TurtleState> stack_;
    Placement placement_;  // the next one
    int known_style_ = 0;  // the style looked up last: a string changes style far more often than it meets a new one

    [[noreturn]] static void fail(const CompiledModule& module, const std::string& expected, double found) {
        throw InputError(module.source->place,
                         expected + " in " + module.source->symbol + "(..), found " + to_text(number_expression(found)));
    }

    /// Red, green and blue, brought to the nearest that there is; nothing if there are no numbers.
    static std::optional<Color> color_of(std::span<const double> arguments) {
        if (arguments.empty()) return std::nullopt;
        const auto channel = [](double value) {
            constexpr double brightest = 255;
            return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, brightest)));
        };
        return Color{channel(arguments[0]), channel(arguments[1]), channel(arguments[2])};
    }

    static Complex turn_by(double degrees) { return {cosine_of_degrees(degrees), sine_of_degrees(degrees)}; }

    void turn(Complex by) { state_.pose.linear = state_.pose.linear * flipped_if(state_.pose.mirrored, by); }

    void pop(const CompiledModule& module) {
        if (stack_.empty()) throw InputError(module.source->place, "expected '[' before this ']', found none");
        state_ = stack_.back();
        stack_.pop_back();
    }

    static bool is_whole(double value) {
        constexpr double largest = 1e9;  // fits an int
        return std::abs(value) <= largest && value == std::floor(value);
    }

    void set_style(const CompiledModule& module, double argument) {
        if (!is_whole(argument)) fail(module, "expected a whole number of a style", argument);
        const int number = static_cast<int>(argument);
        if (number != known_style_ && !grammar_.styles.contains(number)) {
            fail(module, "expected the number of a style of the grammar, or 0,", argument);
        }
        state_.style = known_style_ = number;
    }

    void raise(const CompiledModule& module, double argument) {
        if (!is_whole(argument) || !is_whole(argument + state_.layer))
            fail(module, "expected a whole number of layers", argument);
        state_.layer += static_cast<int>(argument);
    }

    void check_range(const CompiledModule& module) const {
        const Similarity& pose = state_.pose;
        const double size = norm(pose.linear);
        if (std::isfinite(size) && size > 0 && std::isfinite(pose.translation.x) && std::isfinite(pose.translation.y))
            return;
        throw InputError(module.source->place,
                         "expected " + module.source->symbol +
                             " at a finite place and scale, found the turtle beyond the range of numbers");
    }
};

/// A turtle that tells of its way.
template <class Placed>
class FollowedTurtle {
  public:
    FollowedTurtle(const CompiledGrammar& grammar, const InterpretOptions& options,
                   const std::function<void(const TurtleEvent&)>& visit, Placed placed)
        : turtle_(grammar, options, placed), visit_(visit) {}

    void command(const CompiledModule& module, std::span<const double> arguments) {
        turtle_.command(module, arguments);
        if (const std::optional<TurtleEventKind> kind = kind_of(static_cast<TurtleCommand>(module.symbol))) tell(*kind);
    }
    void leaf(const CompiledModule& module, std::span<const double> arguments, const StreamPlace& place) {
        turtle_.leaf(module, arguments, place);
    }
    void exception(int) {}
    void opened(const CompiledModule& module, std::span<const double>, int) {
        const bool goes_on = !open_.empty() && open_.back().symbol == module.symbol;
        open_.push_back({module.symbol, goes_on});
        if (!goes_on) tell(TurtleEventKind::opened);
    }
    void closed() {
        const bool went_on = open_.back().goes_on;
        open_.pop_back();
        if (!went_on) tell(TurtleEventKind::closed);
    }

  private:
    struct Open {
        Symbol symbol = 0;
        bool goes_on = false;
    };
    Turtle<Placed> turtle_;
    const std::function<void(const TurtleEvent&)>& visit_;
    std::vector<Open> open_;

    void tell(TurtleEventKind kind) { visit_({kind, turtle_.pose(), nullptr}); }

    static std::optional<TurtleEventKind> kind_of(TurtleCommand command) {
        switch (command) {
            case TurtleCommand::left:
            case TurtleCommand::right:
            case TurtleCommand::scale:
            case TurtleCommand::mirror:
                return TurtleEventKind::turned;
            case TurtleCommand::forward:
                return TurtleEventKind::moved;
            case TurtleCommand::push:
                return TurtleEventKind::pushed;
            case TurtleCommand::pop:
                return TurtleEventKind::popped;
            default:
                return std::nullopt;  // how what follows is painted is told with it
        }
    }
};

template <class Visit>
void walk(const Grammar& grammar, const InterpretOptions& options, const Progress& progress, Visit visit) {
    const CompiledGrammar compiled = compile(grammar, options.derive.seed);
    Turtle<Visit> turtle(compiled, options, visit);
    stream_modules(compiled, options.derive, progress, options.addresses || options.trails, turtle);
}

}  // namespace

std::vector<Placement> interpret(const Grammar& grammar, const InterpretOptions& options, const Progress& progress) {
    std::vector<Placement> placements;
    walk(grammar, options, progress, [&](Placement& placement) { placements.push_back(std::move(placement)); });
    if (!std::ranges::is_sorted(placements, {}, &Placement::layer))
        std::ranges::stable_sort(placements, {}, &Placement::layer);
    return placements;
}

void visit_placements(const Grammar& grammar, const InterpretOptions& options,
                      const std::function<void(const Placement&)>& visit, const Progress& progress) {
    walk(grammar, options, progress, [&](Placement& placement) { visit(placement); });
}

void visit_turtle(const Grammar& grammar, const InterpretOptions& options,
                  const std::function<void(const TurtleEvent&)>& visit, const Progress& progress) {
    const CompiledGrammar compiled = compile(grammar, options.derive.seed);
    const auto placed = [&](Placement& placement) { visit({TurtleEventKind::placed, placement.pose, &placement}); };
    FollowedTurtle turtle(compiled, options, visit, placed);
    stream_modules(compiled, options.derive, progress, options.addresses || options.trails, turtle);
}

}  // namespace rinceau
