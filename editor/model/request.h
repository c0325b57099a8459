#pragma once
// What update() asks of the world outside; effects/ fulfils it and answers with actions.

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "analyzer/analyze.h"
#include "editor/model/derived_picture.h"
#include "editor/model/document.h"
#include "editor/model/find_selection.h"

namespace rinceau {

/// Answered by FileOpened or FileFailed.
struct ReadDocument {
    std::string path;
};
/// The grammar of the document to a .lsys file. Answered by FileSaved or SaveFailed.
struct WriteDocument {
    std::string path;
    Document document;
};
/// Answered by FileExported or SaveFailed.
struct WriteExport {
    std::string path;
    std::string format;
    Document document;
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
struct CloseWindow {};

using Request = std::variant<ReadDocument, WriteDocument, WriteExport, DerivePicture, FindSelection, LightRule, DeriveBefore,
                             RunAnalysis, StopAnalysis, TabulateClusters, MapElements, CloseWindow>;
using Requests = std::vector<Request>;

}  // namespace rinceau
