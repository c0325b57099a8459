#include "editor/model/export_target.h"

#include <algorithm>

#include "exports/export_formats.h"

namespace rinceau {

std::vector<ExportTarget> export_targets() {
    std::vector<ExportTarget> targets{{"picture-svg", ".svg", "the picture, for browsers and drawing programs", true},
                                      {"png", ".png", "the picture in pixels", true},
                                      {"pdf", ".pdf", "the picture on a page", true}};
    for (const ExportFormat& format : export_formats())
        targets.push_back({std::string(format.name), std::string(format.ending), std::string(format.help), false});
    return targets;
}

ExportTarget find_export_target(const std::string& name) {
    const std::vector<ExportTarget> targets = export_targets();
    const auto found = std::ranges::find(targets, name, &ExportTarget::name);
    return found == targets.end() ? targets.front() : *found;
}

}  // namespace rinceau
