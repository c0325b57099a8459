#pragma once
// What the window does by itself while nothing happens.

namespace rinceau {

/// Has the mouse rested long enough on the item under it for a tooltip?
bool mouse_has_rested();

/// Seconds until the window wants to be drawn again although nothing happens: a tooltip appears, a text cursor blinks.
/// Infinite if it does not.
double seconds_to_next_frame();

}  // namespace rinceau
