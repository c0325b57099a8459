#pragma once
// Command strings of a shape grammar carried out on a surface: scopes move, shapes and lines are placed, what a collision
// culls is left out (Li et al. 2010, sections 3.4, 4.3 and 4.4).

#include <optional>
#include <vector>

#include "growth/surface/grown_lines.h"
#include "growth/surface/placed_shapes.h"
#include "growth/surface/scope_queries.h"
#include "growth/surface/shape_derivation_options.h"
#include "growth/surface/shape_expressions.h"
#include "growth/surface/shape_moves.h"
#include "growth/surface/shape_queue.h"

namespace rinceau {

/// What a derivation works with; all of it outlives the interpreter.
struct DerivationGround {
    const ShapeGrammar* grammar = nullptr;
    const CompiledShapeGrammar* compiled = nullptr;
    const SurfaceWorld* world = nullptr;
    ShapeDerivationOptions options;
    const FieldOnSurface* guide = nullptr;  ///< of translations
    std::vector<int> fields, shapes;        ///< by the grammar's numbers: those of the world
};

class ShapeInterpreter {
  public:
    explicit ShapeInterpreter(const DerivationGround& ground);

    /// Carries out an axiom's commands at a scope.
    void begin(const CompiledShapeAxiom& axiom, const ShapeScope& scope, DrawKey key);
    /// Takes the symbol that is next; there is one.
    void apply_next();

    const ShapeQueue& queue() const { return queue_; }
    const PlacedShapes& shapes() const { return placed_; }
    const GrownLines& lines() const { return lines_; }
    const PatternCounts& counts() const { return counts_; }
    /// By rule: how often it was applied.
    const std::vector<long>& applied() const { return applied_; }
    /// Rule whose Lock would not end, if one was given up for that.
    std::optional<int> endless_lock() const { return endless_lock_; }

  private:
    /// What became of a command.
    enum class Hit : unsigned char {
        none,
        inside,   ///< something in its own brackets was culled; what follows goes on
        omitted,  ///< a shape was not placed
        ended     ///< the way ended
    };
    using Commands = std::vector<CompiledShapeCommand>;
    /// The rule that a command string is of.
    struct Production {
        int rule = -1;
        int depth = 0;
        DrawKey key = 0;
        std::span<const double> arguments;
    };
    /// A Lock that is being derived, with how things were before.
    struct Set {
        int first = 0;  ///< number of its first shape
        std::size_t kin = 0;
        PatternCounts counts;
        ShapeQueue queue;
        bool failed = false;
        long rules = 0;
    };

    const DerivationGround* ground_;
    const SurfaceMesh* surface_;
    std::vector<bool> decisive_;
    std::vector<double> priority_;  ///< by symbol: the highest of its rules
    MoveGround moves_;
    ShapeKin kin_;
    PlacedShapes placed_;
    GrownLines lines_;
    ScopeQueries queries_;
    ShapeEvaluator evaluator_;
    ShapeQueue queue_;
    PatternCounts counts_;
    std::vector<long> applied_;
    std::optional<Set> set_;
    int set_number_ = 0;  ///< of the next Lock that stands
    std::optional<int> endless_lock_;
    int at_once_ = 0;  ///< symbols that are being derived where they stand, one in the other
    long sequence_ = 0;

    bool culls_nothing() const { return ground_->options.cull == CullScope::none; }
    bool is_over() const { return set_ && set_->failed; }

    /// None if no condition holds, or chance takes none.
    std::optional<int> choose_rule(const WaitingSymbol& symbol);
    Hit apply(WaitingSymbol symbol);

    Hit run(const Commands& commands, ShapeScope& scope, const Production& production);
    Hit carry_out(const CompiledShapeCommand& command, ShapeScope& scope, const Production& production);
    double number(const CompiledShapeCommand& command, std::size_t index, const ShapeScope& scope,
                  const Production& production);
    Hit move(const CompiledShapeCommand& command, ShapeScope& scope, const Production& production);
    Hit place(const CompiledShapeCommand& command, ShapeScope& scope, const Production& production);
    Hit draw_line(const CompiledShapeCommand& command, ShapeScope& scope, const Production& production);
    Hit lock(const CompiledShapeCommand& command, ShapeScope& scope, const Production& production);
    Hit chart(const CompiledShapeCommand& command, const ShapeScope& scope, const Production& production);
    Hit symbol(const CompiledShapeCommand& command, ShapeScope& scope, const Production& production);
    void set_size(const CompiledShapeCommand& command, ShapeScope& scope, const Production& production);
    void set_color(const CompiledShapeCommand& command, ShapeScope& scope, const Production& production);
    void set_attribute(const CompiledShapeCommand& command, ShapeScope& scope, const Production& production);
    bool merge_with_twin(const CompiledShapeCommand& command, ShapeScope& scope, const ScopeFrame& frame,
                         const Production& production);
    Hit border_met();
    void derive_set();
    [[noreturn]] void fail(const CompiledShapeCommand& command, const Production& production,
                           const std::string& message) const;
};

}  // namespace rinceau
