#pragma once
// What a document can be exported to: its picture, and every grammar format.

#include <string>
#include <vector>

namespace rinceau {

struct ExportTarget {
    std::string name;    ///< "picture-svg", "png", "pdf", or a name of exports/export_formats.h
    std::string ending;  ///< ".png"
    std::string help;    ///< the program that reads it, in a few words
    bool picture = false;
};

/// Pictures first, in the order in which they are listed to a user.
std::vector<ExportTarget> export_targets();

/// The first one if there is no such name.
ExportTarget find_export_target(const std::string& name);

}  // namespace rinceau
