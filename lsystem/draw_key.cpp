#include "lsystem/draw_key.h"

#include <array>
#include <cmath>
#include <numbers>

namespace rinceau {

namespace {

/// Natural logarithm of a number in (0, 1]: x = m 2^e with m about 1, log m = 2 artanh((m - 1) / (m + 1)).
double logarithm(double x) {
    int exponent = 0;
    double mantissa = std::frexp(x, &exponent);
    if (mantissa < std::numbers::sqrt2 / 2) {
        mantissa *= 2;
        --exponent;
    }
    const double s = (mantissa - 1) / (mantissa + 1);
    const double square = s * s;
    constexpr int last_term = 11;  // |s| < 0.172: what is left out is below 1e-18 of the sum
    double sum = 0;
    for (int n = last_term; n >= 0; --n) sum = sum * square + 1.0 / (2 * n + 1);
    return exponent * std::numbers::ln2 + 2 * s * sum;
}

/// The sum of (-square)^n / ((first + 1)(first + 2) .. (first + 2n)): the cosine's series for first = 0, sine's for 1.
double alternating_series(double square, int first) {
    constexpr int last_term = 9;  // for angles up to pi/4: what is left out is below 1e-18
    double sum = 1;
    for (int n = last_term; n > 0; --n) {
        const int k = first + 2 * n;
        sum = 1 - sum * square / (k * (k - 1));
    }
    return sum;
}

/// Cosine of a part of a full turn in [0, 1).
double cosine_of_turn(double turn) {
    const double quarters = std::floor(4 * turn + 0.5);
    const double angle = 2 * std::numbers::pi * (turn - quarters / 4);  // within pi/4 of the nearest quarter
    const double square = angle * angle;
    const double cosine = alternating_series(square, 0);
    const double sine = angle * alternating_series(square, 1);
    const std::array<double, 5> by_quarter{cosine, -sine, -cosine, sine, cosine};
    return by_quarter[static_cast<std::size_t>(quarters)];
}

}  // namespace

double exponential_draw(DrawKey key) { return -logarithm(1 - uniform_draw(key)); }

double normal_draw(DrawKey key) {
    return std::sqrt(2 * exponential_draw(key)) * cosine_of_turn(uniform_draw(key_below(key, 0)));
}

}  // namespace rinceau
