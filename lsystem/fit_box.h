#pragma once
// Laying one box into another, as turtle commands.

#include <vector>

#include "geometry/box.h"
#include "geometry/similarity.h"
#include "lsystem/grammar_names.h"

namespace rinceau {

/// How large the new thing is: as it is; as large as fits into the place of the old one; as small as covers it; as wide; as
/// high.
enum class ReplaceFit : unsigned char { none, inside, cover, width, height };

/// By how much `content` is scaled for `place`. A side without extent does not count; 1 if none counts.
double fitted_scale(const Box& content, const Box& place, ReplaceFit fit);

/// Scales the content by fitted_scale and moves its centre to the centre of the place. Identity if one of both is empty.
Similarity fitted(const Box& content, const Box& place, ReplaceFit fit);

constexpr int fit_digits = 6;     ///< a millionth of a size is far below what can be seen
constexpr int exact_digits = 14;  ///< beyond the rounding of what was computed

/// To so many significant digits of `size`, a length: a number that is short in text.
double rounded_in(double value, double size, int digits = fit_digits);
double rounded_factor(double value, int digits = fit_digits);

/// "f(12) -(90) f(3) +(90) *(0.5) +(30)", what is nothing left out; lengths are rounded in `size`.
ModuleTemplates turtle_modules(const Similarity& map, double size, int digits = fit_digits);

}  // namespace rinceau
