#pragma once
// SVG in: from bytes to the normal form (NORMAL_FORM.md).

#include <string>
#include <string_view>
#include <vector>

#include "scene/element.h"
#include "scene/input_error.h"

namespace rinceau {

struct SvgReadOptions {
    std::string file_name;                     ///< for messages
    double width = 0, height = 0;              ///< what 100 % is when the root has no size; 0 = 100 px (or the viewBox)
    bool split_compound_paths = true;          ///< connected pieces become elements of their own where that draws the same
    std::size_t max_elements = 1'000'000;      ///< drawn elements after expansion of use; more -> LimitError
    int max_depth = 4096;                      ///< nesting of elements, of use and of references together -> LimitError
    std::size_t max_bytes = 512u << 20;        ///< of text after decompression and entity expansion -> LimitError
};

struct SvgReadResult {
    Scene scene;
    std::vector<Warning> warnings;  ///< one for each kind of thing that is kept verbatim, skipped or mended
};

/// Throws InputError (not an SVG, broken XML: with line and column) or LimitError. `bytes` may be gzip, UTF-8, UTF-16 or
/// Latin-1.
SvgReadResult read_svg(std::string_view bytes, const SvgReadOptions& options = {});

}  // namespace rinceau
