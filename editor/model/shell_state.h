#pragma once
// The window itself.

namespace rinceau {

struct ShellState {
    bool dark = true;
    bool help = false;
};

}  // namespace rinceau
