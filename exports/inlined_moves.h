#pragma once
// Rules that only move the turtle, written out where they are used: for programs whose shapes move nothing but what is
// inside them. Internal to the folder.

#include <optional>

#include "lsystem/grammar.h"

namespace rinceau {

/// A grammar with plain rules (lsystem/plain_rules.h) that draws the same: a symbol with one production, without condition
/// and not recursive, is replaced by what it stands for where the turtle needs what it leaves behind - unless it draws and
/// has numbers for arguments, for then its whole move is a number. Nothing if that grows beyond reason.
std::optional<Grammar> inlined_moves(const Grammar& grammar);

/// No parameters in it and nothing drawn by chance: the same wherever the string is met.
bool is_constant(const ModuleTemplate& module, const std::vector<std::string>& parameters);

}  // namespace rinceau
