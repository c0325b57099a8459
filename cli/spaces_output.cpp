#include "cli/spaces_output.h"

#include <algorithm>

#include "analyzer/spaces_report.h"
#include "analyzer/symbol_names.h"
#include "analyzer/transformation_space.h"

namespace rinceau {

std::string spaces_output(const Scene& scene, SimilarityOptions similarity, FileFormat format) {
    constexpr double share_of_analyze = 1e-4;  // its copies are as near to each other, so that both have the same looks
    similarity.tolerance_of_diagonal = std::min(similarity.tolerance_of_diagonal, share_of_analyze);
    const Instancing instancing = group_similar_elements(scene, similarity);
    const std::vector<std::string> names = look_names(instancing, scene);
    const std::vector<ClusteredSpace> spaces = cluster_spaces(fill_transformation_spaces(instancing));
    return format == FileFormat::csv ? spaces_csv(spaces, names) : spaces_svg(spaces, names);
}

}  // namespace rinceau
