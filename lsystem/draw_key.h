#pragma once
// Random draws by key instead of in sequence. Every module of a derivation has a key: the seed for the axiom, and below a
// module's key the place of a symbol among the symbols of the string that took the module's place. A draw has the key of the
// module whose production draws it, and a salt that says where in that production it stands (compile.cpp). So a draw depends
// on nothing but the way to it: not on what was drawn before, on counts, conditions, parameters or the depth.
// Internal to lsystem and growth.

#include <cstdint>

namespace rinceau {

using DrawKey = std::uint64_t;

/// A bijection of 64 bits in which every bit of the result depends on every bit of the argument (finalizer of SplitMix64:
/// Steele, Lea, Flood 2014, with the constants of Stafford's variant 13).
constexpr std::uint64_t mixed_bits(std::uint64_t bits) {
    bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebULL;
    return bits ^ (bits >> 31U);
}

/// The key one step further: the keys below one key are the numbers that SplitMix64 gives from it as its seed.
constexpr DrawKey key_below(DrawKey key, std::uint64_t step) {
    constexpr std::uint64_t golden_ratio = 0x9e3779b97f4a7c15ULL;
    return mixed_bits(key + (step + 1) * golden_ratio);
}

/// The key of a grammar's axiom.
constexpr DrawKey root_key(std::uint64_t seed) { return key_below(mixed_bits(seed), 0); }

/// Uniform in [0, 1), a multiple of 2^-53.
constexpr double uniform_draw(DrawKey key) {
    constexpr unsigned spare_bits = 11;  // a double holds 53
    return static_cast<double>(key >> spare_bits) * 0x1.0p-53;
}

/// Normal with mean 0 and deviation 1, below 8.6 in size. Box and Muller 1958 over a logarithm and a cosine made of
/// operations that IEEE 754 rounds exactly, so that all machines agree in every bit; within 1e-14 of the exact value.
double normal_draw(DrawKey key);

/// Exponential with mean 1, not below 0; as exact as normal_draw.
double exponential_draw(DrawKey key);

}  // namespace rinceau
