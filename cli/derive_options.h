#pragma once
// The options that every verb has which derives a grammar.

#include <cstdint>

#include <CLI/App.hpp>

#include "lsystem/derive.h"

namespace rinceau {

/// So many modules fit into a gigabyte, placed and written as SVG.
constexpr std::uint64_t default_max_modules = 2'000'000;

/// --depth, --seed, --max-modules.
void add_derive_options(CLI::App& verb, DeriveOptions& options);

}  // namespace rinceau
