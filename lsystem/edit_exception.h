#pragma once
// Exceptions for one module of the derivation, made by hand.

#include <vector>

#include "lsystem/derivation_path.h"
#include "lsystem/edit_result.h"

namespace rinceau {

/// path[level] alone is moved, turned or scaled: `by` maps the scene to itself. What was written at its address is kept;
/// an exception that says nothing any more goes away. What follows in the derivation stands where it stood. Numbers are as
/// short as `tolerance` (scene units) allows. `path` is of this grammar. Throws InputError if the module has no address: the
/// axiom, a branch of a rule that branches into itself; and for grammars with contexts.
EditResult move_instance(const Grammar& grammar, const std::vector<PathModule>& path, std::size_t level,
                         const Similarity& by, double tolerance);

/// path[level] alone draws nothing any more. Throws as move_instance().
EditResult erase_instance(const Grammar& grammar, const std::vector<PathModule>& path, std::size_t level);

}  // namespace rinceau
