#include "cli/replacement_text.h"

#include <utility>

#include <CLI/Error.hpp>

#include "cli/messages.h"
#include "files/replacement_text.h"

namespace rinceau {

Replacement parse_replacement(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        throw CLI::ValidationError("SYMBOL=WITH", "expected a symbol, '=' and what takes its place, found '" + text + "'");
    const std::string with = text.substr(equals + 1);
    try {
        expect_replacement_text(with);
    } catch (const InputError& error) {
        throw CLI::ValidationError(text, error.what());
    }
    WrittenReplacement read = read_replacement(text.substr(0, equals), with);
    say_warnings(read.warnings);
    return std::move(read.replacement);
}

}  // namespace rinceau
