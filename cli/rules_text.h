#pragma once
// The found rules for a person to read.

#include <string>

#include "analyzer/analyze.h"

namespace rinceau {

/// One line: what went in, what was found, how exactly it draws the drawing.
std::string summary_line(const AnalysisReport& report);

/// The grammar's text without the outlines, styles and exceptions, which only a program reads, and with the terminals'
/// numbers at the top. A very long axiom (the elements that follow no rule) is cut short and says so.
std::string rules_text(const Analysis& analysis);

}  // namespace rinceau
