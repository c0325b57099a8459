#include "analyzer/match_styles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <unordered_map>

#include "analyzer/stroke_lengths.h"
#include "analyzer/style_axes.h"

namespace rinceau {

namespace {

/// How far gradients, and start points, of one look may differ, in unit lengths.
constexpr double style_tolerance = 0.01;
/// Equal lengths of strokes, but for rounding.
constexpr double same_length = 1e-6;
/// A tenth of a pixel in a picture 900 pixels wide and high, as a share of the diagonal: no width differs by more unseen.
constexpr double smallest_seen = 7.8e-5;

bool same_share(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

bool is_stretched(const Stroke& stroke) { return stroke.pen != Linear2{}; }

/// With strokes of equal lengths, but for those of stretched pens: how wide these draw shows sooner than where a gradient
/// lies.
bool same_unit_style(const Style& a, const Style& b, double pen_tolerance) {
    if (!same_style(a, b, style_tolerance)) return false;
    if (!paints_stroke(a)) return true;
    const bool stretched = is_stretched(a.stroke) || is_stretched(b.stroke);
    return a.stroke.fixed == b.stroke.fixed && (!stretched || same_pen(a.stroke, b.stroke, pen_tolerance));
}

bool same_lengths(const Style& a, const Style& b) {
    return !paints_stroke(a) || (same_share(a.stroke.width, b.stroke.width, same_length) &&
                                 std::ranges::equal(a.stroke.dashes, b.stroke.dashes,
                                                    [](double s, double t) { return same_share(s, t, same_length); }));
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

/// Of what must agree exactly, lengths apart.
Hash style_hash(const Style& style) {
    Hash hash = mixed(0, Hash{paints_fill(style)});
    if (paints_fill(style)) hash = mixed(hash, style.fill);
    return paints_stroke(style) ? mixed(hash, style.stroke.paint) : hash;
}

double dash_period(const Stroke& stroke) { return std::accumulate(stroke.dashes.begin(), stroke.dashes.end(), 0.0); }

/// Of what a stroke is beside its lengths.
Hash stroke_kind(const Style& style) {
    const Stroke& stroke = style.stroke;
    Hash hash = mixed(mixed(style_hash(style), static_cast<Hash>(stroke.cap)), Hash{stroke.pen == Linear2{}});
    const double period = dash_period(stroke);
    if (!(period > 0)) return mixed(hash, stroke.dashes.size());
    constexpr double parts = 1000;  // of the period
    for (const double dash : stroke.dashes) hash = mixed(hash, static_cast<Hash>(std::llround(parts * dash / period)));
    return mixed(hash, static_cast<Hash>(std::llround(parts * stroke.dash_offset / period)));
}

std::vector<StrokeLengths> find_stroke_lengths(const Scene& scene, const ShapeMatching& shapes) {
    std::vector<DrawnStroke> strokes;
    std::vector<std::size_t> elements;
    for (std::size_t i = 0; i < scene.elements.size(); ++i) {
        const ShapeMatch& match = shapes.matches[i];
        const Style& style = scene.elements[i].style;
        if (match.shape < 0 || !paints_stroke(style)) continue;
        const bool is_dot = shapes.classes[static_cast<std::size_t>(match.shape)].dots;  // its size is its width
        strokes.push_back({match.shape, stroke_kind(style), style.stroke.width, dash_period(style.stroke),
                           scale_of(match.pose), is_dot || is_stretched(style.stroke)});
        elements.push_back(i);
    }
    const std::vector<StrokeLengths> found = common_stroke_lengths(strokes, smallest_seen * drawing_diagonal(scene));
    std::vector<StrokeLengths> of_elements(scene.elements.size());
    for (std::size_t k = 0; k < found.size(); ++k) of_elements[elements[k]] = found[k];
    return of_elements;
}

/// The style with those lengths, drawn in the scene at `scale`.
Style with_lengths(Style style, const StrokeLengths& lengths, double scale) {
    if (lengths.group < 0) return style;
    Stroke& stroke = style.stroke;
    const double unit = lengths.fixed ? 1 : scale;
    const double period = dash_period(stroke);
    const double stretch = period > 0 ? lengths.dash_period * unit / period : 1;
    stroke.fixed = lengths.fixed;
    stroke.width = lengths.width * unit;
    for (double& dash : stroke.dashes) dash *= stretch;
    stroke.dash_offset *= stretch;
    return style;
}

/// An element with its pose, as drawn so far.
struct StyledElement {
    int shape = -1;
    Similarity pose;
    int lengths = -1;  ///< group of its stroke's lengths
    Style unit_style;
    PaintedForm form;
    std::vector<double> axes;  ///< of style, or of starts; empty = no rotation or mirror image can be told

    bool oriented() const { return !axes.empty(); }
};

StyledElement styled(const Element& element, const ShapeMatch& match, const StrokeLengths& lengths, bool is_dot) {
    const Style style = with_lengths(element.style, lengths, scale_of(match.pose));
    StyledElement result{match.shape, match.pose, lengths.group, transformed(style, inverse(match.pose)), {}, {}};
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
    StyleMatcher(const Scene& scene, const ShapeMatching& shapes)
        : scene_(scene), shapes_(shapes), least_seen_(smallest_seen * drawing_diagonal(scene)) {}

    StyleMatching run() && {
        const std::vector<StrokeLengths> lengths = find_stroke_lengths(scene_, shapes_);
        for (std::size_t i = 0; i < scene_.elements.size(); ++i) {
            const ShapeMatch& match = shapes_.matches[i];
            if (match.shape < 0) {
                add_verbatim(static_cast<int>(i));
            } else {
                const bool is_dot = shapes_.classes[static_cast<std::size_t>(match.shape)].dots;
                add(static_cast<int>(i), styled(scene_.elements[i], match, lengths[i], is_dot));
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
        lengths_.push_back(-1);
    }

    void add(int index, const StyledElement& element) {
        for (const int look : looks_by_hash_[look_hash(element)])
            if (const std::optional<Similarity> pose = pose_in(look, element)) {
                result_.instances.push_back({look, *pose});
                return;
            }
        found_look(index, element);
    }

    /// In unit lengths of an element with this pose.
    double pen_tolerance(const Similarity& pose) const { return std::min(style_tolerance, least_seen_ / scale_of(pose)); }

    static Hash look_hash(const StyledElement& element) {
        const Hash shape = mixed(style_hash(element.unit_style), static_cast<Hash>(element.shape));
        return mixed(mixed(shape, static_cast<Hash>(element.lengths)), element.form.starts.size());
    }

    /// The cleanest pose under which the element is a copy of the look.
    std::optional<Similarity> pose_in(int look_index, const StyledElement& element) const {
        const StyledLook& look = result_.looks[static_cast<std::size_t>(look_index)];
        if (look.shape != element.shape) return std::nullopt;
        if (lengths_[static_cast<std::size_t>(look_index)] != element.lengths) return std::nullopt;
        if (!same_form(look.form, element.form)) return std::nullopt;
        const Similarity& reference = result_.instances[static_cast<std::size_t>(look.first)].pose;
        std::optional<Similarity> best;
        const double pen = pen_tolerance(element.pose);
        if (!element.oriented() && !same_unit_style(look.unit_style, element.unit_style, pen)) return best;
        for (const Similarity& gauge : gauges(element, first_axes_[static_cast<std::size_t>(look_index)])) {
            const Similarity pose = element.pose * gauge;
            if (best && !cleaner(pose, *best, reference)) continue;
            if (element.oriented()) {
                if (!same_unit_style(look.unit_style, transformed(element.unit_style, inverse(gauge)), pen)) continue;
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
        looks_by_hash_[look_hash(element)].push_back(number);
        result_.instances.push_back({number, clean.pose});
        result_.looks.push_back(std::move(look));
        first_axes_.push_back(std::move(clean.axes));
        lengths_.push_back(clean.lengths);
    }

    SymmetryGroup look_symmetry(const StyledElement& element, const ShapeClass& shape) const {
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
            if (same_unit_style(element.unit_style, transformed(element.unit_style, candidates[i]),
                                pen_tolerance(element.pose)))
                group.elements.push_back(candidates[i]);
        return group;
    }

    int style_number(const Style& style) {
        // Equal widths share a step but for rounding at its ends, which costs a number.
        constexpr double step = 1e-3;  // of the logarithm
        const double width = paints_stroke(style) ? std::log(style.stroke.width) / step : 0;
        const Hash hash = mixed(style_hash(style), static_cast<Hash>(std::llround(width)));
        std::vector<std::pair<int, Style>>& alike = styles_by_hash_[hash];
        for (const auto& [number, other] : alike)
            if (same_lengths(other, style) && same_unit_style(other, style, style_tolerance)) return number;
        alike.push_back({styles_, style});
        return styles_++;
    }

    const Scene& scene_;
    const ShapeMatching& shapes_;
    double least_seen_;  ///< scene length
    std::unordered_map<Hash, std::vector<int>> looks_by_hash_;
    std::unordered_map<Hash, std::vector<std::pair<int, Style>>> styles_by_hash_;
    std::vector<std::vector<double>> first_axes_;  ///< of each look: axes of its unit style
    std::vector<int> lengths_;                     ///< of each look: group of its stroke's lengths
    int styles_ = 0;
    StyleMatching result_;
};

}  // namespace

StyleMatching match_styles(const Scene& scene, const ShapeMatching& shapes) { return StyleMatcher(scene, shapes).run(); }

}  // namespace rinceau
