#include "analyzer/match_elements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "analyzer/outline_classes.h"
#include "analyzer/point_symmetry.h"
#include "geometry/parallel.h"

namespace rinceau {

namespace {

/// Share of the diagonal under which an outline is a dot.
constexpr double dot_share = 1e-6;
/// Share of an outline's extent under which numbers are the same but for rounding.
constexpr double rounding_share = 1e-9;

/// Outlines that are the same numbers moved: found by hash, without any matching of shapes.
class MovedCopies {
  public:
    /// The first outline given so far that `outlines[index]` is a moved copy of, or `index` itself.
    int first_copy(const std::vector<Outline>& outlines, int index) {
        const Outline& outline = outlines[static_cast<std::size_t>(index)];
        const double extent = extent_of(outline);
        std::vector<int>& same_hash = by_hash_[hash_of(outline, extent)];
        for (const int other : same_hash)
            if (same(outlines[static_cast<std::size_t>(other)], outline, rounding_share * extent)) return other;
        same_hash.push_back(index);
        return index;
    }

  private:
    static std::array<Point, 4> points_of(const OutlinePiece& piece) {
        return {piece.curve.from, piece.curve.control1, piece.curve.control2, piece.curve.to};
    }

    static double extent_of(const Outline& outline) {
        double extent = 0;
        for (const OutlinePiece& piece : outline.pieces)
            for (const Point p : points_of(piece)) extent = std::max({extent, std::abs(p.x), std::abs(p.y)});
        return extent;
    }

    /// Numbers are rounded before they count; where rounding noise still splits copies, they go the long way.
    static std::uint64_t hash_of(const Outline& outline, double extent) {
        const double quantum = std::exp2(std::ceil(std::log2(extent > 0 ? extent : 1.0) - 0.5) - 30);
        std::uint64_t hash = outline.pieces.size();
        const auto add = [&](double number) {
            hash = (hash ^ static_cast<std::uint64_t>(std::llround(number / quantum))) * 0x9E3779B97F4A7C15u;
            hash ^= hash >> 29;
        };
        for (const OutlinePiece& piece : outline.pieces)
            for (const Point p : points_of(piece)) {
                add(p.x);
                add(p.y);
            }
        return hash;
    }

    static bool same(const Outline& a, const Outline& b, double distance) {
        return std::ranges::equal(a.pieces, b.pieces, [&](const OutlinePiece& p, const OutlinePiece& q) {
            const auto near = [&](Point s, Point t) { return abs(s - t) <= distance; };
            return p.straight == q.straight && std::ranges::equal(points_of(p), points_of(q), near);
        });
    }

    std::unordered_map<std::uint64_t, std::vector<int>> by_hash_;
};

/// Largest deviation of a copy in its own unit frame.
double allowed_deviation(double rms_radius, double diagonal, const SimilarityOptions& options,
                         double share_of_diagonal = 1) {
    const double of_diagonal = share_of_diagonal * options.tolerance_of_diagonal * diagonal / rms_radius;
    return diagonal > 0 ? std::min(options.tolerance, of_diagonal) : options.tolerance;
}

double dot_unit(const Style& style) { return paints_stroke(style) ? style.stroke.width : 1.0; }

constexpr const char* stage = "similarity";

/// The work of match_elements, one member function a step.
class ElementMatcher {
  public:
    ElementMatcher(const Scene& scene, const SimilarityOptions& options)
        : scene_(scene),
          options_(options),
          diagonal_(drawing_diagonal(scene)),
          first_copy_(scene.elements.size(), -1),
          item_of_(scene.elements.size(), -1) {
        matching_.matches.resize(scene.elements.size());
    }

    ShapeMatching run(const Progress& progress) {
        collect_outlines(progress);
        describe_outlines(progress);
        const OutlineClasses classes = classify_outlines(items_, class_options(), progress);
        place_elements(classes);
        number_by_appearance();
        find_symmetries(progress);
        return std::move(matching_);
    }

  private:
    OutlineClassOptions class_options() const {
        constexpr double smallest_cell = 0.02;  // of keys: far more than the rounding of two decimals moves them
        constexpr double smallest_residual = 2e-3;
        return {std::max(smallest_cell, 2.5 * options_.tolerance), std::max(smallest_residual, 2 * options_.tolerance),
                options_.mirrored_copies};
    }

    void collect_outlines(const Progress& progress) {
        MovedCopies copies;
        outlines_.resize(scene_.elements.size());
        for_each_index(outlines_.size(), options_.threads, stage, progress, [&](std::size_t i, const Progress&) {
            const Element& element = scene_.elements[i];
            if (element.verbatim.empty()) outlines_[i] = outline_of(element.paths, element.style);
        });
        for (std::size_t i = 0; i < outlines_.size(); ++i) {
            if (scene_.elements[i].verbatim.empty()) first_copy_[i] = copies.first_copy(outlines_, static_cast<int>(i));
        }
    }

    void describe_outlines(const Progress& progress) {
        std::vector<Descriptor> descriptors(outlines_.size());
        for_each_index(outlines_.size(), options_.threads, stage, progress, [&](std::size_t i, const Progress&) {
            if (first_copy_[i] == static_cast<int>(i)) descriptors[i] = describe(outlines_[i]);
        });
        for (std::size_t i = 0; i < outlines_.size(); ++i) {
            const int first = first_copy_[i];
            if (first < 0) continue;
            if (first != static_cast<int>(i)) {
                item_of_[i] = item_of_[static_cast<std::size_t>(first)];
                if (item_of_[i] >= 0) ++items_[static_cast<std::size_t>(item_of_[i])].count;
                continue;
            }
            const Descriptor& descriptor = descriptors[i];
            if (!(descriptor.rms_radius > dot_share * diagonal_)) continue;
            item_of_[i] = static_cast<int>(items_.size());
            items_.push_back({&outlines_[i], descriptor, allowed_deviation(descriptor.rms_radius, diagonal_, options_), 1});
            element_of_item_.push_back(static_cast<int>(i));
        }
    }

    void place_elements(const OutlineClasses& classes) {
        for (const OutlineGroup& group : classes.groups)
            matching_.classes.push_back({element_of_item_[static_cast<std::size_t>(group.representative)]});
        for (std::size_t i = 0; i < outlines_.size(); ++i) {
            if (first_copy_[i] < 0) continue;
            matching_.matches[i] = item_of_[i] < 0 ? dot_match(i) : outline_match(i, classes);
        }
    }

    ShapeMatch outline_match(std::size_t element, const OutlineClasses& classes) const {
        const std::size_t item = static_cast<std::size_t>(item_of_[element]);
        const Descriptor& d = items_[item].descriptor;
        const Outline& described = *items_[item].outline;
        const Point moved = outlines_[element].origin - described.origin;
        const Similarity own_frame{{d.rms_radius, 0}, d.centroid + moved, false};
        return {classes.members[item].group, own_frame * classes.members[item].map};
    }

    ShapeMatch dot_match(std::size_t element) {
        if (dot_class_ < 0) {
            dot_class_ = static_cast<int>(matching_.classes.size());
            ShapeClass dots{static_cast<int>(element)};
            dots.symmetry.continuous = true;
            dots.dots = true;
            matching_.classes.push_back(dots);
        }
        const Descriptor d = describe(outlines_[element]);
        return {dot_class_, {{dot_unit(scene_.elements[element].style), 0}, d.centroid, false}};
    }

    void number_by_appearance() {
        std::vector<int> number(matching_.classes.size(), -1);
        std::vector<ShapeClass> ordered;
        for (ShapeMatch& match : matching_.matches) {
            if (match.shape < 0) continue;
            int& n = number[static_cast<std::size_t>(match.shape)];
            if (n < 0) {
                n = static_cast<int>(ordered.size());
                ordered.push_back(matching_.classes[static_cast<std::size_t>(match.shape)]);
            }
            match.shape = n;
        }
        matching_.classes = std::move(ordered);
    }

    /// A symmetry may be used by every member, so the largest member says how exact it must be; and it adds to the member's
    /// own deviation, hence half the share of the diagonal. The whole share for circles: one that fills the picture is off
    /// by nearly as much, as all curves are that stand for circles, and must not make small ones lose their roundness.
    void find_symmetries(const Progress& progress) {
        std::vector<double> largest(matching_.classes.size(), 0);
        for (const ShapeMatch& match : matching_.matches)
            if (match.shape >= 0) {
                double& r = largest[static_cast<std::size_t>(match.shape)];
                r = std::max(r, scale_of(match.pose));
            }
        for (std::size_t c = 0; c < matching_.classes.size(); ++c) {
            report(progress, stage, 1);
            ShapeClass& shape = matching_.classes[c];
            const int item = item_of_[static_cast<std::size_t>(shape.representative)];
            if (item < 0) continue;
            const OutlineItem& representative = items_[static_cast<std::size_t>(item)];
            const double allowed = allowed_deviation(largest[c], diagonal_, options_, 0.5);
            const double allowed_of_circle = allowed_deviation(largest[c], diagonal_, options_);
            shape.symmetry =
                symmetry_of(representative.descriptor.moments, fine_outline_of(representative), allowed, allowed_of_circle);
        }
    }

    const Scene& scene_;
    const SimilarityOptions& options_;
    double diagonal_;
    std::vector<Outline> outlines_;
    std::vector<int> first_copy_;  ///< of each element: the first moved copy; -1 = verbatim
    std::vector<int> item_of_;     ///< of each element: its outline in items_; -1 = dot or verbatim
    std::vector<OutlineItem> items_;
    std::vector<int> element_of_item_;
    int dot_class_ = -1;
    ShapeMatching matching_;
};

}  // namespace

ShapeMatching match_elements(const Scene& scene, const SimilarityOptions& options, const Progress& progress) {
    return ElementMatcher(scene, options).run(progress);
}

}  // namespace rinceau
