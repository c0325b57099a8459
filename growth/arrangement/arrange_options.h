#pragma once
// How an arrangement grows: the choices that a user has (Ijiri et al. 2008, section 5).

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/box.h"
#include "growth/arrangement/boundary.h"
#include "growth/flow_field.h"

namespace rinceau {

/// Section 5.3: elements keep their angle; rings are turned to fit best (eq. 4); the exemplar's x axis follows the flow.
enum class RotationMode : std::uint8_t { fixed, rotate, flow };

/// How neighbours of a seed and of a reference are matched: nearest places, some may stay unmatched; or the cyclic orders of
/// the paper (section 5.2), none skipped.
enum class RingMatching : std::uint8_t { nearest, cyclic };

/// Weights of the error (eq. 2); distances count in mean edges l.
struct MatchWeights {
    double distance = 1;
    double symbol = 1;
    double sub_id = 0.3;  ///< neighbours must not be the same element of the drawing again and again
    double repeat = 0.3;  ///< against one element of the drawing in rows (not in the paper)
    double balance = 2;   ///< against shares of symbols that drift (not in the paper)
};
/// w = (1, 1, 100) as the paper prints them, without what it does not have.
constexpr MatchWeights paper_weights() { return {1, 1, 100, 0, 0}; }

struct ArrangeOptions {
    RotationMode mode = RotationMode::fixed;
    RingMatching matching = RingMatching::nearest;
    MatchWeights weights;
    std::vector<int> priorities;  ///< per symbol, higher grows first (section 5.1); empty = all alike
    bool two_rings = false;       ///< compares also the neighbours' neighbours: copies the exemplar more closely
    bool relax = true;            ///< eq. 5 and 6
    bool finish = true;           ///< repairs irregular arrangements at the end (not in the paper)
    std::uint64_t seed = 1;
    int threads = 0;
};

/// What is around: shared and never changed.
struct ArrangeSurroundings {
    std::shared_ptr<const FlowField> flow;      ///< needed in mode flow
    std::shared_ptr<const Boundary> boundary;   ///< null = none
};

/// A round brush (section 5.1, spray tool).
struct Brush {
    Point center;
    double radius = 0;
};

/// How far to grow now.
struct GrowOrder {
    std::size_t count = std::numeric_limits<std::size_t>::max();  ///< elements in all, those that stand already among them
    std::optional<Brush> brush;  ///< only seeds below it, nearest to its centre first
    /// Asked between steps; true ends the growth, and what stands by then is a valid arrangement.
    std::function<bool()> stop;
};

/// One element of the result.
struct ArrangedElement {
    int reference = 0;  ///< element of the exemplar
    Point position;
    double angle = 0;   ///< that the reference's outline is turned by
};

}  // namespace rinceau
