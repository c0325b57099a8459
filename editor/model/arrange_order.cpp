#include "editor/model/arrange_order.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/angle.h"
#include "growth/arrangement/grow_ground.h"
#include "growth/arrangement/jitter.h"
#include "growth/arrangement/place_figures.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

/// What grows before it is asked whether somebody wants to see it.
constexpr double elements_a_look = 1000;
/// What may grow when nothing else bounds it: more than is seen apart.
constexpr std::size_t most_elements = 100'000;

RotationMode mode_of(ElementTurn turn) {
    if (turn == ElementTurn::to_fit) return RotationMode::rotate;
    return turn == ElementTurn::along_flow ? RotationMode::flow : RotationMode::fixed;
}

ArrangeOptions options_of(const ArrangementSettings& settings, const Exemplar& exemplar) {
    ArrangeOptions options{.mode = mode_of(settings.turn), .two_rings = settings.two_rings, .seed = settings.seed};
    for (const ExemplarSymbol& symbol : exemplar.symbols) {
        const auto set = settings.priorities.find(symbol.name);
        options.priorities.push_back(set != settings.priorities.end() ? set->second : 0);
    }
    // to be told that all are alike saves looking for others at each step
    if (std::ranges::count(options.priorities, options.priorities.front()) == std::ssize(options.priorities))
        options.priorities.clear();
    return options;
}

Region region_of_box(const Box& box) { return {{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}}; }

JitterOptions jitter_of(const ArrangementSettings& settings) {
    return {.angle = radians(settings.jitter.angle),
            .scale = settings.jitter.scale,
            .color = settings.jitter.color,
            .seed = settings.seed};
}

/// Carries steps out on an arrangement.
class Steps {
  public:
    Steps(const ArrangeOrder& order, const ArrangeSurroundings& around, const GrowthWatch& watch)
        : order_(order), exemplar_(*order.source->exemplar), around_(around), watch_(watch) {
        grown_ = order.from && order.from->arrangement ? *order.from->arrangement
                                                       : empty_arrangement(exemplar_, options_of(order.settings, exemplar_));
        if (order.from && order.from->source == order.source) picture_ = order.from->picture;
    }

    bool stopped() const { return watch_.stop && watch_.stop(); }

    void perform(const SprayStep& step) {
        if (step.plants) grown_ = with_seed(std::move(grown_), exemplar_, around_, step.center);
        grow_by({.brush = Brush{step.center, step.radius}, .stop = watch_.stop}, watch_.progress);
    }
    void perform(const ShowStep&) {}
    void perform(const GrowStep& step) {
        if (grown_.elements == 0)
            grown_ = with_seed(std::move(grown_), exemplar_, around_, ground_start(around_, order_.canvas));
        const std::size_t begun = grown_.elements;
        const std::size_t room = most_elements - std::min(most_elements, begun);
        const std::size_t wanted = begun + (step.more == 0 ? room : std::min(step.more, room));
        const auto expected = static_cast<double>(std::min(wanted, begun + fitting())) - static_cast<double>(begun);
        while (grown_.elements < wanted && !stopped()) {
            const std::size_t before = grown_.elements;
            const auto share = [&](double of_look) {
                return std::min(1.0, (static_cast<double>(before - begun) + of_look * elements_a_look) / expected);
            };
            grow_anywhere(
                {.count = std::min(wanted, before + static_cast<std::size_t>(elements_a_look)), .stop = watch_.stop},
                [&](std::string_view stage, double fraction) { report(watch_.progress, stage, share(fraction)); });
            if (grown_.elements == before) break;
            look();
        }
    }
    void perform(const FinishStep& step) {
        if (grown_.elements == 0) return;
        look();
        grown_.options.finish = step.repair;
        grown_ = finished(std::move(grown_), exemplar_, around_, {.stop = watch_.stop}, watch_.progress);
    }

    GrownPattern result() {
        GrownPattern pattern{.source = order_.source};
        pattern.arrangement = std::make_shared<const ElementArrangement>(grown_);
        const std::vector<ArrangedElement> elements = arranged_elements(grown_);
        const FiguredDrawing& drawing = *order_.source->drawing;
        pattern.placed = placed_figures(drawing, elements);
        if (order_.settings.jitter != JitterSettings{})
            pattern.placed = jittered(drawing, pattern.placed, jitter_of(order_.settings), around_.boundary.get());
        for (const auto& [a, b] : arranged_edges(grown_))
            pattern.edges.push_back(
                {elements[static_cast<std::size_t>(a)].position, elements[static_cast<std::size_t>(b)].position});
        const Box canvas = order_.settings.fill ? order_.canvas : roomy_canvas(order_.canvas, drawing, pattern.placed);
        picture_ = picture_of(drawing, pattern.placed, canvas, picture_);
        pattern.picture = picture_;
        pattern.told = std::to_string(elements.size()) + (elements.size() == 1 ? " element" : " elements");
        return pattern;
    }

  private:
    void grow_by(const GrowOrder& order, const Progress& progress) {
        grown_ = grow(std::move(grown_), exemplar_, around_, order, progress);
    }
    /// The same; within a full canvas, also in parts of it that strokes cut off.
    void grow_anywhere(const GrowOrder& order, const Progress& progress) {
        if (!order_.settings.fill) return grow_by(order, progress);
        grown_ = grown_over(std::move(grown_), exemplar_, around_, order_.canvas, order, progress);
    }
    /// About how many elements the canvas has room for; without a full canvas to come it does not matter.
    std::size_t fitting() const {
        if (!order_.settings.fill) return most_elements;
        const double area = width(order_.canvas) * height(order_.canvas);
        return static_cast<std::size_t>(std::clamp(area * exemplar_.density, 1.0, static_cast<double>(most_elements)));
    }
    void look() {
        if (watch_.wants_look && watch_.wants_look()) watch_.show(result());
    }

    const ArrangeOrder& order_;
    const Exemplar& exemplar_;
    const ArrangeSurroundings& around_;
    const GrowthWatch& watch_;
    ElementArrangement grown_;
    std::shared_ptr<const DerivedPicture> picture_;
};

}  // namespace

ArrangeSurroundings surroundings_of(const ArrangeOrder& order) {
    ArrangeSurroundings around;
    const double edge = order.source->exemplar->mean_edge;
    if (order.settings.turn == ElementTurn::along_flow) {
        if (order.guides->flow.empty())
            throw InputError({}, "No flow is drawn yet: take the tool Flow and draw the lines that elements shall follow");
        around.flow = std::make_shared<const FlowField>(make_flow_field(
            order.guides->flow, order.canvas, {.step = 0.5 * edge, .directed = order.settings.directed}, "The flow"));
    }
    if (order.settings.fill || !order.guides->boundary.empty()) {
        std::optional<Region> region;
        if (order.settings.fill) region = region_of_box(order.canvas);
        around.boundary = std::make_shared<const Boundary>(order.guides->boundary, region);
    }
    return around;
}

GrownPattern arranged(const ArrangeOrder& order, const ArrangeSurroundings& around, const GrowthWatch& watch) {
    Steps steps(order, around, watch);
    for (const ArrangeStep& step : order.steps) {
        if (steps.stopped()) break;
        std::visit([&](const auto& one) { steps.perform(one); }, step);
    }
    return steps.result();
}

}  // namespace rinceau
