// Sakurai & Miyata 2014 as a machine that makes one try at a time: sparse start (section 4.1) -> filling (4.2, or 3.2 alone)
// -> rounds of shaking, each filled again.

#include "growth/aggregate/fill_aggregate.h"

#include <algorithm>
#include <optional>

#include "growth/aggregate/fill_methods.h"
#include "growth/aggregate/packing.h"
#include "growth/aggregate/shake.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

enum class FillStage : std::uint8_t { sparse, filling, shaking, done };

// Cancellations in a row that end a stage.
constexpr std::size_t sparse_stop = 100, naive_stop = 10'000, gaps_stop = 200, least_settle_stop = 1'000,
                      least_best_stop = 300;

}  // namespace

struct AggregateFill::State {
    explicit State(Packing start) : packing(std::move(start)) {
        if (packing.options().method != PackMethod::naive) {
            sparse.emplace(packing);
            stage = FillStage::sparse;
        }
    }

    const AggregateOptions& options() const { return packing.options(); }
    bool is_best() const { return options().quality == PackQuality::best; }
    std::size_t stop() const;
    double fraction_of_stage() const;
    double fraction() const;
    void try_once();
    bool fill_once();
    void begin_filling();
    void end_filling();

    Packing packing;
    FillStage stage = FillStage::filling;
    std::optional<SparseStart> sparse;
    GapRound gaps;
    std::optional<ShakeRound> shake;
    int shaken = 0;               ///< rounds that have been begun
    std::size_t longest_row = 0;  ///< of cancellations in this stage
    double furthest = 0;          ///< largest fraction so far: what is estimated may fall back, what is told does not
};

std::size_t AggregateFill::State::stop() const {
    if (stage == FillStage::sparse) return sparse_stop;
    if (options().stop > 0) return options().stop;
    if (options().method == PackMethod::naive) return naive_stop;
    if (options().method == PackMethod::gaps) return gaps_stop;
    // A count that stays the same would leave larger domains less full. After shaking there is another chance.
    if (is_best()) return std::max(least_best_stop, packing.placed().size() / 4);
    return std::max(least_settle_stop, packing.placed().size());
}

void AggregateFill::State::begin_filling() {
    if (options().method != PackMethod::naive) packing.make_field();
    gaps = {};
    packing.begin_stage();
    longest_row = 0;
    stage = FillStage::filling;
}

void AggregateFill::State::end_filling() {
    const bool more = is_best() && shaken < options().shakes && packing.placed().size() < options().max_count;
    stage = more ? FillStage::shaking : FillStage::done;
    if (more) shake.emplace(packing, shaken++);
}

/// False if no gap is left.
bool AggregateFill::State::fill_once() {
    const bool growing = is_best() && options().max_scale > options().min_scale;
    switch (options().method) {
        case PackMethod::naive:
            try_dart(packing, growing);
            return true;
        case PackMethod::gaps:
            return gaps.try_point(packing, growing);
        case PackMethod::settle:
            break;
    }
    return try_settled(packing, growing);
}

void AggregateFill::State::try_once() {
    const bool full = packing.placed().size() >= options().max_count;
    switch (stage) {
        case FillStage::sparse:
            if (full || packing.cancelled_in_row() >= stop())
                begin_filling();
            else
                sparse->try_circle(packing);
            break;
        case FillStage::filling:
            if (full || packing.cancelled_in_row() >= stop() || !fill_once()) end_filling();
            break;
        case FillStage::shaking:
            if (!shake->slide_next(packing)) begin_filling();
            break;
        case FillStage::done:
            break;
    }
    longest_row = std::max(longest_row, packing.cancelled_in_row());
    furthest = std::max(furthest, fraction());
}

double AggregateFill::State::fraction_of_stage() const {
    if (stage == FillStage::shaking) return 0.5 * shake->fraction();
    if (stage == FillStage::sparse) return 0;
    const double row = std::min(1.0, static_cast<double>(longest_row) / static_cast<double>(stop()));
    return shaken > 0 ? 0.5 + 0.5 * row : row;
}

double AggregateFill::State::fraction() const {
    if (stage == FillStage::done) return 1;
    const int rounds = is_best() ? std::max(options().shakes, 0) : 0;
    return (shaken + fraction_of_stage()) / (rounds + 1);
}

AggregateFill::AggregateFill(std::vector<ExclusiveRegion> regions, PackDomain domain, AggregateOptions options,
                             const std::string& label)
    : state_(std::make_unique<State>(Packing(std::move(regions), std::move(domain), std::move(options), label))) {}
AggregateFill::~AggregateFill() = default;
AggregateFill::AggregateFill(AggregateFill&&) noexcept = default;
AggregateFill& AggregateFill::operator=(AggregateFill&&) noexcept = default;

bool AggregateFill::step(std::size_t tries) {
    for (std::size_t i = 0; i < tries && state_->stage != FillStage::done; ++i) state_->try_once();
    return state_->stage != FillStage::done;
}
double AggregateFill::fraction() const { return state_->furthest; }
const std::vector<PlacedRegion>& AggregateFill::placed() const { return state_->packing.placed(); }
const AggregateCounts& AggregateFill::counts() const { return state_->packing.counts(); }

Aggregate fill_aggregate(const std::vector<ExclusiveRegion>& regions, const PackDomain& domain,
                         const AggregateOptions& options, const std::string& label, const std::function<bool()>& stop,
                         const Progress& progress) {
    constexpr std::size_t tries_between_reports = 256;
    AggregateFill fill(regions, domain, options, label);
    bool complete = true;
    while (complete && fill.step(tries_between_reports)) {
        report(progress, "filling", fill.fraction());
        complete = !stop || !stop();
    }
    if (complete && fill.placed().empty())
        throw InputError({label}, "no shape has found a free place in the region: make it larger or the shapes smaller");
    return {fill.placed(), fill.counts(), complete};
}

}  // namespace rinceau
