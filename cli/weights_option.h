#pragma once
// --weights n=..,h=..,phi=..,l=.. and --objective bits|paper

#include <string>

#include "analyzer/analyze.h"

namespace rinceau {

/// Reads a list such as "n=2,phi=0.5"; what is not named stays 1. Throws CLI::ValidationError naming the part at fault:
/// an unknown or repeated name, or a value that is not a number from 0 to 4.
ImportanceWeights parse_weights(const std::string& text);

/// Throws CLI::ValidationError for any other word.
Objective parse_objective(const std::string& text);

}  // namespace rinceau
