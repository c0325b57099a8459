#include "editor/effects/read_tool_replacement.h"

#include <utility>

#include "files/replacement_text.h"

namespace rinceau {

ToolsAction read_tool_replacement(const ReadReplacement& request) {
    WrittenReplacement read = read_replacement(request.symbol, request.with);
    ReplacementRead answer{request.with, std::make_shared<const Replacement>(std::move(read.replacement)), {}};
    for (const Warning& warning : read.warnings) answer.warnings.push_back(located(warning.place, warning.message));
    return answer;
}

}  // namespace rinceau
