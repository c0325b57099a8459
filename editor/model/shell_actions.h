#pragma once
// The window itself: looks, panels, messages.

#include <string>
#include <variant>

namespace rinceau {

struct SetDarkTheme {
    bool dark = true;
};
struct ShowHelp {
    bool shown = true;
};
struct DismissMessages {};

using ShellAction = std::variant<SetDarkTheme, ShowHelp, DismissMessages>;

}  // namespace rinceau
