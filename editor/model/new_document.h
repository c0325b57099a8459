#pragma once
// What a new document holds.

#include "editor/model/document.h"

namespace rinceau {

/// A row of three squares: the smallest grammar with a rule, a count and a distance to change.
Document new_document();

}  // namespace rinceau
