#pragma once
// What of growth is seen on the canvas and in the panel.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "editor/model/editor_state.h"

namespace rinceau {

struct Exemplar;  // growth/arrangement/exemplar.h

/// Is the panel of growth open?
bool growth_is_open(const EditorState& state);

/// Is what has grown on the canvas in the document's place?
bool shows_grown(const EditorState& state);

/// The picture on the canvas: what has grown, or the document. May be null.
const std::shared_ptr<const DerivedPicture>& canvas_picture(const EditorState& state);

/// What the left mouse button does on the canvas.
GrowthBrush brush_on_canvas(const EditorState& state);

/// The source that belongs to the document and the settings; null while it is being read, or if it was not asked for.
const GrowthSource* current_source(const EditorState& state);

/// What would be asked for at this moment.
SourceQuestion source_question(const EditorState& state);

/// The radius of the spray, scene units; 0 while no exemplar is known.
double spray_radius(const EditorState& state);

/// Where an arrangement or an aggregate is to grow.
Box growth_canvas(const EditorState& state);

/// Are edges between neighbours to be drawn over the canvas: of what has grown or of the exemplar, whichever is shown?
bool shows_edges(const EditorState& state);

/// The exemplar's; of a tile, those at its own elements.
std::vector<std::array<Point, 2>> edges_of(const Exemplar& exemplar);

/// The edge of the exemplar's connectivity at `at`, as numbers of elements.
std::optional<std::pair<int, int>> exemplar_edge_at(const Exemplar& exemplar, Point at, double reach);

/// Symbols of which every expansion may be one element.
std::vector<std::string> symbols_to_raise(const Grammar& grammar);

/// Something stands that can be used, grown on or dropped.
bool has_grown(const EditorState& state);

/// That is an arrangement.
bool has_arrangement(const EditorState& state);

}  // namespace rinceau
