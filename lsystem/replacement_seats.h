#pragma once
// Where and how large the new thing of a replacement sits, for each set of numbers with which the old one stands. Internal
// to the folder.

#include <map>
#include <optional>
#include <vector>

#include "lsystem/edit_replace.h"
#include "lsystem/measure_symbol.h"
#include "lsystem/replacement_content.h"

namespace rinceau {

/// How the new thing lies in the frame of the old one, and what the old one does to the turtle.
struct Seat {
    Similarity map;
    double size = 1;  ///< a length to round in
    Measure old;
    bool same_move = false;  ///< the new thing moves the turtle as the old one does, and its map is the identity
};

/// Measures a symbol with numbers, each set once.
class OldMeasures {
  public:
    OldMeasures(const Grammar& grammar, std::string symbol, const DeriveOptions& options)
        : grammar_(grammar), symbol_(std::move(symbol)), options_(options) {}

    /// Throws InputError if its move depends on random numbers, or if it was asked for too many sets of numbers.
    const Measure& of(const std::vector<double>& arguments);
    /// By a module whose arguments use constants only; nothing if they use parameters.
    std::optional<Measure> of(const ModuleTemplate& module) const;

  private:
    const Grammar& grammar_;
    std::string symbol_;
    DeriveOptions options_;
    std::map<std::vector<double>, Measure> known_;
};

/// Symbol(arguments).
ModuleTemplate with_arguments(const std::string& symbol, const std::vector<double>& arguments);

/// The string of a content in the place of `module`: with its arguments, if they are passed on.
ModuleTemplates content_string(const Content& content, const ModuleTemplate& module);

/// `grammar` has old and new things and no `use`.
Seat seat_of(const Grammar& grammar, const Content& content, const ModuleTemplate& module, const Measure& old,
             const ReplaceOptions& options);

/// Seats that differ by less than can be seen.
bool same_seat(const Seat& a, const Seat& b);

/// The commands that take back what is in force: `;(0) fill stroke`, as far as needed.
ModuleTemplates without_colouring(const std::vector<Colouring>& in_force);

/// What is written in the place of a module: `before`, then the content. last: nothing behind the module depends on the
/// turtle.
ModuleTemplates seated(const ModuleTemplates& content, const Seat& seat, const ModuleTemplates& before, bool last);

}  // namespace rinceau
