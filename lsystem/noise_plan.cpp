#include "lsystem/noise_plan.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/index.h"
#include "lsystem/approach_roles.h"
#include "lsystem/ring.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

using How = NoisePlace::How;

constexpr double same_heading = 1e-6;  // degrees

bool is_command(const ModuleTemplate& module) { return find_turtle_command(module.symbol) != nullptr; }

bool repeats(const Production& production) {
    return std::ranges::any_of(production.successor,
                               [&](const ModuleTemplate& module) { return module.symbol == production.symbol; });
}

/// What a symbol may become.
class Reach {
  public:
    explicit Reach(const Grammar& grammar) : grammar_(grammar) {}

    bool has_productions(const std::string& symbol) const {
        return std::ranges::any_of(grammar_.productions, [&](const Production& p) { return p.symbol == symbol; });
    }
    bool leads_to_repetition(const std::string& symbol) {
        if (!asked_.insert(symbol).second) return known_.contains(symbol);
        for (const Production& production : grammar_.productions) {
            if (production.symbol != symbol) continue;
            const bool found =
                repeats(production) || std::ranges::any_of(production.successor, [&](const ModuleTemplate& module) {
                    return !is_command(module) && leads_to_repetition(module.symbol);
                });
            if (found) known_.insert(symbol);
        }
        return known_.contains(symbol);
    }

  private:
    const Grammar& grammar_;
    std::set<std::string> asked_;
    std::set<std::string> known_;  ///< of those asked: they do
};

/// A bracket that is open at the production's outermost level, or a symbol there.
struct Group {
    int first = 0;  ///< the bracket, or the symbol
    int last = 0;   ///< its partner, or the symbol
    std::vector<int> symbols;
};

std::vector<Group> groups_of(const std::vector<ModuleTemplate>& string) {
    std::vector<Group> groups;
    int depth = 0;
    for (int i = 0; i < static_cast<int>(string.size()); ++i) {
        const ModuleTemplate& module = string[at(i)];
        if (module.symbol == "[" && depth++ == 0) groups.push_back({i, i, {}});
        if (module.symbol == "]" && depth > 0 && --depth == 0) groups.back().last = i;
        if (is_command(module)) continue;
        if (depth == 0) groups.push_back({i, i, {}});
        groups.back().symbols.push_back(i);
    }
    // a bracket without its partner is a mistake, which interpreting reports
    std::erase_if(groups,
                  [&](const Group& group) { return group.first == group.last && is_command(string[at(group.first)]); });
    return groups;
}

class Planner {
  public:
    explicit Planner(const Grammar& grammar) : grammar_(grammar), constants_(constants_of(grammar)), reach_(grammar) {
        for (const Ring& ring : closed_rings(grammar)) rings_.insert(ring.loop.production);
    }

    std::vector<NoisePlace> plan() {
        for (std::size_t i = 0; i < grammar_.productions.size(); ++i)
            if (repeats(grammar_.productions[i])) plan_production(static_cast<int>(i));
        return std::move(result_);
    }

  private:
    const Grammar& grammar_;
    Scope constants_;
    Reach reach_;
    std::set<int> rings_;
    std::vector<NoisePlace> result_;
    StringPlace place_;
    const std::vector<ModuleTemplate>* string_ = nullptr;

    const ModuleTemplate& module_at(int position) const { return (*string_)[at(position)]; }
    bool is_one(int position, const std::string& symbol) const {
        return module_at(position).symbol == symbol && module_at(position).arguments.size() == 1;
    }
    void add(NoiseKind kind, How how, int position, int argument = 0) {
        result_.push_back({kind, how, place_, position, argument});
    }

    void plan_production(int index) {
        const Production& production = grammar_.productions[at(index)];
        place_ = {StringPlace::In::production, index};
        string_ = &production.successor;
        std::vector<Approach> steps;
        for (Approach& approach : approaches_of(*string_, production.symbol))
            if (approach.own && approach.symbol >= 0) steps.push_back(std::move(approach));
        bool elements_turn = false;
        bool elements_scale = true;
        for (const Approach& step : steps) {
            add_distances(step.commands);
            add_lengths_of_movers(step);
            const int scale = last_of(step, "*");
            if (scale >= 0) add(NoiseKind::scale, How::in_expression, scale);
            elements_scale = elements_scale && scale < 0;
            const int turn = last_turn(step);
            if (steps.size() == 1 && (rings_.contains(index) || keeps_heading(step))) {
                elements_turn = true;
            } else if (turn >= 0) {
                add(NoiseKind::angle, How::in_expression, turn);
            }
        }
        for (const Group& group : groups_of(*string_)) plan_group(group, production, {index, elements_turn, elements_scale});
    }

    struct ElementNoise {
        int production;
        bool angle;
        bool scale;
    };

    int last_of(const Approach& approach, const std::string& symbol) const {
        int found = -1;
        for (const int position : approach.commands)
            if (is_one(position, symbol)) found = position;
        return found;
    }
    int last_turn(const Approach& approach) const { return std::max(last_of(approach, "+"), last_of(approach, "-")); }

    bool keeps_heading(const Approach& step) const {
        const Scope scope = constants_in(grammar_, constants_, place_);
        const ApproachRoles roles = roles_of(*string_, step, scope);
        return roles.rotation && std::abs(*roles.rotation) < same_heading;
    }

    void add_distances(const std::vector<int>& commands) {
        for (const int position : commands)
            if (is_one(position, "f")) add(NoiseKind::distance, How::in_expression, position);
    }

    /// Right(80) on the way, with Right(d) -> -(90) f(d) +(90).
    void add_lengths_of_movers(const Approach& step) {
        for (const int position : way_to(*string_, step.symbol)) {
            const ModuleTemplate& module = module_at(position);
            if (is_command(module) || module.symbol == module_at(step.symbol).symbol) continue;
            for (const Production& production : grammar_.productions) {
                if (production.symbol != module.symbol || repeats(production)) continue;
                if (production.parameters.size() != module.arguments.size()) continue;
                for (std::size_t i = 0; i < production.parameters.size(); ++i) {
                    const bool is_length = std::ranges::any_of(production.successor, [&](const ModuleTemplate& part) {
                        return part.symbol == "f" && part.arguments.size() == 1 &&
                               part.arguments.front() == name_expression(production.parameters[i]);
                    });
                    if (is_length) add(NoiseKind::distance, How::in_expression, position, static_cast<int>(i));
                }
            }
        }
    }

    void plan_group(const Group& group, const Production& production, const ElementNoise& noise) {
        const bool unit = !group.symbols.empty() && std::ranges::none_of(group.symbols, [&](int position) {
            const std::string& symbol = module_at(position).symbol;
            return symbol == production.symbol || reach_.leads_to_repetition(symbol);
        });
        if (!unit) return;
        const bool ring = rings_.contains(noise.production);
        if (group.first == group.last) {
            if (reach_.has_productions(module_at(group.first).symbol)) return;  // it may move the turtle
            if (noise.angle) add(NoiseKind::angle, How::bracketed, group.first);
            if (noise.scale) add(NoiseKind::scale, How::bracketed, group.first);
            return;
        }
        std::vector<int> before;  // commands up to the first symbol, or the first bracket within
        for (int i = group.first + 1; i < group.symbols.front() && module_at(i).symbol != "["; ++i) before.push_back(i);
        if (ring) add_distances(before);
        const bool one = group.symbols.size() == 1;
        if (noise.angle) plan_angle(group, before, ring, one);
        if (noise.scale) plan_scale(group, before, one);
    }

    /// In a ring about its middle, else about the element itself.
    void plan_angle(const Group& group, const std::vector<int>& before, bool ring, bool one) {
        if (ring || !one) {
            const bool turned = !before.empty() && turn_sign(module_at(before.front())) != 0;
            add(NoiseKind::angle, turned ? How::in_expression : How::before, group.first + 1);
            return;
        }
        int turn = -1;
        for (const int position : before) {
            if (turn_sign(module_at(position)) != 0) turn = position;
            if (module_at(position).symbol == "f") turn = -1;
        }
        add(NoiseKind::angle, turn >= 0 ? How::in_expression : How::before, turn >= 0 ? turn : group.symbols.front());
    }

    void plan_scale(const Group& group, const std::vector<int>& before, bool one) {
        int scale = -1;
        for (const int position : before) {
            if (is_one(position, "*")) scale = position;
            if (module_at(position).symbol == "f") scale = -1;
        }
        if (scale >= 0) return add(NoiseKind::scale, How::in_expression, scale);
        add(NoiseKind::scale, How::before, one ? group.symbols.front() : group.first + 1);
    }
};

}  // namespace

std::vector<NoisePlace> noise_places(const Grammar& grammar) { return Planner(grammar).plan(); }

}  // namespace rinceau
