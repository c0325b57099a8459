#pragma once
// Small square buttons with drawn icons, which need no font.

#include "editor/panels/panel.h"

namespace rinceau {

enum class Icon : unsigned char { locked, unlocked, reset, menu };

/// As large as a line of text is high. True if it was pressed. `id` is unique in the window; `tooltip` says what it does.
bool icon_button(const char* id, Icon icon, const char* tooltip);

/// The width of an icon_button.
float icon_button_width();

}  // namespace rinceau
