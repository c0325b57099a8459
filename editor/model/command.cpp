#include "editor/model/command.h"

#include <utility>

namespace rinceau {

bool is_enabled(const Command& command, const EditorState& state) {
    return command.enabled == nullptr || command.enabled(state);
}

std::vector<Command> all_commands() {
    std::vector<Command> all;
    for (const auto area :
         {file_commands, rules_commands, canvas_commands, tools_commands, analysis_commands, shell_commands})
        for (Command& command : area()) all.push_back(std::move(command));
    return all;
}

}  // namespace rinceau
