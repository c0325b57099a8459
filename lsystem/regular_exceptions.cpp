#include "lsystem/regular_exceptions.h"

#include <algorithm>
#include <map>
#include <optional>

#include "geometry/index.h"
#include "lsystem/constant_values.h"
#include "lsystem/expression_place.h"
#include "lsystem/interpret.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

std::string probe_symbol(std::size_t exception) { return "Probe of an exception " + std::to_string(exception); }

/// By exception: the module that it replaces. One that stands below another is found once that one is known.
class ReplacedModules {
  public:
    explicit ReplacedModules(const Grammar& grammar) : grammar_(grammar), found_(grammar.exceptions.size()) {}

    std::vector<std::optional<ModuleTemplate>> find() {
        while (look_once()) {
        }
        return std::move(found_);
    }

  private:
    const Grammar& grammar_;
    std::vector<std::optional<ModuleTemplate>> found_;

    /// Exceptions that are still unknown draw a probe, whose trail says where it is drawn.
    Grammar with_probes() const {
        Grammar grammar = grammar_;
        for (std::size_t i = 0; i < found_.size(); ++i) {
            if (found_[i]) continue;
            grammar.exceptions[i].successor = {{probe_symbol(i), {}, {}}};
            Terminal probe;
            probe.symbol = probe_symbol(i);
            grammar.terminals.push_back(std::move(probe));
        }
        return grammar;
    }

    bool look_once() {
        const Grammar probes = with_probes();
        std::map<std::string, std::size_t> exceptions;
        for (std::size_t i = 0; i < found_.size(); ++i)
            if (!found_[i]) exceptions[probe_symbol(i)] = i;
        bool any = false;
        visit_placements(probes, {.trails = true}, [&](const Placement& placement) {
            const auto probe = exceptions.find(probes.terminals[at(placement.terminal)].symbol);
            if (probe == exceptions.end() || placement.trail.size() < 2 || found_[probe->second]) return;
            found_[probe->second] = module_of(probes, placement.trail[placement.trail.size() - 2]);
            any = any || found_[probe->second].has_value();
        });
        return any;
    }

    static std::optional<ModuleTemplate> module_of(const Grammar& grammar, const Occurrence& occurrence) {
        if (occurrence.production < -1) return {};  // in the successor of another exception
        const StringPlace place = occurrence.production < 0
                                      ? StringPlace{StringPlace::In::axiom, 0}
                                      : StringPlace{StringPlace::In::production, occurrence.production};
        return string_at(grammar, place).at(at(occurrence.position));
    }
};

bool is_motion(const ModuleTemplate& module) {
    return module.symbol == "+" || module.symbol == "-" || module.symbol == "f" || module.symbol == "*";
}

/// The successor without motions, if it stands for the same module; nothing if it is something else.
std::optional<std::vector<ModuleTemplate>> without_motions(const std::vector<ModuleTemplate>& successor,
                                                           const ModuleTemplate& replaced) {
    std::vector<ModuleTemplate> rest;
    for (std::size_t i = 0; i < successor.size(); ++i) {
        const ModuleTemplate& module = successor[i];
        const bool last = i + 1 == successor.size();
        const bool command = find_turtle_command(module.symbol) != nullptr;
        if (last == command || module.symbol == "[") return {};
        if (last && (module.symbol != replaced.symbol || module.arguments != replaced.arguments)) return {};
        if (!is_motion(module)) rest.push_back(module);
    }
    if (rest.empty()) return {};  // a hole
    return rest;
}

}  // namespace

EditResult with_regular_exceptions(const Grammar& grammar, bool all) {
    EditResult result{grammar, {}};
    const auto say = [&](std::size_t count, const std::string& what) {
        if (count > 0)
            result.changes.push_back(std::to_string(count) + (count == 1 ? " exception " : " exceptions ") + what);
    };
    if (all) {
        say(grammar.exceptions.size(), "dropped");
        result.grammar.exceptions.clear();
        return result;
    }
    if (grammar.exceptions.empty()) return result;
    const auto replaced = ReplacedModules(grammar).find();
    std::size_t dropped = 0;
    std::size_t moved_back = 0;
    result.grammar.exceptions.clear();
    for (std::size_t i = 0; i < grammar.exceptions.size(); ++i) {
        Exception exception = grammar.exceptions[i];
        if (replaced[i]) {
            if (auto rest = without_motions(exception.successor, *replaced[i])) {
                if (rest->size() == 1) {
                    ++dropped;
                    continue;
                }
                moved_back += rest->size() < exception.successor.size();
                exception.successor = std::move(*rest);
            }
        }
        result.grammar.exceptions.push_back(std::move(exception));
    }
    say(dropped, "dropped that only moved, turned or scaled");
    say(moved_back, "moved back to the regular place");
    return result;
}

}  // namespace rinceau
