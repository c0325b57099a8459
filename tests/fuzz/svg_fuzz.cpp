// Drawings, read and written.

#include "scene/svg_read.h"
#include "scene/svg_write.h"
#include "tests/fuzz/fuzz_target.h"

void rinceau::take_input(std::string_view bytes) {
    SvgReadOptions options;
    options.file_name = "any.svg";
    options.max_elements = 2000;
    options.max_depth = 200;
    options.max_bytes = 1u << 20U;
    write_svg(read_svg(bytes, options).scene);
}
