#include "lsystem/turtle_step.h"

namespace rinceau {

TurtleStep to_turtle_step(const Similarity& map, double still) {
    TurtleStep step;
    step.advance = abs(map.translation);
    if (step.advance > still) {
        step.turn = wrap_angle(arg(map.translation) - pi / 2);
    } else {
        step.advance = 0;
    }
    step.scale = scale_of(map);
    step.mirrored = map.mirrored;
    // The mirror comes last: rotate(turn + spin) * scale * mirror_about_heading() has linear part -scale * e^(i (turn +
    // spin)).
    const double whole_turn = arg(map.mirrored ? -map.linear : map.linear);
    step.spin = wrap_angle(whole_turn - step.turn);
    return step;
}

Similarity to_similarity(const TurtleStep& step) {
    const Similarity moved = rotate(step.turn) * translate({0, step.advance}) * scale_by(step.scale) * rotate(step.spin);
    return step.mirrored ? moved * mirror_about_heading() : moved;
}

}  // namespace rinceau
