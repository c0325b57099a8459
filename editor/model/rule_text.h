#pragma once
// The grammar's text while it is written, and what is found out about it.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "editor/model/document.h"
#include "geometry/progress.h"
#include "scene/input_error.h"

namespace rinceau {

struct TextFindings {
    std::vector<Warning> mistakes;  ///< empty = it is a grammar
    std::vector<Warning> hints;     ///< right, but perhaps not meant
    std::string picture;            ///< "draws 120 elements", "draws nothing", or why it cannot be drawn
    bool drawn = false;             ///< it draws something
};

/// The mistakes of a text that would be the document's grammar, and what it would draw: within bounded time.
TextFindings check_rule_text(const std::string& text, const std::string& file, const Document& document,
                             const Progress& progress = {});

struct RuleText {
    std::string text;
    std::string file;                        ///< whose text it is: files that it uses are looked for from there
    std::shared_ptr<const Grammar> grammar;  ///< whose text it was at first
    bool changed = false;                    ///< since then, and not applied
    std::uint64_t revision = 0;              ///< of the text; grows with each change
    std::uint64_t checked = 0;               ///< revision that `findings` are about
    bool checking = false;                   ///< a check is under way
    TextFindings findings;
    int line = 0;  ///< that is marked, from 1; 0 = none
    int column = 0;
    bool goes_there = false;  ///< the cursor shall go to the marked line
};

/// The text of the document's grammar, unchanged.
RuleText rule_text_of(const Document& document, std::uint64_t revision);

/// Offset of a line and column (from 1) in a text; its end if there is no such line.
std::size_t offset_of_place(const std::string& text, int line, int column);

}  // namespace rinceau
