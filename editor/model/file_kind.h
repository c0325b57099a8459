#pragma once
// The kinds of files that the editor reads and writes, by their names.

#include <string>

namespace rinceau {

enum class FileKind : unsigned char { drawing, grammar, json_grammar, project, mesh, shape_grammar, other };

/// By the ending: .svg and .svgz, .lsys, .json, .rinceau, .obj .off .ply, .fgsg; of any case of letters.
FileKind kind_of_name(const std::string& path);

/// ".lsys"; empty for `other`.
std::string ending_of(FileKind kind);

/// The name without the ending of a known kind, with that of `kind`.
std::string with_kind(const std::string& path, FileKind kind);

/// The last part of a path: "facade.svg".
std::string file_name_of(const std::string& path);

/// The name without folder and ending: "facade"; "untitled" for an empty one.
std::string stem_of(const std::string& path);

/// Is it a kind that holds a document that was edited: all but drawings?
bool can_be_saved_as(FileKind kind);

}  // namespace rinceau
