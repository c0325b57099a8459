#include "cli/analysis_check.h"

#include "scene/input_error.h"

namespace rinceau {

void expect_passed(const Verification& check, const std::string& label) {
    if (check.passed) return;
    throw InputError({label}, "the grammar that was found does not draw the drawing, and is not written: " + check.summary);
}

}  // namespace rinceau
