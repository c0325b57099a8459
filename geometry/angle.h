#pragma once
// Angles: radians counter-clockwise everywhere in code; degrees only in text and on screens.

#include <cmath>
#include <numbers>

namespace rinceau {

constexpr double pi = std::numbers::pi;
constexpr double two_pi = 2 * std::numbers::pi;

constexpr double degrees(double radians) { return radians * 180.0 / pi; }
constexpr double radians(double degrees) { return degrees * pi / 180.0; }

/// The same direction in (-pi, pi].
inline double wrap_angle(double angle) {
    const double wrapped = std::remainder(angle, two_pi);
    return wrapped <= -pi ? wrapped + two_pi : wrapped;
}

}  // namespace rinceau
