#pragma once
// What rules ask of the place where they stand (Li et al. 2010, section 4.3.2).

#include <map>
#include <optional>

#include "growth/surface/placed_shapes.h"
#include "growth/surface/shape_queries.h"
#include "growth/surface/surface_world.h"

namespace rinceau {

/// Answers for one scope after the other.
class ScopeQueries : public QuerySource {
  public:
    /// All outlive it. `fields` and `shapes`: by the grammar's numbers, those of the world.
    ScopeQueries(const SurfaceWorld& world, std::vector<int> fields, std::vector<int> shapes, const PlacedShapes& placed,
                 const ShapeKin& kin)
        : world_(&world), fields_(std::move(fields)), shapes_(std::move(shapes)), placed_(&placed), kin_(&kin) {}

    /// What is asked from now on is asked at this scope, until it changes.
    void stand(const ShapeScope& scope, int depth) {
        scope_ = &scope;
        depth_ = depth;
        frame_.reset();
    }
    double answer(const ShapeQuery& query) override;

  private:
    const SurfaceWorld* world_;
    std::vector<int> fields_, shapes_;
    const PlacedShapes* placed_;
    const ShapeKin* kin_;
    const ShapeScope* scope_ = nullptr;
    int depth_ = 0;
    std::optional<ScopeFrame> frame_;       ///< made when it is asked for
    std::map<int, PlacedPoints> singular_;  ///< by the grammar's field, made when they are asked for

    const ScopeFrame& frame();
    double near(int shape);
    double of_field(const ShapeQuery& query);
    double from_picture(const FieldOnSurface& field, FieldQuantity quantity);
    double to_singular_point(int number, const FieldOnSurface& field);
};

}  // namespace rinceau
