#pragma once
// What `rinceau grow` grows, and on what.

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "cli/grow_options.h"
#include "growth/surface/surface_world.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// A shape grammar, or the rules of a drawing.
struct GrowInput {
    std::string label;
    std::variant<ShapeGrammar, Grammar> grammar;
    std::vector<std::string> warnings;  ///< they were said
    std::vector<Warning> mistakes;      ///< of a shape grammar, as `rinceau check` names them but for those in files
};

/// Reads the input; drawings are analysed. A shape grammar is what looks so, or is called .fgsg. Params are set, the plane's
/// size and the field replaced as the options say. Throws as read_input(), with_params(), read_svg(), read_grammar() and
/// analyze(), and CLI::ValidationError for options that are for the other kind of input.
GrowInput read_grow_input(const GrowVerbOptions& options);

/// Reads files by the names that the grammar gives them, beside the grammar's own file; but --field as it was given.
ReadNamedFile grammar_files(const GrowVerbOptions& options);

/// The surface, repaired if that is asked for; none for the plane. Says warnings and adds them. Throws as read_surface().
std::shared_ptr<const SurfaceMesh> read_ground(const GrowVerbOptions& options, std::vector<std::string>& warnings);

/// The source that --field says. Throws InputError in the name of --field.
ShapeSource field_of_option(const std::string& text);

}  // namespace rinceau
