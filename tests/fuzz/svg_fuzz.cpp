// Drawings: what is read can be written, and reads back as what was written.

#include "scene/svg_read.h"
#include "scene/svg_write.h"
#include "tests/fuzz/fuzz_target.h"

void rinceau::take_input(std::string_view bytes) {
    SvgReadOptions options;
    options.file_name = "any.svg";
    options.max_elements = 2000;
    options.max_depth = 200;
    options.max_bytes = 1u << 20U;
    const Scene scene = read_svg(bytes, options).scene;

    std::string once;
    require(is_taken([&] { once = write_svg(read_svg(write_svg(scene)).scene); }), "a written drawing can be read");
    require(write_svg(read_svg(once).scene) == once, "a written drawing reads back as the same");
}
