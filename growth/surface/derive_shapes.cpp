// Li et al. 2010, section 3.2: a symbol is taken, a rule chosen, its successor carried out, until no symbol is left. The
// queue replaces the paper's set of active shapes; axioms behind the first begin when it is empty, so that they fill what is
// left.
#include "growth/surface/derive_shapes.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "growth/surface/axiom_places.h"
#include "growth/surface/shape_interpreter.h"
#include "lsystem/number_text.h"

namespace rinceau {

namespace {

// Who waits for progress is told after so many rules, or when they take longer: a way may lead round the surface many times.
constexpr long rules_between_looks = 256;
constexpr std::chrono::milliseconds longest_between_looks{50};

/// By the grammar's sources: the index of the one that has its name.
template <class Named>
std::vector<int> numbers_in(const std::vector<Named>& world, const std::vector<ShapeSource>& sources, const char* what) {
    std::vector<int> numbers;
    for (const ShapeSource& source : sources) {
        const auto found = std::ranges::find(world, source.name, &Named::name);
        if (found == world.end())
            throw InputError(source.place, std::string("the ") + what + " '" + source.name + "' has not been made");
        numbers.push_back(static_cast<int>(found - world.begin()));
    }
    return numbers;
}

const FieldOnSurface* guide_of(const SurfaceWorld& world, const ShapeGrammar& grammar, const std::string& name) {
    if (name == "none" || (name.empty() && world.fields.empty())) return nullptr;
    if (name.empty()) return world.fields.front().field.get();
    const auto found = std::ranges::find(world.fields, name, &WorldField::name);
    if (found != world.fields.end()) return found->field.get();
    const auto option = grammar.options.find("follow");
    throw InputError(option == grammar.options.end() ? SourcePlace{grammar.file_name} : option->second.place,
                     "expected a field for the option 'follow', found '" + name + "'");
}

}  // namespace

struct ShapeDerivation::State {
    ShapeGrammar grammar;
    SurfaceWorld world;
    CompiledShapeGrammar compiled;
    DerivationGround ground;
    std::optional<ShapeInterpreter> interpreter;
    std::size_t next_axiom = 0;
    std::string limit;
    std::chrono::steady_clock::duration spent{};

    State(const ShapeGrammar& g, const SurfaceWorld& w, const ShapeDerivationOptions& options) : grammar(g), world(w) {
        compiled = compile_shape_grammar(grammar, grammar_setting(*world.surface, options.seed));
        ground = {&grammar,
                  &compiled,
                  &world,
                  options,
                  guide_of(world, grammar, options.follow),
                  numbers_in(world.fields, grammar.fields, "field"),
                  numbers_in(world.shapes, grammar.shapes, "shape")};
        interpreter.emplace(ground);
    }

    bool done() const { return !limit.empty() || (interpreter->queue().is_empty() && next_axiom == compiled.axioms.size()); }
    /// `start`: of the step that it is a part of.
    void begin_axiom(std::chrono::steady_clock::time_point start);
    bool within_bounds(std::chrono::steady_clock::duration time);
    void stop(const std::string& reached, const std::string& cure);
    double share_done() const;
};

void ShapeDerivation::State::begin_axiom(std::chrono::steady_clock::time_point start) {
    const auto index = next_axiom++;
    const CompiledShapeAxiom& axiom = compiled.axioms[index];
    const FieldOnSurface* field = nullptr;
    if (axiom.field >= 0)
        field = world.fields[static_cast<std::size_t>(ground.fields[static_cast<std::size_t>(axiom.field)])].field.get();
    const DrawKey key = key_of_child(compiled.root, static_cast<int>(index));
    int number = 0;
    for (const AxiomPlace& place : axiom_places(axiom, *world.surface, ground.guide, field, key)) {
        ShapeScope scope;
        scope.at = place.at;
        scope.x = place.x;
        interpreter->begin(axiom, scope, key_of_child(key, number++));
        if (!within_bounds(std::chrono::steady_clock::now() - start)) return;
    }
}

/// Names the rule that was applied most: the one that grows without end, if one does.
void ShapeDerivation::State::stop(const std::string& reached, const std::string& cure) {
    limit = "the derivation was ended at " + reached;
    const std::vector<long>& applied = interpreter->applied();
    if (const auto most = std::ranges::max_element(applied); most != applied.end() && *most > 0) {
        const ShapeRule& rule = grammar.rules[static_cast<std::size_t>(most - applied.begin())];
        limit += "; the rule '" + (rule.id.empty() ? rule.symbol : rule.id) + "'";
        if (rule.place.line > 0) limit += " of line " + std::to_string(rule.place.line);
        limit += " was applied most, " + std::to_string(*most) + " times: give it a condition that ends it, or " + cure;
    } else {
        limit += ": " + cure;
    }
}

bool ShapeDerivation::State::within_bounds(std::chrono::steady_clock::duration time) {
    const ShapeDerivationOptions& options = ground.options;
    const long things = interpreter->shapes().size() + interpreter->queue().size() + interpreter->lines().points();
    if (things > options.max_shapes)
        stop(std::to_string(options.max_shapes) + " shapes and waiting symbols", "allow more shapes (option max_shapes)");
    else if (interpreter->counts().rules_applied >= options.max_rules && !done())
        stop(std::to_string(options.max_rules) + " rules", "allow more rules (option max_rules)");
    else if (options.max_seconds > 0 && std::chrono::duration<double>(spent + time).count() > options.max_seconds)
        stop(number_text(options.max_seconds) + " seconds", "allow more seconds (option max_seconds)");
    else if (const auto rule = interpreter->endless_lock())
        stop("a Lock whose symbols do not come to an end ('" + grammar.rules[static_cast<std::size_t>(*rule)].symbol + "')",
             "keep endless growth out of Lock");
    return limit.empty();
}

double ShapeDerivation::State::share_done() const {
    const auto applied = static_cast<double>(interpreter->counts().rules_applied);
    return applied / std::max(1.0, applied + static_cast<double>(interpreter->queue().size()));
}

ShapeDerivation::ShapeDerivation(const ShapeGrammar& grammar, const SurfaceWorld& world,
                                 const ShapeDerivationOptions& options)
    : state_(std::make_unique<State>(grammar, world, options)) {}
ShapeDerivation::~ShapeDerivation() = default;
ShapeDerivation::ShapeDerivation(ShapeDerivation&&) noexcept = default;
ShapeDerivation& ShapeDerivation::operator=(ShapeDerivation&&) noexcept = default;

bool ShapeDerivation::done() const { return state_->done(); }
long ShapeDerivation::rules_applied() const { return state_->interpreter->counts().rules_applied; }
int ShapeDerivation::shapes() const { return state_->interpreter->shapes().size(); }

void ShapeDerivation::step(long rules, const Progress& progress) {
    using Clock = std::chrono::steady_clock;
    State& state = *state_;
    const Clock::time_point start = Clock::now();
    const long end = rules_applied() + std::min(rules, std::numeric_limits<long>::max() - rules_applied());
    Clock::time_point last_look = start;
    for (long taken = 0; !state.done() && rules_applied() < end; ++taken) {
        if (state.interpreter->queue().is_empty()) {
            state.begin_axiom(start);
        } else {
            state.interpreter->apply_next();
        }
        const Clock::time_point now = Clock::now();
        if (taken % rules_between_looks == 0 || now - last_look > longest_between_looks) {
            report(progress, "growing", state.share_done());
            last_look = now;
        }
        state.within_bounds(now - start);
    }
    state.spent += Clock::now() - start;
}

SurfacePattern ShapeDerivation::pattern() const {
    SurfacePattern pattern;
    pattern.shapes = state_->world.shapes;
    pattern.placed = state_->interpreter->shapes().placed();
    pattern.lines = state_->interpreter->lines().lines();
    pattern.counts = state_->interpreter->counts();
    pattern.complete = state_->limit.empty() && done();
    pattern.limit = state_->limit;
    return pattern;
}

SurfacePattern derive_shapes(const ShapeGrammar& grammar, const SurfaceWorld& world, const ShapeDerivationOptions& options,
                             const Progress& progress) {
    ShapeDerivation derivation(grammar, world, options);
    const long all = std::numeric_limits<long>::max();
    derivation.step(options.steps < 0 ? all : options.steps, progress);
    return derivation.pattern();
}

}  // namespace rinceau
