#pragma once
// Inputs and outputs by name, as the command line gives them.

#include <string>
#include <string_view>

#include "lsystem/grammar.h"

namespace rinceau {

/// How an input is called in messages: its name, or "<stdin>" for "-".
std::string input_label(const std::string& name);

/// The whole content of a file; "-" = standard input. Throws InputError if it cannot be read, LimitError if it is larger
/// than any drawing that can be analysed.
std::string read_input(const std::string& name);

/// Throws InputError for the name of a shape grammar (.fgsg), which has verbs of its own.
void expect_no_shape_grammar(const std::string& name);

/// Are these the bytes of a drawing (SVG, or packed SVG), and not those of a grammar?
bool looks_like_drawing(std::string_view bytes);

/// The grammar of a file as its text or its JSON (exports/json_grammar.h) says, its uses kept: for edits. Throws as
/// read_input, and InputError at its first mistake.
Grammar read_grammar_as_written(const std::string& name);

/// The text of a grammar's file, written anew if the file is JSON. Throws in the same way.
std::string read_grammar_text(const std::string& name);

/// The grammar of a file with all that it uses (resolve_uses.h): for deriving, drawing and exporting. Throws in the same
/// way.
Grammar read_grammar(const std::string& name);

/// The same of bytes that were read from the file `name`.
Grammar read_grammar(const std::string& name, const std::string& bytes);

/// Puts `bytes` in the place of the file `name`, as OutputFile does. Throws OutputError.
void write_output(const std::string& name, std::string_view bytes);

/// The same, written in `work_folder` and renamed.
void write_output(const std::string& name, std::string_view bytes, const std::string& work_folder);

enum class FileFormat : unsigned char { unknown, svg, png, pdf, lsys, json, csv, obj, glb, ply, html };

/// By the ending of the name, in any case of letters; `standard_output` for "" and "-".
FileFormat format_of(const std::string& name, FileFormat standard_output);

}  // namespace rinceau
