#include "editor/model/selection.h"

#include <algorithm>
#include <cmath>

#include "lsystem/number_text.h"

namespace rinceau {
namespace {

/// An exception that puts one symbol in the place of another: one level for a person, that of the symbol that is there.
bool is_stand_in(const std::vector<PathModule>& path, std::size_t level) {
    return level + 1 < path.size() && path[level].exception >= 0 && path[level].address == path[level + 1].address;
}

std::size_t level_above(const std::vector<PathModule>& path, std::size_t level) {
    while (level > 0 && is_stand_in(path, --level)) {
    }
    return level;
}

std::optional<Selection> selection_of(const Document& document, const ElementQuery& element, const Progress& progress,
                                      std::size_t level = deepest_level) {
    Selection selection{derivation_path(*document.resolved, element, document.derive, progress), 0};
    if (selection.path.empty()) return std::nullopt;
    selection.level = std::min(level, selection.path.size() - 1);
    if (is_stand_in(selection.path, selection.level)) ++selection.level;
    return selection;
}

/// The level of another path that stands for the same module; the deepest that is left of its way otherwise.
std::size_t same_level(const Selection& before, const std::vector<PathModule>& path) {
    const PathModule& wanted = selected_module(before);
    for (std::size_t level = 0; level < path.size(); ++level) {
        const bool same = path[level].symbol == wanted.symbol && path[level].address == wanted.address &&
                          (!wanted.branches || level == before.level);
        if (same && !is_stand_in(path, level)) return level;
    }
    return std::min(before.level, path.size() - 1);
}

}  // namespace

const PathModule& selected_module(const Selection& selection) { return selection.path[selection.level]; }

int selected_element(const Selection& selection) { return selection.path.back().first; }

int selected_production(const Selection& selection) {
    const PathModule& module = selected_module(selection);
    if (module.string.in == StringPlace::In::production) return module.string.index;
    return module.string.in == StringPlace::In::axiom ? -1 : -2;
}

std::vector<std::size_t> shown_levels(const Selection& selection) {
    std::vector<std::size_t> levels;
    for (std::size_t level = 0; level < selection.path.size(); ++level)
        if (!is_stand_in(selection.path, level)) levels.push_back(level);
    return levels;
}

std::string level_label(const PathModule& module) {
    if (module.symbol.empty()) return "axiom";
    if (module.arguments.empty()) return module.symbol;
    std::string text = module.symbol + '(';
    constexpr double shown_steps = 1000;  // three digits behind the point are enough to tell arguments apart
    for (std::size_t i = 0; i < module.arguments.size(); ++i)
        text += (i > 0 ? ", " : "") + number_text(std::round(module.arguments[i] * shown_steps) / shown_steps);
    return text + ')';
}

std::string level_counts(const Selection& selection, std::size_t level) {
    if (level == 0) return {};
    const PathModule& module = selection.path[level];
    const PathModule& above = selection.path[level - 1];
    std::string text;
    if (module.part >= 0 && above.parts.size() > 1) {
        text = std::to_string(module.part + 1) + " of " + std::to_string(above.parts.size()) + " in " + above.symbol + ", ";
    }
    return text + std::to_string(module.count) + " in all";
}

std::optional<Selection> selection_of_click(const Document& document, int order, const std::optional<Selection>& before,
                                            std::size_t level, const Progress& progress) {
    if (!before || selected_element(*before) != order || before->level == 0)
        return selection_of(document, {order, {}}, progress, level);
    Selection selection = *before;
    selection.level = level_above(selection.path, selection.level);
    return selection;
}

std::optional<Selection> selection_after_edit(const Document& document, const Selection& before, const Progress& progress) {
    std::optional<Selection> after = selection_of(document, {-1, before.path.back().address}, progress);
    for (std::size_t level = before.level; !after && level > 0; --level) {
        if (!before.path[level].address.empty()) after = selection_of(document, {-1, before.path[level].address}, progress);
    }
    if (!after) return std::nullopt;
    after->level = same_level(before, after->path);
    return after;
}

}  // namespace rinceau
