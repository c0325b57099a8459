#include "editor/model/fill_order.h"

#include <cstdio>
#include <utility>

#include "geometry/angle.h"
#include "growth/aggregate/fill_aggregate.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

constexpr const char* label = "The aggregate";
/// Placements tried before it is asked whether somebody wants to see them, or to stop: a few milliseconds.
constexpr std::size_t tries_a_look = 500;

/// The figures that are packed.
struct ChosenShapes {
    std::vector<int> figures;
    std::vector<double> shares;
};

ChosenShapes chosen_shapes(const FillOrder& order) {
    ChosenShapes chosen;
    for (int i = 0; i < static_cast<int>(order.source->drawing->figures.size()); ++i) {
        const auto set = order.settings.shapes.find(i);
        const ShapeChoice choice = set != order.settings.shapes.end() ? set->second : ShapeChoice{};
        if (!choice.used || choice.share <= 0) continue;
        chosen.figures.push_back(i);
        chosen.shares.push_back(choice.share);
    }
    if (chosen.figures.empty()) throw InputError({}, "No shape is chosen: tick at least one in the list of shapes");
    return chosen;
}

PackAngles angles_of(const AggregateSettings& settings) {
    constexpr double quarter = pi / 2;
    const double spread = radians(settings.spread);
    switch (settings.turn) {
        case PackTurn::none:
            return {.only = {0}};
        case PackTurn::quarters:
            return {.only = {0, quarter, 2 * quarter, 3 * quarter}};
        case PackTurn::within:
            return {.low = -spread, .high = spread};
        case PackTurn::any:
            break;
    }
    return {};
}

std::vector<ExclusiveRegion> regions_of(const FillOrder& order, const ChosenShapes& chosen) {
    std::vector<ExclusiveRegion> regions;
    const ExclusiveRegionOptions options{.margin = order.settings.margin / 2, .keep_holes = order.settings.keep_holes};
    for (const int i : chosen.figures) {
        const Figure& figure = order.source->drawing->figures[static_cast<std::size_t>(i)];
        regions.push_back(exclusive_region(figure.outline, options, "Shape " + figure.symbol));
    }
    return regions;
}

PackMethod method_of(FillMethod method) {
    if (method == FillMethod::gaps) return PackMethod::gaps;
    return method == FillMethod::darts ? PackMethod::naive : PackMethod::settle;
}

PackDomain domain_of(const FillOrder& order, const FillFiles& files) {
    PackDomain domain{.box = order.canvas, .region = files.region, .tiled = order.settings.tiled && !files.region};
    if (files.region) domain.box = bounds(*files.region);
    return domain;
}

AggregateOptions options_of(const AggregateSettings& settings, const ChosenShapes& chosen, const FillFiles& files,
                            const Box& box) {
    AggregateOptions options{.method = method_of(settings.method),
                             .quality = settings.quality == FillQuality::best ? PackQuality::best : PackQuality::fast,
                             .min_scale = settings.min_scale,
                             .max_scale = settings.max_scale,
                             .angles = angles_of(settings),
                             .shares = chosen.shares,
                             .seed = settings.seed};
    if (files.density) {
        DensityPicture density = *files.density;
        density.box = box;
        options.density = std::make_shared<const DensityPicture>(std::move(density));
    }
    return options;
}

/// Placed shapes as the editor shows them.
class Filling {
  public:
    Filling(const FillOrder& order, const FillFiles& files)
        : order_(order),
          chosen_(chosen_shapes(order)),
          regions_(regions_of(order, chosen_)),
          domain_(domain_of(order, files)),
          fill_(regions_, domain_, options_of(order.settings, chosen_, files, domain_.box), label) {}

    AggregateFill& fill() { return fill_; }

    GrownPattern result() {
        GrownPattern pattern{.kind = GrowthTab::aggregate, .source = order_.source};
        double covered = 0;
        for (const PlacedRegion& one : fill_.placed()) {
            const auto shape = static_cast<std::size_t>(one.shape);
            const double scale = scale_of(one.pose);
            covered += regions_[shape].area * scale * scale;
            place(pattern, one);
        }
        picture_ = picture_of(*order_.source->drawing, pattern.placed, domain_.box, picture_);
        pattern.picture = picture_;
        const double whole = domain_.region ? area(*domain_.region) : width(domain_.box) * height(domain_.box);
        char text[64];
        std::snprintf(text, sizeof text, "%zu %s %.1f %%", fill_.placed().size(),
                      fill_.placed().size() == 1 ? "shape covers" : "shapes cover", 100 * covered / whole);
        pattern.told = text;
        return pattern;
    }

  private:
    /// On a tile also where it comes in on the other side.
    void place(GrownPattern& pattern, const PlacedRegion& one) const {
        const auto shape = static_cast<std::size_t>(one.shape);
        const ExclusiveRegion& region = regions_[shape];
        const int beyond = domain_.tiled ? 1 : 0;
        for (int across = -beyond; across <= beyond; ++across) {
            for (int up = -beyond; up <= beyond; ++up) {
                const Point shift{across * width(domain_.box), up * height(domain_.box)};
                const Similarity pose = translate(shift) * one.pose;
                Box box;
                for (const Point p : region.rings.front()) box = including(box, apply(pose, p));
                if ((across == 0 && up == 0) || overlap(box, domain_.box))
                    pattern.placed.push_back({chosen_.figures[shape], pose * translate(-region.center), {}});
            }
        }
    }

    const FillOrder& order_;
    ChosenShapes chosen_;
    std::vector<ExclusiveRegion> regions_;
    PackDomain domain_;
    AggregateFill fill_;
    std::shared_ptr<const DerivedPicture> picture_;
};

}  // namespace

GrownPattern filled(const FillOrder& order, const FillFiles& files, const GrowthWatch& watch) {
    Filling filling(order, files);
    while (filling.fill().step(tries_a_look)) {
        report(watch.progress, "filling", filling.fill().fraction());
        if (watch.stop && watch.stop()) break;
        if (watch.wants_look && watch.wants_look()) watch.show(filling.result());
    }
    return filling.result();
}

}  // namespace rinceau
