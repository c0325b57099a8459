// Li et al. 2010, sections 3.4, 4.3 and 4.4. Where the paper leaves a choice, or goes on further than it says:
// - A collision culls the rest of the command string inside its bracket: what stands behind the bracket goes on from a scope
//   that was saved before the shape that failed. The paper culls the rest of the string (cull = rule).
// - A symbol that can only place one thing is derived where it stands (decisive_symbols.h), so that its collision culls too.
// - A merged shape culls as well: its twin has already grown what would follow.
// - The parts of a Lock are tested against everything outside of it, not against each other. What comes from a Lock may
// touch
//   it as any shape may touch its ancestors, but not the parts of another Lock: those are patterns beside each other.
#include "growth/surface/shape_interpreter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/index.h"
#include "growth/surface/decisive_symbols.h"
#include "growth/surface/shape_palette.h"
#include "lsystem/number_text.h"

namespace rinceau {

namespace {

constexpr long most_rules_of_a_set = 100'000;
constexpr int most_shapes_of_a_set = 100'000;             // they are all looked at if they are all in one place
constexpr double least_size = 1e-15, largest_size = 1e9;  // of a scope, diagonals of the surface
constexpr int most_at_once = 100;  // symbols derived in each other where they stand: keeps the call stack small

template <class Visit>
void visit_commands(const std::vector<CompiledShapeCommand>& commands, const Visit& visit) {
    for (const CompiledShapeCommand& command : commands) {
        visit(command);
        for (const auto& group : command.groups) visit_commands(group, visit);
    }
}

template <class Visit>
void visit_commands(const CompiledShapeGrammar& grammar, const Visit& visit) {
    for (const CompiledShapeAxiom& axiom : grammar.axioms) visit_commands(axiom.commands, visit);
    for (const CompiledShapeRule& rule : grammar.rules) visit_commands(rule.successor, visit);
}

bool tests_collisions(const DerivationGround& ground) {
    bool tests = ground.options.collide_all;
    visit_commands(*ground.compiled, [&](const CompiledShapeCommand& command) {
        tests = tests || command.verb == ShapeVerb::place_clear || command.verb == ShapeVerb::lock;
    });
    return tests;
}

template <class Visit>
void visit_queries(const std::vector<ShapeProgram>& programs, const Visit& visit) {
    for (const ShapeProgram& program : programs)
        for (const ShapeQuery& query : program.queries) visit(query);
}

/// By the world's shapes: IM or near() look for them.
std::vector<bool> sought_shapes(const DerivationGround& ground) {
    std::vector<bool> sought(ground.world->shapes.size());
    const auto take = [&](const ShapeQuery& query) {
        if (query.about == ShapeQuery::About::near) sought[at(ground.shapes[at(query.shape)])] = true;
    };
    visit_commands(*ground.compiled, [&](const CompiledShapeCommand& command) {
        if (command.verb == ShapeVerb::place_merged) sought[at(ground.shapes[at(command.shape)])] = true;
        visit_queries(command.numbers, take);
    });
    for (const CompiledShapeRule& rule : ground.compiled->rules) {
        visit_queries(rule.condition, take);
        visit_queries(rule.probability, take);
    }
    return sought;
}

std::vector<double> highest_priorities(const CompiledShapeGrammar& grammar) {
    std::vector<double> highest(grammar.symbols.size());
    for (std::size_t symbol = 0; symbol < highest.size(); ++symbol) {
        const std::vector<int>& rules = grammar.symbols[symbol].rules;
        if (!rules.empty()) highest[symbol] = grammar.rules[at(rules.front())].priority;
        for (const int rule : rules) highest[symbol] = std::max(highest[symbol], grammar.rules[at(rule)].priority);
    }
    return highest;
}

/// The index of the ] that closes the bracket about commands[inside]; there is one.
std::size_t closing_bracket(const std::vector<CompiledShapeCommand>& commands, std::size_t inside) {
    int open = 0;
    for (std::size_t i = inside + 1;; ++i) {
        if (commands[i].verb == ShapeVerb::push) ++open;
        if (commands[i].verb == ShapeVerb::pop && open-- == 0) return i;
    }
}

}  // namespace

ShapeInterpreter::ShapeInterpreter(const DerivationGround& ground)
    : ground_(&ground),
      surface_(ground.world->surface.get()),
      decisive_(decisive_symbols(*ground.compiled)),
      priority_(highest_priorities(*ground.compiled)),
      moves_{surface_, ground.guide, ground.options.trace},
      placed_(ground.world->shapes, sought_shapes(ground), tests_collisions(ground), ground.options.touch),
      lines_(*surface_),
      queries_(*ground.world, ground.fields, ground.shapes, placed_, kin_),
      evaluator_(*ground.compiled),
      queue_(ground.options.breadth_first),
      applied_(ground.compiled->rules.size()) {}

void ShapeInterpreter::fail(const CompiledShapeCommand& command, const Production& production,
                            const std::string& message) const {
    std::string where = "in an axiom: ";
    if (production.rule >= 0) {
        const ShapeRule& rule = ground_->grammar->rules[at(production.rule)];
        where = "in rule '" + (rule.id.empty() ? rule.symbol : rule.id) + "': ";
    }
    throw InputError(command.source->place, where + message);
}

std::optional<int> ShapeInterpreter::choose_rule(const WaitingSymbol& symbol) {
    queries_.stand(symbol.scope, symbol.depth);
    std::vector<std::pair<int, double>> holding;
    double sum = 0;
    for (const int index : ground_->compiled->symbols[at(symbol.symbol)].rules) {
        const CompiledShapeRule& rule = ground_->compiled->rules[at(index)];
        if (!evaluator_.holds(rule, symbol.arguments, symbol.key, queries_)) continue;
        double weight = 1;
        if (!rule.probability.empty())
            weight = evaluator_.number(rule.probability.front(), symbol.arguments, symbol.key, queries_);
        if (weight < 0)
            throw InputError(rule.source->place, "expected a probability of at least 0 of rule '" + rule.source->symbol +
                                                     "', found " + number_text(weight));
        if (weight == 0) continue;
        holding.emplace_back(index, weight);
        sum += weight;
    }
    if (holding.empty()) return std::nullopt;
    // a rule alone may choose nothing, several share what there is
    const bool alone = holding.size() == 1;
    if (alone && sum >= 1) return holding.front().first;
    double rest = rule_draw(symbol.key) * (alone ? 1 : sum);
    for (const auto& [index, weight] : holding)
        if ((rest -= weight) < 0) return index;
    if (alone) return std::nullopt;
    return holding.back().first;
}

ShapeInterpreter::Hit ShapeInterpreter::apply(WaitingSymbol symbol) {
    if (symbol.rule < 0) {
        const std::optional<int> chosen = choose_rule(symbol);
        if (!chosen) return Hit::none;
        symbol.rule = *chosen;
    }
    const CompiledShapeRule& rule = ground_->compiled->rules[at(symbol.rule)];
    if (rule.priority < symbol.priority) {
        // another rule of the symbol would have come now; this one's turn is later
        symbol.priority = rule.priority;
        (set_ ? set_->queue : queue_).push(std::move(symbol));
        return Hit::none;
    }
    if (set_ && ++set_->rules > most_rules_of_a_set) {
        set_->failed = true;
        endless_lock_ = symbol.rule;
        return Hit::ended;
    }
    ++counts_.rules_applied;
    ++applied_[at(symbol.rule)];
    ShapeScope scope = std::move(symbol.scope);
    return run(rule.successor, scope, {symbol.rule, symbol.depth, symbol.key, symbol.arguments});
}

void ShapeInterpreter::begin(const CompiledShapeAxiom& axiom, const ShapeScope& scope, DrawKey key) {
    ShapeScope own = scope;
    run(axiom.commands, own, {-1, 0, key, {}});
}

void ShapeInterpreter::apply_next() { apply(queue_.pop()); }

ShapeInterpreter::Hit ShapeInterpreter::run(const Commands& commands, ShapeScope& scope, const Production& production) {
    Hit result = Hit::none;
    std::vector<ShapeScope> saved;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        if (commands[i].verb == ShapeVerb::push) {
            saved.push_back(scope);
            continue;
        }
        if (commands[i].verb == ShapeVerb::pop) {
            scope = std::move(saved.back());
            saved.pop_back();
            continue;
        }
        const Hit hit = carry_out(commands[i], scope, production);
        if (hit == Hit::none) continue;
        result = std::max(result, Hit::inside);
        if (is_over()) return Hit::ended;
        if (hit == Hit::inside || (hit == Hit::omitted && culls_nothing())) continue;
        if (saved.empty() || ground_->options.cull == CullScope::rule) return hit;
        i = closing_bracket(commands, i) - 1;
    }
    return result;
}

ShapeInterpreter::Hit ShapeInterpreter::carry_out(const CompiledShapeCommand& command, ShapeScope& scope,
                                                  const Production& production) {
    switch (command.verb) {
        case ShapeVerb::move:
        case ShapeVerb::go_straight:
            return move(command, scope, production);
        case ShapeVerb::size:
            set_size(command, scope, production);
            break;
        case ShapeVerb::turn_x:
            turn_about_x(scope, number(command, 0, scope, production));
            break;
        case ShapeVerb::turn_y:
            turn_about_y(scope, number(command, 0, scope, production));
            break;
        case ShapeVerb::turn_z:
            turn_about_z(scope, number(command, 0, scope, production));
            break;
        case ShapeVerb::place:
        case ShapeVerb::place_clear:
        case ShapeVerb::place_merged:
            return place(command, scope, production);
        case ShapeVerb::lock:
            return lock(command, scope, production);
        case ShapeVerb::chart:
            return chart(command, scope, production);
        case ShapeVerb::line:
            scope.line_merges = number(command, 0, scope, production) != 0;
            scope.line = -1;
            break;
        case ShapeVerb::line_segment:
            return draw_line(command, scope, production);
        case ShapeVerb::colour:
            set_color(command, scope, production);
            break;
        case ShapeVerb::attribute:
            set_attribute(command, scope, production);
            break;
        case ShapeVerb::symbol:
            return symbol(command, scope, production);
        case ShapeVerb::push:
        case ShapeVerb::pop:
            break;
    }
    return Hit::none;
}

double ShapeInterpreter::number(const CompiledShapeCommand& command, std::size_t index, const ShapeScope& scope,
                                const Production& production) {
    queries_.stand(scope, production.depth);
    return evaluator_.number(command.numbers[index], production.arguments, production.key, queries_);
}

ShapeInterpreter::Hit ShapeInterpreter::border_met() {
    ++counts_.borders_met;
    if (set_) set_->failed = true;
    return Hit::ended;
}

ShapeInterpreter::Hit ShapeInterpreter::move(const CompiledShapeCommand& command, ShapeScope& scope,
                                             const Production& production) {
    const Complex way{number(command, 0, scope, production), number(command, 1, scope, production)};
    scope.offset += number(command, 2, scope, production);
    const bool straight = command.verb == ShapeVerb::go_straight;
    return walk(moves_, scope, way, straight, false, counts_).at_border ? border_met() : Hit::none;
}

void ShapeInterpreter::set_size(const CompiledShapeCommand& command, ShapeScope& scope, const Production& production) {
    const SpacePoint size{number(command, 0, scope, production), number(command, 1, scope, production),
                          number(command, 2, scope, production)};
    const double diagonal = surface_->diagonal;
    const auto fits = [&](double length) { return length >= least_size * diagonal && length <= largest_size * diagonal; };
    if (!(fits(size.x) && fits(size.y) && fits(size.z)))
        fail(command, production,
             "expected sizes above 0, up to 1e9 diagonals of the surface, found " + number_text(size.x) + ", " +
                 number_text(size.y) + ", " + number_text(size.z));
    scope.size = size;
}

void ShapeInterpreter::set_color(const CompiledShapeCommand& command, ShapeScope& scope, const Production& production) {
    if (command.has_colour) {
        scope.color = std::make_shared<const Color>(command.colour);
    } else if (command.numbers.size() == 1) {
        scope.color = std::make_shared<const Color>(palette_color(number(command, 0, scope, production)));
    } else {
        scope.color = std::make_shared<const Color>(color_of_channels(number(command, 0, scope, production),
                                                                      number(command, 1, scope, production),
                                                                      number(command, 2, scope, production)));
    }
}

void ShapeInterpreter::set_attribute(const CompiledShapeCommand& command, ShapeScope& scope, const Production& production) {
    auto attributes = scope.attributes ? *scope.attributes : std::map<std::string, double>{};
    attributes[command.source->text] = number(command, 0, scope, production);
    scope.attributes = std::make_shared<const std::map<std::string, double>>(std::move(attributes));
}

bool ShapeInterpreter::merge_with_twin(const CompiledShapeCommand& command, ShapeScope& scope, const ScopeFrame& frame,
                                       const Production& production) {
    const double distance = number(command, 0, scope, production), angle = number(command, 1, scope, production);
    if (distance < 0) fail(command, production, "expected a distance of at least 0, found " + number_text(distance));
    const auto twin = placed_.twin(ground_->shapes[at(command.shape)], frame, distance, angle);
    if (!twin) return false;
    ++counts_.merged_points;
    lines_.end_at(scope, twin->scope->at);
    scope.at = twin->scope->at;
    scope.x = twin->scope->x;
    scope.offset = twin->scope->offset;
    scope.tilt = twin->scope->tilt;
    scope.tilted = twin->scope->tilted;
    scope.chart.reset();
    scope.kin = kin_.with(scope.kin, twin->placed);
    return true;
}

ShapeInterpreter::Hit ShapeInterpreter::place(const CompiledShapeCommand& command, ShapeScope& scope,
                                              const Production& production) {
    const ScopeFrame frame = frame_in_space(*surface_, scope);
    const bool merges = command.verb == ShapeVerb::place_merged;
    if (merges && merge_with_twin(command, scope, frame, production)) return Hit::omitted;
    if (set_ && placed_.size() - set_->first >= most_shapes_of_a_set)
        fail(command, production, "expected at most " + std::to_string(most_shapes_of_a_set) + " shapes in one Lock");
    PatternShape shape;
    shape.shape = ground_->shapes[at(command.shape)];
    shape.position = frame.position;
    shape.axes = frame.axes;
    shape.size = scope.size;
    shape.at = scope.at;
    shape.color = scope.color ? *scope.color : ground_->world->shapes[at(shape.shape)].color;
    shape.rule = production.rule;
    shape.depth = production.depth;
    shape.tested = command.verb == ShapeVerb::place_clear || set_ || ground_->options.collide_all;
    if (scope.attributes) shape.attributes = *scope.attributes;
    std::vector<int> kin = kin_.last(scope.kin, std::max(1, ground_->options.kin));
    shape.parent = kin.empty() ? -1 : kin.front();
    shape.set = set_ ? set_number_ : -1;
    const int end = set_ ? set_->first : placed_.size();
    kin.resize(std::min(kin.size(), at(ground_->options.kin)));
    if (set_) std::erase_if(kin, [&](int ancestor) { return placed_.placed()[at(ancestor)].set >= 0; });
    if (shape.tested && placed_.overlaps(shape, frame, kin, end)) {
        ++counts_.collisions_avoided;
        if (set_) set_->failed = true;
        return Hit::omitted;
    }
    scope.kin = kin_.with(scope.kin, placed_.add(std::move(shape), frame, scope));
    return Hit::none;
}

ShapeInterpreter::Hit ShapeInterpreter::draw_line(const CompiledShapeCommand& command, ShapeScope& scope,
                                                  const Production& production) {
    const double length = number(command, 0, scope, production), width = number(command, 1, scope, production);
    if (length < 0 || width <= 0 || width > largest_size * surface_->diagonal)
        fail(command, production,
             "expected a length of at least 0 and a width above 0, up to 1e9 diagonals of the surface, found " +
                 number_text(length) + ", " + number_text(width));
    const ScopeWalk way = walk(moves_, scope, {length, 0}, false, true, counts_);
    const LinePen pen{scope.line_merges, width, scope.color ? *scope.color : Color{204, 204, 204}};
    if (lines_.draw(scope, way.path, pen)) {
        ++counts_.merged_lines;
        return Hit::ended;
    }
    return way.at_border ? border_met() : Hit::none;
}

ShapeInterpreter::Hit ShapeInterpreter::chart(const CompiledShapeCommand& command, const ShapeScope& scope,
                                              const Production& production) {
    ShapeScope inside = scope;
    begin_chart(inside);
    const Hit hit = run(command.groups.front(), inside, production);
    if (hit == Hit::none || ground_->options.cull == CullScope::rule) return hit;
    return Hit::inside;
}

ShapeInterpreter::Hit ShapeInterpreter::symbol(const CompiledShapeCommand& command, ShapeScope& scope,
                                               const Production& production) {
    WaitingSymbol begun;
    begun.symbol = command.symbol;
    begun.arguments.reserve(command.numbers.size());
    for (std::size_t i = 0; i < command.numbers.size(); ++i)
        begun.arguments.push_back(number(command, i, scope, production));
    begun.scope = scope;
    begun.priority = priority_[at(command.symbol)];
    begun.depth = production.depth + 1;
    begun.sequence = sequence_++;
    begun.key = key_of_child(production.key, command.ordinal);
    if (!decisive_[at(command.symbol)] || at_once_ == most_at_once) {
        (set_ ? set_->queue : queue_).push(std::move(begun));
        return Hit::none;
    }
    begun.priority = 0;  // at once, whichever of its rules it takes
    const int first = placed_.size();
    ++at_once_;
    const Hit hit = apply(std::move(begun));
    --at_once_;
    const bool omitted = hit == Hit::inside ? placed_.size() == first : hit != Hit::none;
    for (int number = std::max(first, placed_.size() - ground_->options.kin); number < placed_.size(); ++number)
        scope.kin = kin_.with(scope.kin, number);
    return omitted ? Hit::omitted : Hit::none;
}

/// All symbols that its parts began, at once.
void ShapeInterpreter::derive_set() {
    while (!set_->queue.is_empty() && !set_->failed) apply(set_->queue.pop());
}

ShapeInterpreter::Hit ShapeInterpreter::lock(const CompiledShapeCommand& command, ShapeScope& scope,
                                             const Production& production) {
    const bool outermost = !set_;
    if (outermost) {
        set_ = Set{placed_.size(), kin_.links.size(), counts_, ShapeQueue(ground_->options.breadth_first), false, 0};
        lines_.begin_set();
    }
    const int first = placed_.size();
    for (const Commands& part : command.groups) {
        ShapeScope own = scope;
        if (!is_over()) run(part, own, production);
    }
    if (!outermost) return is_over() ? Hit::omitted : Hit::none;

    derive_set();
    const Set set = *std::exchange(set_, std::nullopt);
    if (set.failed) {
        placed_.remove_from(set.first);
        lines_.drop_set();
        kin_.links.resize(set.kin);
        const PatternCounts done = std::exchange(counts_, set.counts);
        counts_.rules_applied = done.rules_applied;
        ++counts_.locks_given_up;
        return Hit::omitted;
    }
    lines_.keep_set();
    ++set_number_;
    for (int number = std::max(first, placed_.size() - ground_->options.kin); number < placed_.size(); ++number)
        scope.kin = kin_.with(scope.kin, number);
    return Hit::none;
}

}  // namespace rinceau
