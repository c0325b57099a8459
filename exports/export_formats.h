#pragma once
// The formats as data: what the command line and the editor offer.

#include <span>
#include <string_view>

#include "exports/export.h"

namespace rinceau {

struct ExportFormat {
    std::string_view name;    ///< as in --to NAME
    std::string_view ending;  ///< of a file: ".lpy"
    std::string_view help;    ///< the program that reads it, in a few words
    Export (*write)(const Grammar&, const ExportOptions&);
    bool keeps_uses = false;  ///< holds what a grammar uses as it is written; else the used files must be put in before
};

/// In the order in which they are listed to a user.
std::span<const ExportFormat> export_formats();

/// nullptr if there is no such format.
const ExportFormat* find_export_format(std::string_view name);

}  // namespace rinceau
