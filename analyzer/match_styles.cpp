#include "analyzer/match_styles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "analyzer/style_axes.h"

namespace rinceau {

namespace {

/// How far gradients, and start points, of one look may differ, in unit lengths.
constexpr double style_tolerance = 0.01;
/// How far stroke widths of one look may differ, and the lengths of dashes, whose differences add up along the outline.
constexpr double width_tolerance = 0.01;
constexpr double dash_tolerance = 1e-3;

bool same_share(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b)); }

bool same_unit_style(const Style& a, const Style& b) {
    if (!same_style(a, b, style_tolerance)) return false;
    if (!paints_stroke(a)) return true;
    return same_share(a.stroke.width, b.stroke.width, width_tolerance) &&
           std::ranges::equal(a.stroke.dashes, b.stroke.dashes,
                              [](double s, double t) { return same_share(s, t, dash_tolerance); });
}

using Hash = std::uint64_t;

Hash mixed(Hash hash, Hash with) {
    hash = (hash ^ with) * 0x9E3779B97F4A7C15u;
    return hash ^ (hash >> 31);
}

Hash mixed(Hash hash, Color c) {
    return mixed(hash, static_cast<Hash>(c.red) << 16 | static_cast<Hash>(c.green) << 8 | c.blue);
}

Hash mixed(Hash hash, const Paint& paint) {
    hash = mixed(hash, paint.index());
    if (const auto* color = std::get_if<Color>(&paint)) return mixed(hash, *color);
    if (const auto* gradient = std::get_if<std::shared_ptr<const Gradient>>(&paint))
        for (const GradientStop& stop : (*gradient)->stops) hash = mixed(hash, stop.color);
    return hash;
}

/// Of what must agree exactly; `bin_offset` moves the bin of the stroke width.
Hash style_hash(const Style& style, int bin_offset) {
    Hash hash = mixed(0, Hash{paints_fill(style)});
    if (paints_fill(style)) hash = mixed(hash, style.fill);
    if (!paints_stroke(style)) return hash;
    const double bin = std::floor(std::log(style.stroke.width) / (2 * width_tolerance)) + bin_offset;
    return mixed(mixed(hash, style.stroke.paint), static_cast<Hash>(static_cast<std::int64_t>(bin)));
}

/// The bins in which an equal style may have been filed.
std::vector<int> bins_of(const Style& style) { return paints_stroke(style) ? std::vector{0, -1, 1} : std::vector{0}; }

/// An element with its pose, as drawn so far.
struct StyledElement {
    int shape = -1;
    Similarity pose;
    Style unit_style;
    PaintedForm form;
    std::vector<double> axes;  ///< of style, or of starts; empty = no rotation or mirror image can be told

    bool oriented() const { return !axes.empty(); }
};

StyledElement styled(const Element& element, const ShapeMatch& match, bool is_dot) {
    StyledElement result{match.shape, match.pose, transformed(element.style, inverse(match.pose)), {}, {}};
    if (!is_dot) result.form = painted_form(element, match.pose);
    result.axes = style_axes(result.unit_style, style_tolerance);
    if (result.axes.empty())
        for (const PathStart& start : result.form.starts) result.axes.push_back(arg(start.at));
    return result;
}

/// The same element seen with another pose, pose * gauge.
StyledElement in_gauge(const StyledElement& element, const Similarity& gauge) {
    StyledElement result = element;
    const Similarity back = inverse(gauge);
    result.pose = element.pose * gauge;
    result.unit_style = transformed(element.unit_style, back);
    for (PathStart& start : result.form.starts) {
        start.at = apply(back, start.at);
        start.direction = back.linear * flipped_if(back.mirrored, start.direction);
    }
    for (double& axis : result.axes) axis = arg(back.linear * flipped_if(back.mirrored, polar(1, axis)));
    return result;
}

/// Unmirrored before mirrored; then the smaller turn against the reference, to the left of equal ones.
bool cleaner(const Similarity& a, const Similarity& b, const Similarity& reference) {
    constexpr double same_turn = 1e-6;  // radians
    if (a.mirrored != b.mirrored) return !a.mirrored;
    const double turn_a = wrap_angle(arg(a.linear) - arg(reference.linear));
    const double turn_b = wrap_angle(arg(b.linear) - arg(reference.linear));
    if (std::abs(std::abs(turn_a) - std::abs(turn_b)) > same_turn) return std::abs(turn_a) < std::abs(turn_b);
    return turn_a > turn_b + same_turn;
}

/// The square cap of a dot is drawn upright, though its outline has every symmetry.
bool is_upright(const ShapeClass& shape, const Style& style) {
    return shape.dots && paints_stroke(style) && style.stroke.cap == LineCap::square;
}

SymmetryGroup square_symmetry() {
    SymmetryGroup group;
    const Complex turns[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    group.elements.clear();
    for (const bool mirrored : {false, true})
        for (const Complex turn : turns) group.elements.push_back({turn, {}, mirrored});
    return group;
}

class StyleMatcher {
  public:
    StyleMatcher(const Scene& scene, const ShapeMatching& shapes) : scene_(scene), shapes_(shapes) {}

    StyleMatching run() && {
        for (std::size_t i = 0; i < scene_.elements.size(); ++i) {
            const ShapeMatch& match = shapes_.matches[i];
            if (match.shape < 0) {
                add_verbatim(static_cast<int>(i));
            } else {
                const bool is_dot = shapes_.classes[static_cast<std::size_t>(match.shape)].dots;
                add(static_cast<int>(i), styled(scene_.elements[i], match, is_dot));
            }
        }
        result_.styles = styles_;
        return std::move(result_);
    }

  private:
    const SymmetryGroup& symmetry_of(const StyledElement& e) const {
        return shapes_.classes[static_cast<std::size_t>(e.shape)].symmetry;
    }

    void add_verbatim(int element) {
        StyledLook look;
        look.first = element;
        look.style = styles_++;
        result_.instances.push_back({static_cast<int>(result_.looks.size()), Similarity{}});
        result_.looks.push_back(std::move(look));
        first_axes_.push_back({});
    }

    void add(int index, const StyledElement& element) {
        for (const int bin : bins_of(element.unit_style))
            for (const int look : looks_by_hash_[look_hash(element, bin)])
                if (const std::optional<Similarity> pose = pose_in(look, element)) {
                    result_.instances.push_back({look, *pose});
                    return;
                }
        found_look(index, element);
    }

    static Hash look_hash(const StyledElement& element, int bin_offset) {
        return mixed(mixed(style_hash(element.unit_style, bin_offset), static_cast<Hash>(element.shape)),
                     element.form.starts.size());
    }

    /// The cleanest pose under which the element is a copy of the look.
    std::optional<Similarity> pose_in(int look_index, const StyledElement& element) const {
        const StyledLook& look = result_.looks[static_cast<std::size_t>(look_index)];
        if (look.shape != element.shape || !same_form(look.form, element.form)) return std::nullopt;
        const Similarity& reference = result_.instances[static_cast<std::size_t>(look.first)].pose;
        std::optional<Similarity> best;
        if (!element.oriented() && !same_unit_style(look.unit_style, element.unit_style)) return best;
        for (const Similarity& gauge : gauges(element, first_axes_[static_cast<std::size_t>(look_index)])) {
            const Similarity pose = element.pose * gauge;
            if (best && !cleaner(pose, *best, reference)) continue;
            if (element.oriented()) {
                if (!same_unit_style(look.unit_style, transformed(element.unit_style, inverse(gauge)))) continue;
                if (!same_starts(look.form, gauge, element.form, style_tolerance)) continue;
            }
            best = pose;
        }
        return best;
    }

    /// The symmetries that may bring the element's axes onto the look's.
    std::vector<Similarity> gauges(const StyledElement& element, const std::vector<double>& look_axes) const {
        const SymmetryGroup& group = symmetry_of(element);
        if (!group.continuous) return group.elements;
        if (!element.oriented()) return {Similarity{}};
        std::vector<Similarity> turns;
        for (const double own : element.axes)
            for (const double axis : look_axes) {
                turns.push_back({polar(1, own - axis), {}, false});
                turns.push_back({polar(1, own + axis), {}, true});
            }
        return turns;
    }

    void found_look(int index, const StyledElement& element) {
        // A shape with a frame: of equivalent poses the one nearest to the representative as drawn.
        Similarity gauge;
        const SymmetryGroup& group = symmetry_of(element);
        for (const Similarity& g : group.elements)
            if (cleaner(element.pose * g, element.pose * gauge, Similarity{})) gauge = g;
        StyledElement clean = in_gauge(element, gauge);
        StyledLook look{element.shape, style_number(clean.unit_style), index, clean.unit_style, clean.form, {}};
        look.symmetry = look_symmetry(clean, shapes_.classes[static_cast<std::size_t>(element.shape)]);
        const int number = static_cast<int>(result_.looks.size());
        looks_by_hash_[look_hash(element, 0)].push_back(number);
        result_.instances.push_back({number, clean.pose});
        result_.looks.push_back(std::move(look));
        first_axes_.push_back(std::move(clean.axes));
    }

    static SymmetryGroup look_symmetry(const StyledElement& element, const ShapeClass& shape) {
        if (!element.form.starts.empty()) return {};
        if (is_upright(shape, element.unit_style)) return square_symmetry();
        if (!element.oriented()) return shape.symmetry;
        std::vector<Similarity> candidates = shape.symmetry.elements;
        if (shape.symmetry.continuous) {
            const double axis = element.axes.front();
            candidates = {Similarity{}, rotate(pi), {polar(1, 2 * axis), {}, true}, {polar(1, 2 * axis + pi), {}, true}};
        }
        SymmetryGroup group;
        for (std::size_t i = 1; i < candidates.size(); ++i)
            if (same_unit_style(element.unit_style, transformed(element.unit_style, candidates[i])))
                group.elements.push_back(candidates[i]);
        return group;
    }

    int style_number(const Style& style) {
        for (const int bin : bins_of(style))
            for (const auto& [number, other] : styles_by_hash_[style_hash(style, bin)])
                if (same_unit_style(other, style)) return number;
        styles_by_hash_[style_hash(style, 0)].push_back({styles_, style});
        return styles_++;
    }

    const Scene& scene_;
    const ShapeMatching& shapes_;
    std::unordered_map<Hash, std::vector<int>> looks_by_hash_;
    std::unordered_map<Hash, std::vector<std::pair<int, Style>>> styles_by_hash_;
    std::vector<std::vector<double>> first_axes_;  ///< of each look: axes of its unit style
    int styles_ = 0;
    StyleMatching result_;
};

}  // namespace

StyleMatching match_styles(const Scene& scene, const ShapeMatching& shapes) { return StyleMatcher(scene, shapes).run(); }

}  // namespace rinceau
