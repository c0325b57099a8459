#pragma once
// What update() asks of the world outside; effects/ fulfils it and answers with actions.

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "analyzer/analyze.h"
#include "editor/model/derived_picture.h"
#include "editor/model/document.h"
#include "editor/model/file_actions.h"
#include "editor/model/find_selection.h"
#include "editor/model/orbit_view.h"
#include "editor/model/preferences.h"
#include "editor/model/source_question.h"
#include "editor/model/surface_actions.h"
#include "editor/model/tool_edit.h"
#include "editor/model/view_transform.h"

namespace rinceau {

struct ArrangeOrder;  // arrange_order.h
struct FillOrder;     // fill_order.h
struct GrownPattern;  // grown_pattern.h
struct GrowthSource;  // growth_source.h
struct SurfaceOrder;  // surface_stage.h

/// Answered by FileOpened or FileFailed.
struct ReadDocument {
    std::string path;
};
/// Answered by FileSaved, SaveFailed, WouldReplace if another file stands there and `replace` is false, or
/// FileChangedOutside if the file is not the `expected` one.
struct WriteDocument {
    std::string path;
    Document document;
    ViewTransform view;
    bool replace = false;
    std::optional<FileStamp> expected;
};
/// Answered by ExportProgress and FileExported, ExportFailed or WouldReplace.
struct WriteExport {
    ExportFile what;
    Document document;
};
/// Answered by ExportFailed, once nothing will be written any more.
struct StopExport {};
/// This window has the file open now (empty = none): other windows are warned. Warns by FileHeldElsewhere.
struct HoldFile {
    std::string path;
};
// Folders are named absolutely, with ~, or relative to `from` (empty = where the program was started).
/// Answered by FolderListed or FolderFailed; a later one takes its place.
struct ListFolder {
    std::string folder;
    std::string from;
};
/// Makes it and lists it.
struct MakeFolder {
    std::string folder;
    std::string from;
};
/// Answered by PathSeen.
struct LookAtPath {
    std::string path;
    std::string from;
};
/// Answered by SamplesListed.
struct ListSamples {};
/// The document into this window's copy for emergencies, as opened from `path`. Answered by RecoveryWritten or
/// RecoveryFailed.
struct WriteRecovery {
    Document document;
    ViewTransform view;
    std::string path;
    std::optional<FileStamp> stamp;
};
/// This window's copy goes.
struct RemoveRecovery {};
/// Answered by RecoverablesFound.
struct FindRecoverables {};
/// A copy that was found becomes this window's. Answered by DocumentRecovered or RecoverableFailed.
struct ReadRecovery {
    std::string file;
};
struct DiscardRecovery {
    std::string file;
};
struct WritePreferences {
    Preferences preferences;
};
/// Answered by PictureDerived or PictureFailed; a later one takes its place.
struct DerivePicture {
    std::uint64_t revision = 0;
    Document document;
};
/// Answered by SelectionFound; a later one takes its place.
struct FindSelection {
    SelectionSearch search;
};
/// Answered by RuleLit; a later one takes its place.
struct LightRule {
    std::uint64_t revision = 0;
    Document document;
    int production = -1;
};
/// The picture of the drawing, or else of the grammar. Answered by BeforeDerived, or PictureFailed.
struct DeriveBefore {
    Document document;
};
/// Answered by TextChecked.
struct CheckText {
    std::uint64_t revision = 0;
    std::string text;
    std::string file;
    Document document;
};
/// How deep the document can be derived. Answered by DepthMeasured.
struct MeasureDepth {
    Document document;
};
/// Answered by AnalysisProgress and AnalysisDone or AnalysisFailed; a later one takes its place.
struct RunAnalysis {
    std::uint64_t job = 0;
    std::shared_ptr<const Scene> drawing;
    AnalyzeOptions options;
};
/// Not answered.
struct StopAnalysis {};
/// Answered by ClustersFound or ClustersFailed; a later one takes its place.
struct TabulateClusters {
    std::uint64_t job = 0;
    std::shared_ptr<const Scene> drawing;
    AnalyzeOptions options;
};
/// Answered by ElementsMapped; a later one takes its place.
struct MapElements {
    std::shared_ptr<const DerivedPicture> picture;
    std::shared_ptr<const Scene> drawing;
};
/// Answered by ToolDone or ToolFailed.
struct RunTool {
    std::uint64_t job = 0;
    Document document;
    std::shared_ptr<const ToolEdit> edit;
    bool at_once = false;  ///< it is quick
};
/// What takes the place of a symbol, in the words of files/replacement_text.h. Answered by ReplacementRead or
/// ReplacementFailed.
struct ReadReplacement {
    std::string symbol;
    std::string with;
};
/// Answered by SourceRead; a later one takes its place.
struct ReadSource {
    std::uint64_t job = 0;
    SourceQuestion question;
    std::shared_ptr<const GrowthSource> known;
};
// Growth: answered by GrowthProgress, PatternGrown and at last PatternGrown{.done} or GrowthFailed; a later one takes the
// place of an earlier one.
struct GrowArrangement {
    std::uint64_t job = 0;
    std::shared_ptr<const ArrangeOrder> order;
};
struct FillPattern {
    std::uint64_t job = 0;
    std::shared_ptr<const FillOrder> order;
};
/// Answered by GrownDocumentMade or GrowthFailed.
struct MakeGrownDocument {
    std::uint64_t job = 0;
    Document document;
    std::shared_ptr<const GrownPattern> pattern;
};
/// Growth ends; `keep`: with what stands, and is answered, else without an answer.
struct EndGrowth {
    bool keep = true;
};
// Surfaces.
/// Answered by MeshRead; a later one takes its place.
struct ReadMesh {
    std::uint64_t job = 0;
    std::string path;
};
/// Answered by FieldDesigned; a later one takes its place.
struct DesignField {
    std::uint64_t job = 0;
    std::shared_ptr<const SurfaceStage> stage;
    FieldSettings settings;
    double spacing = 0.02;
};
/// Answered by SurfaceProgress and SurfaceGrown, at last with .done; a later one takes its place.
struct GrowOnSurface {
    std::uint64_t job = 0;
    std::shared_ptr<const SurfaceOrder> order;
};
/// Growth on the surface ends; `keep`: with what stands, and is answered, else without an answer.
struct EndSurface {
    bool keep = true;
};
/// Answered by SurfaceExported. `grown` may be null: the surface alone.
struct WriteSurface {
    std::string path;
    std::shared_ptr<const SurfaceStage> stage;
    std::shared_ptr<const GrownSurface> grown;
    OrbitView view;
};
struct CloseWindow {};

struct Request
    : std::variant<ReadDocument, WriteDocument, WriteExport, DerivePicture, FindSelection, CheckText, MeasureDepth,
                   LightRule, DeriveBefore, RunAnalysis, StopAnalysis, TabulateClusters, MapElements, RunTool,
                   ReadReplacement, ReadSource, GrowArrangement, FillPattern, MakeGrownDocument, EndGrowth, ReadMesh,
                   DesignField, GrowOnSurface, EndSurface, WriteSurface, CloseWindow, StopExport, HoldFile, ListFolder,
                   MakeFolder, LookAtPath, ListSamples, WriteRecovery, RemoveRecovery, FindRecoverables, ReadRecovery,
                   DiscardRecovery, WritePreferences> {
    using variant::variant;
    Request(const Request&);
    Request(Request&&) noexcept;
    Request& operator=(const Request&);
    Request& operator=(Request&&) noexcept;
    ~Request();
};
using Requests = std::vector<Request>;

}  // namespace rinceau
