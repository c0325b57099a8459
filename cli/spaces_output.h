#pragma once
// --spaces: the transformation spaces of a drawing, as a table or as scatter plots.

#include <string>

#include "analyzer/instancing.h"
#include "files/files.h"
#include "scene/element.h"

namespace rinceau {

/// FileFormat::csv or FileFormat::svg (analyzer/spaces_report.h); looks have the names that the analysis gives to terminals.
std::string spaces_output(const Scene& scene, SimilarityOptions similarity, FileFormat format);

}  // namespace rinceau
