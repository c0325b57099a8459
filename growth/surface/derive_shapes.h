#pragma once
// A shape grammar's derivation on a surface (Li et al. 2010, sections 3.2, 4.3 and 4.4).

#include <memory>

#include "geometry/progress.h"
#include "growth/surface/shape_derivation_options.h"
#include "growth/surface/surface_pattern.h"
#include "growth/surface/surface_world.h"

namespace rinceau {

/// Grows all axioms. Options of the grammar (option name = value) have been taken over before, see options_of(). Throws
/// InputError, with rule and line, for sizes that are not positive, numbers that are not finite, unknown symbols, shapes and
/// fields. A bound that is reached leaves the pattern with complete = false.
SurfacePattern derive_shapes(const ShapeGrammar& grammar, const SurfaceWorld& world,
                             const ShapeDerivationOptions& options = {}, const Progress& progress = {});

/// The same in steps, for a window that shows how it grows. Keeps copies of what it is made from. The pattern does not
/// depend on how many rules a step takes.
class ShapeDerivation {
  public:
    ShapeDerivation(const ShapeGrammar& grammar, const SurfaceWorld& world, const ShapeDerivationOptions& options = {});
    ~ShapeDerivation();
    ShapeDerivation(ShapeDerivation&&) noexcept;
    ShapeDerivation& operator=(ShapeDerivation&&) noexcept;

    /// Applies up to `rules` rules; throws as derive_shapes() does.
    void step(long rules, const Progress& progress = {});
    /// Nothing is left to do, or a bound was reached.
    bool done() const;
    long rules_applied() const;
    int shapes() const;
    /// What has grown until now; if it is not done, complete is false.
    SurfacePattern pattern() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rinceau
