#pragma once
// What update() asks of the world outside; effects/ fulfils it and answers with actions.

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "analyzer/analyze.h"
#include "editor/model/document.h"
#include "editor/model/find_selection.h"
#include "editor/model/tool_edit.h"

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
/// Answered by AnalysisProgress and AnalysisDone or AnalysisFailed; a later one takes its place.
struct RunAnalysis {
    std::uint64_t job = 0;
    std::shared_ptr<const Scene> drawing;
    AnalyzeOptions options;
};
/// Not answered.
struct StopAnalysis {};
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
struct CloseWindow {};

using Request =
    std::variant<ReadDocument, WriteDocument, WriteExport, DerivePicture, FindSelection, RunAnalysis, StopAnalysis, RunTool,
                 ReadReplacement, CloseWindow>;
using Requests = std::vector<Request>;

}  // namespace rinceau
