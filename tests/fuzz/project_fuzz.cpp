// Project files of the editor: what is read is saved, and reads back as the same.

#include "editor/model/project.h"
#include "tests/fuzz/fuzz_target.h"

void rinceau::take_input(std::string_view bytes) {
    const std::string once = to_json(parse_project(bytes, "folder/any.rinceau"));
    require(is_taken([&] {
                const std::string twice = to_json(parse_project(once, "folder/any.rinceau"));
                require(to_json(parse_project(twice, "folder/any.rinceau")) == twice,
                        "a saved project reads back as the same");
            }),
            "a saved project can be read");
}
