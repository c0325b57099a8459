#pragma once
// Growth: what is set, drawn and grown; nothing of it is the document.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "editor/model/arrange_steps.h"
#include "editor/model/growth_settings.h"
#include "editor/model/source_question.h"

namespace rinceau {

struct GrowthSource;  // growth_source.h
struct GrownPattern;  // grown_pattern.h

enum class GrowthWork : unsigned char { none, arranging, filling, using_it };

struct GrowthState {
    GrowthSettings settings;

    std::shared_ptr<const GrowthSource> source;  ///< that was read last; null = none was
    std::optional<SourceQuestion> asked;         ///< what the source that is being read was asked
    std::uint64_t source_job = 0;
    std::vector<std::pair<int, int>> flips;   ///< edges that were flipped by hand
    std::shared_ptr<const Grammar> followed;  ///< the document's, as it was last looked at

    std::shared_ptr<const GuideLines> guides = std::make_shared<const GuideLines>();
    DrawnStroke stroke;            ///< that is being drawn
    std::optional<Point> sprayed;  ///< where the spray last was, while it is pressed

    GrowthWork work = GrowthWork::none;
    std::uint64_t job = 0;  ///< of the work
    bool stopping = false;  ///< the work was told to end
    std::string stage;
    double fraction = 0;
    std::vector<ArrangeStep> waiting;  ///< for the source or for the end of the work
    bool fill_waits = false;           ///< an aggregate waits for the source

    std::shared_ptr<const GrownPattern> grown;    ///< null = nothing
    std::shared_ptr<const GrownPattern> dropped;  ///< can be brought back
    bool shown = false;                           ///< `grown` is on the canvas in the document's place
};

}  // namespace rinceau
