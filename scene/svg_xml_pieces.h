#pragma once
// Deep XML cut into shallow pieces, because the XML library reads no more than 99 levels; and white space between
// the words of a text element made visible to it.

#include <string>
#include <vector>

#include "scene/input_error.h"

namespace rinceau {

/// Part of a document. Its elements at level `piece_depth` (children of the root are at level 2) are left empty; what
/// stood in them are the pieces `inner`, one for each such element in document order.
struct XmlPiece {
    std::string text;
    int first_line = 1;  ///< the line of the document that the text begins on
    std::vector<std::size_t> inner;
};

/// Elements at this level of a piece have their content in a piece of its own.
constexpr int piece_depth = 64;

/// Piece 0 holds the root element; every other piece is the content of one element wrapped in an element `x`.
/// Throws InputError with line and column where tags do not match or something is left open.
std::vector<XmlPiece> cut_into_pieces(const std::string& text, const std::string& file_name);

}  // namespace rinceau
