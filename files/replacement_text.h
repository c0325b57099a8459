#pragma once
// What takes the place of a symbol, as a person writes it.

#include <string>
#include <vector>

#include "lsystem/edit_replace.h"
#include "scene/input_error.h"

namespace rinceau {

struct WrittenReplacement {
    Replacement replacement;
    std::vector<Warning> warnings;  ///< of a drawing
};

/// Throws InputError if `with` cannot be what takes the place of a symbol, whatever the files are that it names.
void expect_replacement_text(const std::string& with);

/// `with` is modules ("Leaf", "Ring(8)"), a drawing ("leaf.svg"), a grammar ("vine.lsys") or a part of one
/// ("vine.lsys#Grapes"), or nothing. Reads the file. Throws as expect_replacement_text(), read_input(), read_svg() and
/// read_grammar().
WrittenReplacement read_replacement(const std::string& symbol, const std::string& with);

}  // namespace rinceau
