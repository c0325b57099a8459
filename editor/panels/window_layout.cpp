#include "editor/panels/window_layout.h"

#include <algorithm>
#include <cmath>

namespace rinceau {
namespace {

constexpr float splitter_width = 5;  ///< at scale 1
constexpr float canvas_share = 1.0F / 3;
constexpr float most_of_log = 0.5F;

void share_width(WindowLayout& layout, const ShellState& shell, const FreeRoom& room) {
    layout.left = shell.shown.left ? shell.sizes.left * room.scale : 0;
    layout.right = shell.shown.right ? shell.sizes.right * room.scale : 0;
    const float splitters = (shell.shown.left ? layout.splitter : 0) + (shell.shown.right ? layout.splitter : 0);
    const float columns = std::max(0.0F, (1 - canvas_share) * room.width - splitters);
    const float wished = layout.left + layout.right;
    if (wished > columns) {
        layout.left *= columns / wished;
        layout.right *= columns / wished;
    }
    layout.left = std::floor(layout.left);
    layout.right = std::floor(layout.right);
    layout.canvas = std::max(0.0F, room.width - layout.left - layout.right - splitters);
}

void share_left_column(WindowLayout& layout, const ShellState& shell, const FreeRoom& room) {
    const bool both = shell.shown.terminals && shell.shown.analysis;
    const float free = std::max(0.0F, layout.body - 2 * room.heading - (both ? layout.splitter : 0));
    const float share = both ? shell.sizes.terminals_share : shell.shown.terminals ? 1.0F : 0.0F;
    layout.terminals = std::floor(free * share);
    layout.analysis = shell.shown.analysis ? free - layout.terminals : 0;
}

}  // namespace

WindowLayout window_layout(const ShellState& shell, const FreeRoom& room) {
    WindowLayout layout;
    layout.splitter = std::round(splitter_width * room.scale);
    share_width(layout, shell, room);
    if (shell.shown.log) layout.log = std::floor(std::min(shell.sizes.log * room.scale, most_of_log * room.height));
    layout.body = std::max(0.0F, room.height - layout.log - (shell.shown.log ? layout.splitter : 0));
    if (shell.shown.left) share_left_column(layout, shell, room);
    return layout;
}

}  // namespace rinceau
