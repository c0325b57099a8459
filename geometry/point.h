#pragma once
// A point, a vector or a complex number of the plane: which one a value is, its name says.
// Multiplication is the complex product, so that "turn and scale" is one product.

#include <cmath>

namespace rinceau {

struct Point {
    double x = 0;
    double y = 0;

    friend constexpr bool operator==(const Point&, const Point&) = default;
};

/// A complex number; the same struct, named so where it turns and scales.
using Complex = Point;

constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
constexpr Point operator-(Point a) { return {-a.x, -a.y}; }
constexpr Point operator*(double k, Point a) { return {k * a.x, k * a.y}; }
constexpr Point operator*(Point a, double k) { return {k * a.x, k * a.y}; }
constexpr Point operator/(Point a, double k) { return {a.x / k, a.y / k}; }
constexpr Point& operator+=(Point& a, Point b) { return a = a + b; }
constexpr Point& operator-=(Point& a, Point b) { return a = a - b; }

/// Complex product.
constexpr Complex operator*(Complex a, Complex b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }
constexpr Complex conj(Complex a) { return {a.x, -a.y}; }
constexpr double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
/// Squared length.
constexpr double norm(Point a) { return a.x * a.x + a.y * a.y; }
/// Length; coordinates must stay below 1e150.
inline double abs(Point a) { return std::sqrt(norm(a)); }
/// Angle from +x, counter-clockwise, in (-pi, pi]; 0 for the zero vector.
inline double arg(Point a) { return std::atan2(a.y, a.x); }
/// Complex quotient; b must not be zero.
constexpr Complex operator/(Complex a, Complex b) {
    const double n = norm(b);
    return {(a.x * b.x + a.y * b.y) / n, (a.y * b.x - a.x * b.y) / n};
}
inline Complex polar(double length, double angle) { return {length * std::cos(angle), length * std::sin(angle)}; }

}  // namespace rinceau
