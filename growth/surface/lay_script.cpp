// A drawing, and then each group, is tried as a whole before it is walked. What stands together (a flower on its petals) is
// laid as one thing even where its drawing says no group, so that it does not come apart.

#include "growth/surface/lay_script.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/angle.h"
#include "geometry/index.h"
#include "growth/surface/laid_overlaps.h"
#include "growth/surface/lay_whole.h"

namespace rinceau {
namespace {

constexpr double largest_group = 0.45;        // radius, of the surface's diagonal
constexpr double stack_size = 1.6;            // what is not larger than this times its largest element is one thing
constexpr double stack_reach = 0.15;          // of its size that an element may stand out of what it stands on
constexpr double group_share = 0.5;           // of an element's stretch above 1 that a group may have
constexpr double field_turn = 12 * pi / 180;  // over a group that does not follow the field
constexpr double met_share = 0.05;            // of the smaller area: elements that share more have met
constexpr double drawn_reach = 1.25;          // of elements in the drawing: those may meet on the surface
constexpr double part_share = 0.5;            // of a compact drawing's area: a smaller part is no picture of it
constexpr double stand_margin = 0.02;         // of its diagonal that an element may stand out of what it stands on
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
          before_(script.deeds.size() + 1, 0),
          shape_of_(elements.size(), -1),
          tried_(elements.size(), false) {
        for (std::size_t i = 0; i < script.deeds.size(); ++i)
            before_[i + 1] = before_[i] + (script.deeds[i].kind == TurtleEventKind::placed ? 1 : 0);
    }

    LaidScript run(const Progress& progress) {
        const int count = static_cast<int>(script_.deeds.size());
        const std::vector<int> all = count > 0 ? drawn_elements(0, count - 1) : std::vector<int>{};
        if (lay_at_once(all) || options_.whole_only) return std::move(laid_);
        constexpr int between_reports = 256;
        for (int i = 0; i < count;) {
            if (i % between_reports == 0) report(progress, "lay", static_cast<double>(i) / count);
            i = pass(i);
        }
        cut_loose();
        laid_.stopped = static_cast<long>(all.size() - laid_.shapes.size() - laid_.dropped.size());
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
    std::vector<int> before_;    ///< elements before each deed
    std::vector<int> shape_of_;  ///< by element; -1: not laid
    std::vector<bool> tried_;    ///< by element
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

    // ---- the whole drawing

    bool lay_at_once(const std::vector<int>& chosen) {
        if (options_.groups == LayGroups::never || chosen.empty()) return false;
        const DrawnDisc disc = disc_of(elements_, chosen);
        const std::optional<DrawingStand> middle = moved(surface_, straight_, turtle_.stand(), disc.centre);
        if (!middle) return false;
        const double most_radius = largest_group * surface_.diagonal / ways_.scale;
        if (disc.radius <= most_radius) {
            const LayWholeOptions whole{ways_.field, ways_.follow, options_.stretch, options_.ties.compact,
                                        options_.whole_only};
            if (auto shapes = lay_whole(layer_, *middle, disc, elements_, chosen, whole)) {
                for (LaidShape& shape : *shapes) keep(std::move(shape));
                laid_.whole = true;
                return true;
            }
        }
        return options_.ties.compact && !options_.whole_only &&
               keep_part(lay_part(layer_, *middle, std::min(disc.radius, most_radius), elements_, chosen), chosen);
    }

    bool keep_part(std::vector<LaidShape> shapes, const std::vector<int>& chosen) {
        double area = 0, all = 0;
        for (const int e : chosen)
            for (const ArtLayer& layer : elements_[at(e)].art->layers)
                all += layer.area * norm(ways_.scale * elements_[at(e)].pose.linear);
        for (const LaidShape& shape : shapes) area += shape.area;
        if (area < part_share * all) return false;
        for (LaidShape& shape : shapes) keep(std::move(shape));
        cut_loose();
        laid_.stopped = static_cast<long>(chosen.size() - laid_.shapes.size());
        return true;
    }

    /// Takes away what no longer hangs together with the rest.
    void cut_loose() {
        if (options_.ties.contacts.empty()) return;
        std::vector<double> area(elements_.size(), 0);
        for (const LaidShape& shape : laid_.shapes) area[at(shape.element)] = shape.area;
        const std::vector<bool> held = elements_held(options_.ties, std::move(area));
        LaidScript kept;
        std::vector<int> now(laid_.shapes.size(), -1);
        for (std::size_t i = 0; i < laid_.shapes.size(); ++i) {
            if (!held[at(laid_.shapes[i].element)]) continue;
            now[i] = static_cast<int>(kept.shapes.size());
            kept.shapes.push_back(std::move(laid_.shapes[i]));
            std::vector<int>& covers = kept.covers.emplace_back();
            for (const int other : laid_.covers[i])
                if (now[at(other)] >= 0) covers.push_back(now[at(other)]);
        }
        laid_.shapes = std::move(kept.shapes);
        laid_.covers = std::move(kept.covers);
    }

    // ---- where to set out from

    struct Basis {
        DrawingStand stand;
        double size = 1;  ///< of what is set out, as it stands on something that was laid smaller

        TurtleWays ways(const TurtleWays& straight) const { return {nullptr, 0, size * straight.scale}; }
    };

    /// The laid element that touches one of the chosen with the shortest way over the contact to `centre`, or the turtle.
    Basis basis(const std::vector<int>& chosen, Point centre) const {
        const ElementContact* best = nullptr;
        double best_way = std::numeric_limits<double>::infinity();
        if (!options_.ties.contacts.empty())
            for (const int e : chosen)
                for (const ElementContact& contact : options_.ties.contacts[at(e)]) {
                    if (shape_of_[at(contact.other)] < 0) continue;
                    const double way = abs(in_chart(contact)) / ways_.scale + abs(centre - contact.at);
                    if (way >= best_way) continue;
                    best_way = way;
                    best = &contact;
                }
        if (best == nullptr) return {turtle_.stand()};
        const LaidShape& shape = laid_.shapes[at(shape_of_[at(best->other)])];
        const DrawingStand from{shape.middle, shape.turn, {}};
        std::optional<DrawingStand> hinge = moved(surface_, {nullptr, 0, 1}, from, in_chart(*best));
        if (!hinge) return {turtle_.stand()};
        hinge->drawn = best->at;
        const DrawnElement& below = elements_[at(best->other)];
        Box box;
        for (const int e : chosen) box = including(box, elements_[at(e)].box);
        const double size = scale_of(shape.pose) / (scale_of(below.pose) * ways_.scale);
        constexpr double smaller = 1 - 1e-9;
        if (size < smaller && contains(grown(below.box, stand_margin * diagonal(below.box)), box)) return {*hinge, size};
        const auto ahead = moved(surface_, straight_, *hinge, centre);
        if (ahead && follows()) hinge->turn = hinge->turn * polar(1, ways_.follow * field_turning(from, *ahead));
        return {*hinge};
    }

    /// Is what the element hangs on tried and not laid?
    bool hangs_on_lost(int element) const {
        if (options_.ties.support.empty()) return false;
        const int support = options_.ties.support[at(element)];
        return support >= 0 && tried_[at(support)] && shape_of_[at(support)] < 0;
    }

    /// Of a contact with a laid element, in that element's chart.
    Point in_chart(const ElementContact& contact) const {
        const LaidShape& shape = laid_.shapes[at(shape_of_[at(contact.other)])];
        return apply(shape.pose * inverse(elements_[at(contact.other)].pose), contact.at);
    }

    bool follows() const { return ways_.field != nullptr && ways_.follow > 0; }

    /// How far the field turns from one stand to another, as the drawing sees it.
    double field_turning(const DrawingStand& from, const DrawingStand& to) const {
        const int n = ways_.field->n();
        const auto seen = [&](const DrawingStand& stand) { return arg(ways_.field->at(stand.at)) - n * arg(stand.turn); };
        return wrap_angle(seen(to) - seen(from)) / n;
    }

    // ---- groups

    /// The chart that the last group was laid through.
    std::optional<ElementChart> group_chart_;

    bool try_group(int first, int last) {
        if (last < 0 || options_.groups == LayGroups::never || !turtle_.goes()) return false;
        const std::vector<int> chosen = drawn_elements(first, last);
        if (chosen.size() < 2 || std::ranges::any_of(chosen, [&](int e) { return hangs_on_lost(e); })) return false;
        const DrawnDisc disc = disc_of(elements_, chosen);
        if (ways_.scale * disc.radius > largest_group * surface_.diagonal) return false;
        const Basis from = basis(chosen, disc.centre);
        if (from.size != 1) return false;
        const std::optional<DrawingStand> middle = moved(surface_, straight_, from.stand, disc.centre);
        if (!middle) return false;
        const bool is_stack = disc.radius <= stack_size * disc.largest;
        if (!is_stack && bends(from.stand, *middle, chosen)) return false;
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

    /// Does the field turn over the elements, as seen from where they are set out, more than a group may leave out?
    bool bends(const DrawingStand& from, const DrawingStand& middle, std::span<const int> chosen) const {
        if (!follows()) return false;
        const auto turned = [&](const DrawingStand& there) {
            return std::abs(field_turning(from, there)) * ways_.follow > field_turn;
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
        const std::vector<int> stack = drawn_elements(i, end - 1);
        if (turtle_.goes()) {
            lay_stack(stack);
            turtle_.move(script_.deeds[at(end - 1)].to);
        }
        for (const int e : stack) tried_[at(e)] = true;
        return end;
    }

    void lay_stack(std::vector<int> chosen) {
        std::erase_if(chosen, [&](int e) { return hangs_on_lost(e); });
        if (chosen.empty()) return;
        const DrawnDisc disc = disc_of(elements_, chosen);
        const Basis from = basis(chosen, disc.centre);
        const std::optional<DrawingStand> middle = moved(surface_, from.ways(straight_), from.stand, disc.centre);
        if (!middle) return;
        group_chart_ = layer_.polar_chart(*middle, disc.radius);
        ElementLayer::Result result =
            layer_.lay(*group_chart_, elements_, chosen, options_.stretch, {from.size, disc.centre});
        if (result.fault == LayFault::none) return keep_unless_met(std::move(result.shapes));
        cure(*middle, disc, chosen, from);
    }

    /// A long element through the faces along its axis.
    bool lay_along_spine(int element) {
        const DrawnStrip strip = strip_of(elements_[at(element)]);
        if (strip.half_length < spine_aspect * strip.half_width) return false;
        const Basis from = basis({element}, strip.centre);
        const std::optional<DrawingStand> middle = moved(surface_, straight_, from.stand, strip.centre);
        if (!middle || from.size != 1) return false;
        const double radius = std::hypot(strip.half_length, strip.half_width);
        ElementLayer::Result result =
            layer_.lay(layer_.strip_chart(*middle, radius, strip), elements_, std::array{element}, options_.stretch);
        if (result.fault != LayFault::none) return false;
        ++laid_.spines;
        keep_unless_met(std::move(result.shapes));
        return true;
    }

    /// What does not lie well in its polar chart: along its spine, less stretch, less size, its parts alone, or not at all.
    void cure(const DrawingStand& middle, const DrawnDisc& disc, const std::vector<int>& chosen, const Basis& from) {
        if (chosen.size() == 1 && lay_along_spine(chosen.front())) return;
        // it stays where it is held: at what it touches, or in the middle of what it stands on
        const Point about = from.size == 1 ? from.stand.drawn : disc.centre;
        constexpr double sizes[] = {1, 0.9, 0.8, 0.7, 0.6};
        bool outside = false;
        for (const double size : sizes) {
            if (size > from.size) continue;
            // relaxed over no more than it needs: what lies farther out would take its share of the stretch to it
            const double reach = size * disc.radius + (1 - size) * abs(about - disc.centre);
            const ElementChart relaxed = layer_.relaxed_polar_chart(middle, reach);
            for (const ElementChart* chart :
                 std::array<const ElementChart*, 2>{&relaxed, size < 1 ? &*group_chart_ : nullptr}) {
                if (chart == nullptr) continue;
                ElementLayer::Result result = layer_.lay(*chart, elements_, chosen, options_.stretch, {size, about});
                outside |= result.fault == LayFault::outside;
                if (result.fault != LayFault::none) continue;
                if (size < 1) laid_.shrunk += static_cast<long>(chosen.size());
                return keep_unless_met(std::move(result.shapes));
            }
        }
        if (chosen.size() > 1) {
            laid_.split += static_cast<long>(chosen.size());
            for (const int e : chosen) {
                lay_stack({e});
                tried_[at(e)] = true;
            }
        } else if (!outside) {
            laid_.dropped.push_back({chosen.front(), middle.at});
        }
    }

    // ---- keeping

    void keep_unless_met(std::vector<LaidShape> shapes) {
        if (meets_any(shapes)) {
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
        shape_of_[at(shape.element)] = static_cast<int>(laid_.shapes.size());
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
