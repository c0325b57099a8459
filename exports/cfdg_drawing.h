#pragma once
// What all Context Free files have: the head, a path per look, adjustments. Internal to the folder.

#include <set>
#include <string>
#include <utility>

#include "exports/unique_names.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// Words of the language and its own shapes, which name nothing else.
std::set<std::string> cfdg_words();

/// Comment lines, the start shape, the canvas and the limits. `most` is the largest whole number that the rules use.
std::string cfdg_head(const Grammar& grammar, const std::string& start, double most);

/// Collects sentences, each once, in order.
class NoteList {
  public:
    void add(const std::string& note);
    const std::vector<std::string>& notes() const { return notes_; }

  private:
    std::vector<std::string> notes_;
};

/// Does the look leave anything that Context Free can draw?
bool cfdg_draws(const Terminal& terminal, const Style& style);

/// "path Name { .. }" for a terminal that is drawn in a style.
std::string cfdg_path(const std::string& name, const Terminal& terminal, const Style& style);

/// What of the look Context Free cannot hold, into the notes.
void note_losses(const Terminal& terminal, const Style& style, NoteList& notes);

}  // namespace rinceau
