#pragma once
// A project: a document with all that belongs to it, as one file (docs/project_format.md).

#include <optional>
#include <string>
#include <string_view>

#include "editor/model/document.h"
#include "editor/model/file_stamp.h"
#include "editor/model/view_transform.h"

namespace rinceau {

/// Of a recovered document: the file that it was opened from, as it was then.
struct ProjectOrigin {
    std::string path;  ///< empty = it had none
    std::optional<FileStamp> stamp;
};

struct Project {
    Document document;                    ///< without report
    std::optional<ViewTransform> view;    ///< that it was left with; its size does not count
    std::optional<ProjectOrigin> origin;  ///< only of copies for emergencies
};

/// The project as JSON. `path` is where the file will stand: names of used files are written relative to its folder.
std::string to_json(const Project& project);

/// parse_project(to_json(p), path) has the same drawing, grammar, used files, options, locks and view; numbers are exact.
/// Throws InputError with line and column where the JSON itself is at fault, else with the member's path
/// ("analysis.weights.count") or the place in the grammar or drawing; LimitError as read_svg.
Project parse_project(std::string_view text, const std::string& path);

/// Is the JSON text a project rather than a grammar?
bool looks_like_project(std::string_view text);

}  // namespace rinceau
