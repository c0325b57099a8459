#pragma once
// With which options the drawing is, or will be, analysed.

#include "editor/model/editor_state.h"

namespace rinceau {

/// The options that the user last asked for: those of the analysis that runs or waits to run, else the document's.
AnalyzeOptions wished_analysis(const EditorState& state);

/// The options as they are at first; groups made by hand stay.
AnalyzeOptions default_analysis(const EditorState& state);

// The regular layout and noise exclude each other: the one that is set last holds.
void set_symmetrize(AnalyzeOptions& options, bool on);
void set_stochastic(AnalyzeOptions& options, bool on);

}  // namespace rinceau
