#pragma once
// How a number feels in the hand: how far a drag goes, in which steps, between which ends, and how it reads.

#include <string>

#include "lsystem/numbers.h"

namespace rinceau {

struct NumberFeel {
    double speed = 1;          ///< for each pixel (scale 1) that the mouse moves
    double step = 1;           ///< the value is a multiple of it; > 0
    double low = 0, high = 0;  ///< no further; both may be infinite
};

/// `start` = its value when the drag begins: large numbers go in larger steps.
NumberFeel number_feel(const GrammarNumber& number, double start);

/// The nearest value that the feel allows.
double felt_value(const NumberFeel& feel, double value);

/// The upper end of a slider for a count whose value is `start` when it is touched.
double slider_end(double start);

/// "30°", "12.5", "×0.84": six digits at most.
std::string number_label(const GrammarNumber& number, double value);

}  // namespace rinceau
