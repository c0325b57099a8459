#pragma once
// Clusters outlines by invariant key and checked alignment, whatever they belong to.

#include <optional>
#include <vector>

#include "analyzer/align.h"
#include "analyzer/moments.h"
#include "analyzer/outline_distance.h"
#include "geometry/progress.h"

namespace rinceau {

/// An outline to be classed. rms_radius > 0.
struct OutlineItem {
    const Outline* outline = nullptr;
    Descriptor descriptor;
    double distance = 0;  ///< how far a copy may deviate, in its own unit frame
    int count = 1;        ///< elements that have it
};

/// Unit frame of the representative -> unit frame of the member.
struct OutlineMember {
    int group = -1;
    Similarity map;
    double residual = 0;  ///< of moments; near rounding for exact copies
};

struct OutlineGroup {
    int representative = -1;
    std::vector<int> members;  ///< rising
};

struct OutlineClasses {
    std::vector<OutlineGroup> groups;  ///< by least member
    std::vector<OutlineMember> members;
};

struct OutlineClassOptions {
    double key_cell = 0.02;          ///< largest difference of invariant keys that is looked at
    double moment_residual = 0.008;  ///< largest residual of an alignment that is looked at
    bool mirrored_copies = true;
};

/// Every member is within its `distance` of its group's representative, both ways.
OutlineClasses classify_outlines(const std::vector<OutlineItem>& items, const OutlineClassOptions& options,
                                 const Progress& progress = {});

FineOutline fine_outline_of(const OutlineItem& item);

}  // namespace rinceau
