#pragma once
// What the commands on the way to a symbol do, in words of a step (TurtleStep): turn, distance, scale, spin. Internal to the
// folder.

#include <optional>
#include <string>
#include <vector>

#include "lsystem/approach.h"
#include "lsystem/program.h"

namespace rinceau {

struct CommandRole {
    int position = 0;  ///< in the string
    std::string role;  ///< "turn", "spin", "distance", "forward", "sideways", "scale", "style", "layer", "turn.2" ..
    int sign = 1;      ///< of an angle: to the left is above 0
    std::optional<double> value;  ///< in degrees to the left for angles; nothing if it depends on parameters or chance
};

/// What the way to a symbol looks like to a person.
enum class StepForm : unsigned char {
    turtle,  ///< as it is written: turn, distance, spin
    framed,  ///< the turn before going is taken back after it: -(90) f(10) +(90) goes to the right
    offset   ///< so much ahead and so much to the side: f(3) -(90) f(4) +(90)
};

struct ApproachRoles {
    std::vector<CommandRole> commands;  ///< without |
    StepForm form = StepForm::turtle;
    int first_turn = -1;             ///< index of the turn before the way, if a spin follows it; -1 = there are no such two
    int last_turn = -1;              ///< index of the last turn
    std::optional<double> rotation;  ///< sum of the turns, in degrees; nothing if unknown or mirrored on the way
};

/// The role of a command depends on the commands about it, never on their values.
ApproachRoles roles_of(const std::vector<ModuleTemplate>& string, const Approach& approach, const Scope& constants);

}  // namespace rinceau
