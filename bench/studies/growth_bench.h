#pragma once
// The parts of the benchmark of growth.

#include <string>
#include <vector>

#include "growth/arrangement/grow_arrangement.h"
#include "growth_cases.h"
#include "growth_lines.h"

namespace rinceau::test {

/// Draws results into a folder, for a look at them; no folder, no pictures.
struct GrowthPictures {
    std::string folder;

    void draw(const std::string& name, const Exemplar& exemplar, const ElementArrangement& arrangement) const;
    void draw(const std::string& name, const ShapeCase& shapes, const std::vector<PlacedRegion>& placed) const;
};

/// Cases whose names hold `only`.
void arrangement_lines(GrowthLines& lines, const std::vector<ExemplarCase>& cases, const std::string& only,
                       const GrowthPictures& pictures);
void arrangement_region_lines(GrowthLines& lines, const std::vector<ExemplarCase>& cases, const std::string& only,
                              const GrowthPictures& pictures);
/// Rings that turn to fit, and rings along a round flow.
void arrangement_mode_lines(GrowthLines& lines, const std::vector<ExemplarCase>& cases, const std::string& only,
                            const GrowthPictures& pictures);
void arrangement_speed_lines(GrowthLines& lines, const std::vector<ExemplarCase>& cases, const std::string& only);

void aggregate_lines(GrowthLines& lines, const std::vector<ShapeCase>& cases, const std::string& only,
                     const GrowthPictures& pictures);
/// 1,000 and 10,000 shapes.
void aggregate_speed_lines(GrowthLines& lines, const std::string& shape_folder);

}  // namespace rinceau::test
