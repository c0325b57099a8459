#pragma once
// Mistakes that are collected while reading goes on. Internal to lsystem and growth.

#include <string>
#include <vector>

#include "scene/input_error.h"

namespace rinceau {

/// Nobody reads more of them, and texts that are no grammar at all have any number.
constexpr std::size_t max_mistakes = 1000;

/// The message of an error without its place.
Warning warning_of(const InputError& error);

/// At most max_mistakes are kept. False if there was no room.
bool add_mistake(std::vector<Warning>& mistakes, const SourcePlace& place, const std::string& message);
bool add_mistake(std::vector<Warning>& mistakes, const InputError& error);

}  // namespace rinceau
