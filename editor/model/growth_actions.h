#pragma once
// Growth: more of the same from the document, seen as a preview until it is used.

#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "editor/model/document.h"
#include "editor/model/growth_settings.h"
#include "geometry/point.h"

namespace rinceau {

struct GrowthSource;  // growth_source.h
struct GrownPattern;  // grown_pattern.h

/// The panel is shown with this tab.
struct OpenGrowth {
    GrowthTab tab = GrowthTab::arrangement;
};
struct SetGrowth {
    GrowthSettings settings;
};
/// What the left mouse button does on the canvas; a canvas to paint on is shown for it. The brush that is taken already is
/// put away.
struct TakeBrush {
    GrowthBrush brush = GrowthBrush::none;
};

/// The mouse on the canvas with a brush: scene points; `reach` is how near is on it, scene units.
struct PressBrush {
    Point at;
    double reach = 0;
};
struct DragBrush {
    Point to;
    double reach = 0;
};
struct ReleaseBrush {
    double reach = 0;
};
struct DropStroke {};  ///< that is being drawn

/// Strokes of the brush flow or boundary: the last one goes, or all.
struct EraseStrokes {
    GrowthBrush of = GrowthBrush::flow;
    bool all = false;
};
/// The connectivity of the exemplar is as it was found again.
struct ForgetFlips {};

/// An arrangement begins anew by its settings; or goes on.
struct BeginGrowth {};
struct GrowMore {};
/// What stands is relaxed; `repair`: and repaired.
struct FinishGrowth {
    bool repair = true;
};
/// An aggregate is filled anew by its settings.
struct FillAggregate {};
/// The next seed, and the same again.
struct GrowOtherSeed {};
/// What has grown until now stays.
struct StopGrowth {};
/// What has grown is not shown any more; it can be brought back until something else is dropped.
struct DropGrowth {};
struct BringBackGrowth {};
/// What has grown becomes the document: one edit.
struct UseGrowth {};
/// What has grown is shown, or the document.
struct ShowGrowth {
    bool shown = true;
};

// Answers.

struct SourceRead {
    std::uint64_t job = 0;
    std::shared_ptr<const GrowthSource> source;
};
struct GrowthProgress {
    std::uint64_t job = 0;
    std::string stage;
    double fraction = 0;
};
/// What stands by now.
struct PatternGrown {
    std::uint64_t job = 0;
    std::shared_ptr<const GrownPattern> pattern;
    bool done = true;  ///< false: more is to come
};
struct GrowthFailed {
    std::uint64_t job = 0;
    std::string message;
};
struct GrownDocumentMade {
    std::uint64_t job = 0;
    std::shared_ptr<const Grammar> before;  ///< of the document that it was made from
    Document document;
};

struct GrowthAction : std::variant<OpenGrowth, SetGrowth, TakeBrush, PressBrush, DragBrush, ReleaseBrush, DropStroke,
                                   EraseStrokes, ForgetFlips, BeginGrowth, GrowMore, FinishGrowth, FillAggregate,
                                   GrowOtherSeed, StopGrowth, DropGrowth, BringBackGrowth, UseGrowth, ShowGrowth, SourceRead,
                                   GrowthProgress, PatternGrown, GrowthFailed, GrownDocumentMade> {
    using variant::variant;
    GrowthAction(const GrowthAction&);
    GrowthAction(GrowthAction&&) noexcept;
    GrowthAction& operator=(const GrowthAction&);
    GrowthAction& operator=(GrowthAction&&) noexcept;
    ~GrowthAction();
};

}  // namespace rinceau
