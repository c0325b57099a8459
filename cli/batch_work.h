#pragma once
// What is done with one drawing of a batch.

#include <string>

#include "analyzer/analyze.h"
#include "cli/batch_row.h"

namespace rinceau {

struct BatchWork {
    std::string folder;       ///< of the outputs
    std::string work_folder;  ///< on the same disk, for files on their way
    std::string options;      ///< for the row
    bool pictures = false;    ///< before and after, for the contact sheet
    AnalyzeOptions analyze;
};

/// Below the folder, for a drawing's stem: the grammar and the pictures.
std::string grammar_file(const std::string& stem);
std::string picture_before_file(const std::string& stem);
std::string picture_after_file(const std::string& stem);

/// Analyses the drawing `input`, and writes its grammar and pictures where `stem` says, each as a whole or not at all. What
/// is wrong comes back in the row.
BatchRow analyze_for_batch(const BatchWork& work, const std::string& input, const std::string& stem);

/// Is the row about these options and this content of the drawing, and is what it gives all there as it was written? A
/// drawing that was at fault gives nothing; what failed otherwise is not whole.
bool is_whole(const BatchRow& row, const BatchWork& work, const std::string& input);

}  // namespace rinceau
