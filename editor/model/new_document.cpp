#include "editor/model/new_document.h"

#include "lsystem/grammar_text.h"

namespace rinceau {
namespace {

// Three squares of 40, 60 apart, in the middle of the canvas.
constexpr const char* text = R"(canvas -60 -60 240 120

axiom: Row(3)

# a row of squares
Row(n) : n > 0 -> [Square] -(90) f(60) +(90) Row(n-1)

style 1: fill #3b6ea5

terminal Square: style 1; path "M-20 -20L20 -20L20 20L-20 20Z"
)";

}  // namespace

Document new_document() { return with_grammar(empty_document(), parse_grammar(text, "new document")); }

}  // namespace rinceau
