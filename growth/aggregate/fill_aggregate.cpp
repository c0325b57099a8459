// The procedures of Sakurai & Miyata 2014 (section 3.2: darts; section 4: gaps) as one machine that makes one try at a time.

#include "growth/aggregate/fill_aggregate.h"

#include <algorithm>

#include "geometry/random.h"
#include "growth/aggregate/pack_check.h"
#include "growth/aggregate/region_grid.h"
#include "growth/aggregate/shape_turn.h"
#include "scene/input_error.h"

namespace rinceau {

struct AggregateFill::State {
    State(const std::vector<ExclusiveRegion>& shapes, const PackDomain& where, const AggregateOptions& how,
          const std::string& label)
        : regions(shapes),
          domain(where),
          options(how),
          turn(checked_shares(shapes, where, how, label), how.share_tolerance),
          grid(shapes, where, how.min_scale, how.max_scale),
          random(how.seed) {}

    bool try_once();

    std::vector<ExclusiveRegion> regions;
    PackDomain domain;
    AggregateOptions options;
    ShapeTurn turn;
    RegionGrid grid;
    Random random;
    AggregateCounts counts;
    std::size_t cancelled_in_row = 0;
    double furthest = 0;
    bool done = false;
};

bool AggregateFill::State::try_once() {
    const std::size_t stop = options.stop > 0 ? options.stop : 10'000;
    if (grid.placed().size() >= options.max_count || cancelled_in_row >= stop) return false;
    const int shape = turn.next();
    const Box box = domain.region ? bounds(*domain.region) : domain.box;
    const double angle = options.angles.only.empty()
                             ? random.uniform(options.angles.low, options.angles.high)
                             : options.angles.only[random.below(static_cast<std::uint32_t>(options.angles.only.size()))];
    const Point at{random.uniform(box.low.x, box.high.x), random.uniform(box.low.y, box.high.y)};
    const Similarity pose{polar(random.uniform(options.min_scale, options.max_scale), angle), at};
    ++counts.attempted;
    ++counts.tested;
    if (grid.is_free(shape, pose)) {
        grid.place({shape, pose});
        turn.placed(shape);
        cancelled_in_row = 0;
    } else {
        ++counts.cancelled;
        ++cancelled_in_row;
        turn.cancelled();
    }
    furthest = std::max(furthest, static_cast<double>(cancelled_in_row) / static_cast<double>(stop));
    return true;
}

AggregateFill::AggregateFill(std::vector<ExclusiveRegion> regions, PackDomain domain, AggregateOptions options,
                             const std::string& label)
    : state_(std::make_unique<State>(regions, domain, options, label)) {}
AggregateFill::~AggregateFill() = default;
AggregateFill::AggregateFill(AggregateFill&&) noexcept = default;
AggregateFill& AggregateFill::operator=(AggregateFill&&) noexcept = default;

bool AggregateFill::step(std::size_t tries) {
    for (std::size_t i = 0; i < tries && !state_->done; ++i) state_->done = !state_->try_once();
    return !state_->done;
}
double AggregateFill::fraction() const { return state_->done ? 1 : state_->furthest; }
const std::vector<PlacedRegion>& AggregateFill::placed() const { return state_->grid.placed(); }
const AggregateCounts& AggregateFill::counts() const { return state_->counts; }

Aggregate fill_aggregate(const std::vector<ExclusiveRegion>& regions, const PackDomain& domain,
                         const AggregateOptions& options, const std::string& label, const std::function<bool()>& stop,
                         const Progress& progress) {
    constexpr std::size_t tries_between_reports = 256;
    AggregateFill fill(regions, domain, options, label);
    bool complete = true;
    while (fill.step(tries_between_reports)) {
        report(progress, "filling", fill.fraction());
        if (stop && stop()) {
            complete = false;
            break;
        }
    }
    return {fill.placed(), fill.counts(), complete};
}

}  // namespace rinceau
