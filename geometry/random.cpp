#include "geometry/random.h"

#include <cmath>

#include "geometry/angle.h"

namespace rinceau {

std::uint32_t Random::next() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005ULL + 1442695040888963407ULL;
    const auto xorshifted = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
    const auto turn = static_cast<std::uint32_t>(old >> 59U);
    return (xorshifted >> turn) | (xorshifted << ((32U - turn) & 31U));
}

double Random::uniform() {
    const auto high = static_cast<std::uint64_t>(next()) >> 5U;
    const auto low = static_cast<std::uint64_t>(next()) >> 6U;
    return static_cast<double>((high << 26U) | low) * 0x1.0p-53;
}

std::uint32_t Random::below(std::uint32_t count) {
    return static_cast<std::uint32_t>((static_cast<std::uint64_t>(next()) * count) >> 32U);
}

double Random::normal() {
    // Box and Muller 1958; the second number of the pair is dropped to keep the state a single integer.
    const double u = 1.0 - uniform();
    const double v = uniform();
    return std::sqrt(-2 * std::log(u)) * std::cos(two_pi * v);
}

}  // namespace rinceau
