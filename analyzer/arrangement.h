#pragma once
// Irregular copies that stand in a regular arrangement (docs/analysis.md, 4.8): what the finders of rows, columns and
// rings share.

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/similarity.h"

namespace rinceau {

/// One of many copies: an element, or an arrangement that was found before.
struct Body {
    Similarity pose;             ///< own frame -> scene, as the drawing has it
    std::vector<int> instances;  ///< elements, one for each slot of its kind
};

/// What turning does to bodies of one kind.
struct BodyForm {
    int fold = 1;                ///< turned by 360 / fold degrees it is the same; 0 = by any angle
    std::optional<double> axis;  ///< a mirror axis of its own, radians in its frame
};

/// Bodies and the places that they ought to have.
struct Arrangement {
    int kind = 0;                   ///< of its bodies, as the caller counts them
    bool is_ring = false;           ///< slot k is slot 0 turned by k / n about the origin, slot 0 stands on the x axis
    std::vector<int> bodies;        ///< in the order of the slots
    std::vector<Similarity> slots;  ///< body frame -> frame of the arrangement, regular
    Similarity whole;               ///< frame of the arrangement -> scene
    BodyForm form;                  ///< of the whole
    std::vector<int> signature;     ///< equal for arrangements of one form
    double spacing = 0;             ///< least distance of neighbours
    double turned = 0;              ///< root mean square of the angles that the bodies are turned by, radians
    double spread = 0;              ///< of the bodies about their places: root mean square of one coordinate, scene length
    double bits_saved = 0;          ///< against places that are written one by one
};

/// How finely bodies are placed, for bits.
struct ArrangementScale {
    double precision = 0;  ///< scene length that counts as one step
    double extent = 0;     ///< diagonal of the drawing
};

/// Chance alone may give such a finding with a probability of 2^this at most.
constexpr double arrangement_chance_bits = -12;

struct CommonLinear {
    Complex linear{1, 0};
    double turned = 0;  ///< root mean square of the angles that the bodies are turned by against it
};

/// Linear part that all bodies may be given: mean direction modulo 360 / fold degrees (none if they are round), geometric
/// mean size. Nothing if a body is turned by more than 25 degrees against it or differs in size by more than a quarter.
std::optional<CommonLinear> common_linear(std::span<const Complex> linears, const BodyForm& form);

/// The direction, or the one that lays an axis of the form along or across the x axis, if this differs by no more than three
/// standard errors.
double laid_along(double direction, const BodyForm& form, double error);

/// How far the angle is from the next multiple of `unit`; 0 if that is more than three standard errors, or if the unit is
/// not clearly more than the error, as anything would be a multiple of it then.
double off_natural(double angle, double unit, double error);

/// Does a body of this direction have a mirror axis along the x axis?
bool lies_along(double direction, const BodyForm& form);

/// Median distance to the nearest other one of the points; 0 for fewer than two.
double median_spacing(std::span<const Point> points);

/// Noise is rough. Are these deviations so smooth from neighbour to neighbour (indices of pairs) that they follow a rule of
/// their own? Mean square difference of neighbours below three tenths of what independent deviations would have.
bool is_smooth(std::span<const Point> deviations, std::span<const std::pair<int, int>> neighbours);

/// The probability, as a power of two and at most 1, that one value falls within the spread about a place, places being
/// `gap` apart.
double log2_hit(double spread, double gap);

}  // namespace rinceau
