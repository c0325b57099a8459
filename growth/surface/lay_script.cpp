// A group is tried as a whole before it is walked. What stands together (a flower on its petals) is laid as one thing even
// where its drawing says no group, so that it does not come apart.

#include "growth/surface/lay_script.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "growth/surface/laid_overlaps.h"

namespace rinceau {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr double largest_group = 0.45;        // radius, of the surface's diagonal
constexpr double stack_size = 1.6;            // what is not larger than this times its largest element is one thing
constexpr double stack_reach = 0.15;          // of its size that an element may stand out of what it stands on
constexpr double group_share = 0.5;           // of an element's stretch above 1 that a group may have
constexpr double field_turn = 12 * pi / 180;  // over a group that does not follow the field
constexpr double met_share = 0.05;            // of the smaller area: elements that share more have met
constexpr double drawn_reach = 1.25;          // of elements in the drawing: those may meet on the surface
constexpr double covered_share = 0.002;       // of the smaller area: less is not above
constexpr double spine_aspect = 4;            // length by width from which an element has a spine
constexpr long relaxing_budget = 3'000'000;   // triangles of relaxed charts of groups that were tried

class ScriptLayer {
  public:
    ScriptLayer(const SurfaceMesh& surface, const TurtleScript& script, std::span<const DrawnElement> elements,
                const TurtleWays& ways, const DrawingStand& start, const LayScriptOptions& options)
        : surface_(surface),
          script_(script),
          elements_(elements),
          ways_(ways),
          straight_{nullptr, 0, ways.scale},
          options_(options),
          layer_(surface, ways.scale, options.rims),
          turtle_(surface, ways, start),
          before_(script.deeds.size() + 1, 0) {
        for (std::size_t i = 0; i < script.deeds.size(); ++i)
            before_[i + 1] = before_[i] + (script.deeds[i].kind == TurtleEventKind::placed ? 1 : 0);
    }

    LaidScript run(const Progress& progress) {
        const int count = static_cast<int>(script_.deeds.size());
        if (count > 0 && try_group(0, count - 1)) {
            laid_.whole = true;
            return std::move(laid_);
        }
        constexpr int between_reports = 256;
        for (int i = 0; i < count;) {
            if (i % between_reports == 0) report(progress, "lay", static_cast<double>(i) / count);
            i = pass(i);
        }
        return std::move(laid_);
    }

  private:
    const SurfaceMesh& surface_;
    const TurtleScript& script_;
    std::span<const DrawnElement> elements_;
    const TurtleWays& ways_;
    TurtleWays straight_;  ///< from the turtle to the middle of what it draws: what is laid whole does not bend
    const LayScriptOptions& options_;
    ElementLayer layer_;
    SurfaceTurtle turtle_;
    std::vector<int> before_;  ///< elements before each deed
    LaidOverlaps overlaps_;
    long relaxed_ = 0;
    LaidScript laid_;

    /// The deed to go on with.
    int pass(int i) {
        const TurtleDeed& deed = script_.deeds[at(i)];
        switch (deed.kind) {
            case TurtleEventKind::pushed:
                if (try_group(i, deed.last)) return deed.last + 1;
                turtle_.push();
                break;
            case TurtleEventKind::popped:
                turtle_.pop();
                break;
            case TurtleEventKind::opened:
                if (try_group(i, deed.last)) {
                    stand_at_end(script_.deeds[at(deed.last)].to);
                    return deed.last + 1;
                }
                break;
            case TurtleEventKind::moved:
                turtle_.move(deed.to);
                break;
            case TurtleEventKind::placed:
                return pass_stack(i);
            default:
                break;
        }
        return i + 1;
    }

    /// Of deeds first .. last.
    std::vector<int> drawn_elements(int first, int last) const {
        std::vector<int> chosen;
        for (int e = before_[at(first)]; e < before_[at(last) + 1]; ++e)
            if (elements_[at(e)].art != nullptr) chosen.push_back(e);
        return chosen;
    }

    // ---- groups

    /// The chart that the last group was laid through.
    std::optional<ElementChart> group_chart_;

    bool try_group(int first, int last) {
        if (last < 0 || options_.groups == LayGroups::never || !turtle_.goes()) return false;
        const std::vector<int> chosen = drawn_elements(first, last);
        if (chosen.size() < 2) return false;
        const DrawnDisc disc = disc_of(elements_, chosen);
        if (ways_.scale * disc.radius > largest_group * surface_.diagonal) return false;
        const std::optional<DrawingStand> middle = moved(surface_, straight_, turtle_.stand(), disc.centre);
        if (!middle) return false;
        const bool is_stack = disc.radius <= stack_size * disc.largest;
        if (!is_stack && bends(*middle, chosen)) return false;
        const bool any = is_stack || options_.groups == LayGroups::always;
        const double stretch = any ? options_.stretch : 1 + group_share * (options_.stretch - 1);
        std::optional<ElementLayer::Result> result = through_charts(*middle, disc.radius, chosen, stretch);
        if (!result || (meets_any(result->shapes))) return false;
        for (LaidShape& shape : result->shapes) keep(std::move(shape));
        ++laid_.groups;
        return true;
    }

    /// Through a polar chart, else through a relaxed one.
    std::optional<ElementLayer::Result> through_charts(const DrawingStand& middle, double radius,
                                                       std::span<const int> chosen, double stretch) {
        group_chart_ = layer_.polar_chart(middle, radius);
        ElementLayer::Result result = layer_.lay(*group_chart_, elements_, chosen, stretch);
        if (result.fault == LayFault::stretched || result.fault == LayFault::folded) {
            if (relaxed_ > relaxing_budget) return std::nullopt;
            group_chart_ = layer_.relaxed_polar_chart(middle, radius);
            relaxed_ += static_cast<long>(group_chart_->chart.triangles.size());
            result = layer_.lay(*group_chart_, elements_, chosen, stretch);
        }
        if (result.fault != LayFault::none) return std::nullopt;
        return result;
    }

    /// Does the field turn over the elements, as seen from the turtle, more than a group may leave out?
    bool bends(const DrawingStand& middle, std::span<const int> chosen) const {
        if (ways_.field == nullptr || !(ways_.follow > 0)) return false;
        const int n = ways_.field->n();
        // the field's direction in the drawing
        const auto seen = [&](const DrawingStand& stand) { return arg(ways_.field->at(stand.at)) - n * arg(stand.turn); };
        const double here = seen(turtle_.stand());
        const auto turned = [&](const DrawingStand& there) {
            return std::abs(wrap_angle(seen(there) - here)) / n * ways_.follow > field_turn;
        };
        if (turned(middle)) return true;
        constexpr std::size_t most_looks = 24;
        const std::size_t stride = std::max<std::size_t>(1, chosen.size() / most_looks);
        for (std::size_t k = 0; k < chosen.size(); k += stride) {
            const auto there = moved(surface_, straight_, middle, center(elements_[at(chosen[k])].box));
            if (!there || turned(*there)) return true;
        }
        return false;
    }

    /// Behind a symbol laid whole the turtle stands where the chart has its end.
    void stand_at_end(Point to) {
        if (to == turtle_.stand().drawn) return;
        const auto place = place_in_chart(surface_, group_chart_->chart, group_chart_->of(to));
        if (place) {
            turtle_.set({place->at, place->x, to});
        } else {
            turtle_.move(to);
        }
    }

    // ---- single things

    /// Elements that stand on the one at deed i or below it are laid with it.
    int pass_stack(int i) {
        if (elements_[at(script_.deeds[at(i)].element)].art == nullptr) return i + 1;
        int end = i + 1;
        Box box = elements_[at(script_.deeds[at(i)].element)].box;
        const auto joins = [&](const std::vector<int>& more) {
            Box all;
            for (const int e : more) all = including(all, elements_[at(e)].box);
            const double reach = stack_reach * std::max(diagonal(box), diagonal(all));
            if (is_empty(box) || is_empty(all)) return true;
            const bool below = more.size() == 1 && contains(grown(all, reach), box);
            if (!below && !contains(grown(box, reach), all)) return false;
            box = including(box, all);
            return true;
        };
        for (int k = i + 1; k < static_cast<int>(script_.deeds.size());) {
            const TurtleDeed& deed = script_.deeds[at(k)];
            if (deed.kind == TurtleEventKind::placed) {
                if (!joins(drawn_elements(k, k))) break;
                end = ++k;
            } else if (deed.kind == TurtleEventKind::moved) {
                ++k;
            } else if ((deed.kind == TurtleEventKind::pushed || deed.kind == TurtleEventKind::opened) && deed.last >= 0) {
                if (!joins(drawn_elements(k, deed.last))) break;
                end = k = deed.last + 1;
            } else {
                break;
            }
        }
        if (turtle_.goes()) {
            lay_stack(drawn_elements(i, end - 1));
            turtle_.move(script_.deeds[at(end - 1)].to);
        }
        return end;
    }

    void lay_stack(const std::vector<int>& chosen) {
        if (chosen.empty()) return;
        const DrawnDisc disc = disc_of(elements_, chosen);
        const std::optional<DrawingStand> middle = moved(surface_, straight_, turtle_.stand(), disc.centre);
        if (!middle) {
            laid_.stopped += static_cast<long>(chosen.size());
            return;
        }
        group_chart_ = layer_.polar_chart(*middle, disc.radius);
        ElementLayer::Result result = layer_.lay(*group_chart_, elements_, chosen, options_.stretch);
        if (result.fault == LayFault::none) return keep_unless_met(std::move(result.shapes));
        cure(*middle, disc, chosen);
    }

    /// A long element through the faces along its axis.
    bool lay_along_spine(int element) {
        const DrawnStrip strip = strip_of(elements_[at(element)]);
        if (strip.half_length < spine_aspect * strip.half_width) return false;
        const std::optional<DrawingStand> middle = moved(surface_, straight_, turtle_.stand(), strip.centre);
        if (!middle) return false;
        const double radius = std::hypot(strip.half_length, strip.half_width);
        ElementLayer::Result result =
            layer_.lay(layer_.strip_chart(*middle, radius, strip), elements_, std::array{element}, options_.stretch);
        if (result.fault != LayFault::none) return false;
        ++laid_.spines;
        keep_unless_met(std::move(result.shapes));
        return true;
    }

    /// What does not lie well in its polar chart: along its spine, less stretch, less size, its parts alone, or not at all.
    void cure(const DrawingStand& middle, const DrawnDisc& disc, const std::vector<int>& chosen) {
        if (chosen.size() == 1 && lay_along_spine(chosen.front())) return;
        const ElementChart relaxed = layer_.relaxed_polar_chart(middle, disc.radius);
        const Point about = turtle_.stand().drawn;
        constexpr double sizes[] = {1, 0.9, 0.8, 0.7, 0.6};
        bool outside = false;
        for (const double size : sizes)
            for (const ElementChart* chart :
                 std::array<const ElementChart*, 2>{&relaxed, size < 1 ? &*group_chart_ : nullptr}) {
                if (chart == nullptr) continue;
                ElementLayer::Result result = layer_.lay(*chart, elements_, chosen, options_.stretch, {size, about});
                outside |= result.fault == LayFault::outside;
                if (result.fault != LayFault::none) continue;
                if (size < 1) laid_.shrunk += static_cast<long>(chosen.size());
                return keep_unless_met(std::move(result.shapes));
            }
        if (chosen.size() > 1) {
            laid_.split += static_cast<long>(chosen.size());
            for (const int e : chosen) lay_stack({e});
        } else if (outside) {
            ++laid_.stopped;
        } else {
            laid_.dropped.push_back({chosen.front(), middle.at});
        }
    }

    // ---- keeping

    void keep_unless_met(std::vector<LaidShape> shapes) {
        if (meets_any(shapes)) {
            laid_.stopped += static_cast<long>(shapes.size());
            turtle_.stop();
            return;
        }
        for (LaidShape& shape : shapes) keep(std::move(shape));
    }

    bool meets_any(const std::vector<LaidShape>& shapes) const {
        return !options_.meet_itself && std::ranges::any_of(shapes, [&](const LaidShape& shape) { return meets(shape); });
    }

    /// Does it lie on an element that it is clear of in the drawing?
    bool meets(const LaidShape& shape) const {
        for (const LaidOverlap& overlap : overlaps_.with(shape, met_share * shape.area)) {
            const LaidShape& other = laid_.shapes[at(overlap.other)];
            if (overlap.area < met_share * std::min(shape.area, other.area)) continue;
            if (!scaled_hulls_overlap(shape.drawn, other.drawn, drawn_reach)) return true;
        }
        return false;
    }

    void keep(LaidShape shape) {
        std::vector<int> covered;
        for (const LaidOverlap& overlap : overlaps_.with(shape, covered_share * shape.area))
            if (overlap.area >= covered_share * std::min(shape.area, laid_.shapes[at(overlap.other)].area))
                covered.push_back(overlap.other);
        overlaps_.add(shape);
        laid_.covers.push_back(std::move(covered));
        laid_.shapes.push_back(std::move(shape));
    }
};

}  // namespace

LaidScript lay_script(const SurfaceMesh& surface, const TurtleScript& script, std::span<const DrawnElement> elements,
                      const TurtleWays& ways, const DrawingStand& start, const LayScriptOptions& options,
                      const Progress& progress) {
    return ScriptLayer(surface, script, elements, ways, start, options).run(progress);
}

}  // namespace rinceau
