#pragma once
// The independent check: does a grammar draw the scene that it was made from? Knows nothing of how rules are found.

#include <string>
#include <vector>

#include "analyzer/overlaps.h"
#include "lsystem/grammar.h"
#include "scene/element.h"

namespace rinceau {

struct VerifyOptions {
    double tolerance = 2e-4;  ///< largest outline deviation that passes, share of the diagonal
    int threads = 0;          ///< 0 = one per processor; the result is the same for any number
};

struct Verification {
    bool passed = false;
    int elements = 0;     ///< in the scene
    int unmatched = 0;    ///< elements of the scene that nothing draws
    int surplus = 0;      ///< drawn elements that the scene does not have
    int displaced = 0;    ///< drawn, but further off than the tolerance (up to four times as far; beyond, it is unmatched)
    int wrong_style = 0;  ///< drawn in the right place in another style
    int wrong_order = 0;  ///< overlapping pairs, painted differently, in the wrong order (overlaps.h)
    std::vector<OverlapPair> exchanged_faint;  ///< pairs whose order hardly shows, in the wrong order: no fault
    double max_deviation = 0;  ///< of outlines, share of the diagonal, over matched elements
    double rms_deviation = 0;
    std::vector<int>
        faulty;           ///< scene elements that are unmatched, displaced, wrong in style or in order; rising, no repeats
    std::string summary;  ///< one sentence for the user
};

/// Derives the grammar afresh and compares outline by outline (both ways, along the curves), style by style, and the paint
/// order of every pair that find_overlaps lists: those whose order a picture 900 pixels wide shows. Passed = all counts of
/// faults are 0.
Verification verify(const Grammar& grammar, const Scene& scene, const VerifyOptions& options = {});

/// The same with the scene's overlaps at hand: whatever pairs are in there must be painted in the drawing's order.
Verification verify(const Grammar& grammar, const Scene& scene, const Overlaps& overlaps, const VerifyOptions& options = {},
                    const Progress& progress = {});

}  // namespace rinceau
