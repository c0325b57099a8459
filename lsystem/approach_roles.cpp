#include "lsystem/approach_roles.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "lsystem/constant_values.h"
#include "lsystem/noise_form.h"

namespace rinceau {

namespace {

constexpr double angle_rounding = 1e-9;  // degrees; what is left of turns that cancel

class RoleFinder {
  public:
    RoleFinder(const std::vector<ModuleTemplate>& string, const Approach& approach, const Scope& constants)
        : string_(string), approach_(approach), constants_(constants) {
        for (const int position : approach.commands) {
            const ModuleTemplate& module = module_at(position);
            if (module.symbol == "f") moves_.push_back(position);
            if (turn_sign(module) != 0 && !find_noise_command(module)) turns_.push_back(position);
        }
        is_offset_ = moves_.size() == 2 && turns_before(moves_[0]) == 0 && turns_before(moves_[1]) == 1;
    }

    ApproachRoles find() {
        ApproachRoles result;
        for (const int position : approach_.commands) {
            const ModuleTemplate& module = module_at(position);
            if (module.arguments.size() != 1) continue;  // |, a colour, or a mistake
            if (find_noise_command(module)) continue;
            const std::string role = numbered(role_of(position, module.symbol));
            const int sign = turn_sign(module);
            auto value = value_of(without_noise(module.arguments.front()), constants_);
            if (value && sign < 0) value = -*value;
            result.commands.push_back({position, role, sign == 0 ? 1 : sign, value});
        }
        find_rotation(result);
        find_form(result);
        return result;
    }

  private:
    const std::vector<ModuleTemplate>& string_;
    const Approach& approach_;
    const Scope& constants_;
    std::vector<int> moves_;
    std::vector<int> turns_;
    bool is_offset_ = false;
    std::map<std::string, int> counts_;

    const ModuleTemplate& module_at(int position) const { return string_[static_cast<std::size_t>(position)]; }
    long turns_before(int position) const {
        return std::ranges::count_if(turns_, [&](int turn) { return turn < position; });
    }

    std::string role_of(int position, const std::string& symbol) const {
        if (symbol == "f") return is_offset_ ? (position == moves_[0] ? "forward" : "sideways") : "distance";
        if (symbol == "*") return "scale";
        if (symbol == ";") return "style";
        if (symbol == "z") return "layer";
        if (symbol == "+" || symbol == "-") return !moves_.empty() && position > moves_.back() ? "spin" : "turn";
        return "argument";
    }

    std::string numbered(const std::string& role) {
        const int count = ++counts_[role];
        return count == 1 ? role : role + '.' + std::to_string(count);
    }

    bool mirrored_between_turns() const {
        return std::ranges::any_of(approach_.commands, [&](int position) {
            return module_at(position).symbol == "|" && position > turns_.front() && position < turns_.back();
        });
    }

    void find_rotation(ApproachRoles& result) const {
        for (std::size_t i = 0; i < result.commands.size(); ++i)
            if (turn_sign(module_at(result.commands[i].position)) != 0) result.last_turn = static_cast<int>(i);
        if (result.last_turn < 0) {
            result.rotation = 0;
            return;
        }
        if (mirrored_between_turns()) return;
        double sum = 0;
        for (const CommandRole& command : result.commands) {
            if (turn_sign(module_at(command.position)) == 0) continue;
            if (!command.value) return;
            sum += *command.value;
        }
        result.rotation = sum;
    }

    void find_form(ApproachRoles& result) const {
        constexpr double quarter = 90;
        if (!result.rotation || turns_.size() != 2 || moves_.empty() || turns_[1] < moves_.back()) return;
        const auto first = std::ranges::find(result.commands, turns_[0], &CommandRole::position);
        if (is_offset_) {
            if (std::abs(*first->value) == quarter) result.form = StepForm::offset;
        } else if (moves_.size() == 1 && turns_[0] < moves_[0]) {
            result.first_turn = static_cast<int>(first - result.commands.begin());
            if (std::abs(*result.rotation) < angle_rounding) result.form = StepForm::framed;
        }
    }
};

}  // namespace

ApproachRoles roles_of(const std::vector<ModuleTemplate>& string, const Approach& approach, const Scope& constants) {
    return RoleFinder(string, approach, constants).find();
}

}  // namespace rinceau
