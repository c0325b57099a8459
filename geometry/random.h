#pragma once
// Random numbers that are the same on every machine: PCG32 (O'Neill 2014, pcg-random.org) with mappings of our own,
// because the standard distributions differ between libraries.

#include <cstdint>

namespace rinceau {

class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(0) {
        next();
        state_ += seed;
        next();
    }
    /// 32 uniform random bits.
    std::uint32_t next();
    /// Uniform in [0, 1).
    double uniform();
    /// Uniform in [low, high).
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    /// Uniform in {0, .., count - 1}; count must be positive.
    std::uint32_t below(std::uint32_t count);
    /// Normal with mean 0 and standard deviation 1.
    double normal();

  private:
    std::uint64_t state_;
};

}  // namespace rinceau
