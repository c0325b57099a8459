#include "tests/fuzz/fuzz_mesh.h"
#include "tests/fuzz/fuzz_target.h"

void rinceau::take_input(std::string_view bytes) { take_mesh(bytes, "any.obj"); }
