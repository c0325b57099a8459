#pragma once
// What is selected on the canvas: a module on the way from the axiom to one drawn element.

#include <optional>
#include <string>
#include <vector>

#include "editor/model/derived_picture.h"
#include "lsystem/derivation_path.h"

namespace rinceau {

constexpr std::size_t deepest_level = static_cast<std::size_t>(-1);

struct Selection {
    std::vector<PathModule> path;  ///< from the axiom (first) to the element (last); never empty
    std::size_t level = 0;         ///< the selected one of the path
};

/// The selected module, and the one above it (the axiom is above itself).
const PathModule& selected_module(const Selection& selection);

/// The order of the element that was clicked.
int selected_element(const Selection& selection);

/// The production in whose successor the selected module stands: -1 = the axiom, -2 = an exception.
int selected_production(const Selection& selection);

/// The levels that a person sees, the axiom first: indices of the path. A module and the exception that stands for it are one.
std::vector<std::size_t> shown_levels(const Selection& selection);

/// What a person reads of one level: "axiom", "Row(5)", "Window".
std::string level_label(const PathModule& module);

/// "3 of 5 in Row, 15 in all": where the module of that level stands and how many there are; empty for the axiom.
std::string level_counts(const Selection& selection, std::size_t level);

/// The element of that order is selected, at the deepest level; if it was the one that was clicked before, the level above is,
/// and after the axiom the element again. An element that was not selected is so at `level`, if its path is so long. Nothing if there is no such element. Throws as
/// interpret().
std::optional<Selection> selection_of_click(const Document& document, int order,
                                            const std::optional<Selection>& before,
                                            std::size_t level = deepest_level, const Progress& progress = {});

/// The same selection in another version of the document, found by its addresses; nothing if it is gone. Throws as
/// interpret().
std::optional<Selection> selection_after_edit(const Document& document, const Selection& before,
                                              const Progress& progress = {});

}  // namespace rinceau
