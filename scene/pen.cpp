#include "scene/pen.h"

#include <algorithm>
#include <cmath>

namespace rinceau {

double largest_stretch(const Linear2& pen) {
    const double sum = pen.a * pen.a + pen.b * pen.b + pen.c * pen.c + pen.d * pen.d;
    const double det = pen.a * pen.d - pen.b * pen.c;
    return std::sqrt(0.5 * (sum + std::sqrt(std::max(0.0, sum * sum - 4 * det * det))));
}

}  // namespace rinceau
