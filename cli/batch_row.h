#pragma once
// What is known of one drawing of a batch: a row of the report.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rinceau {

enum class BatchStatus : unsigned char { done, input_at_fault, limit_reached, output_not_written, crashed };

/// "done", "input_at_fault", ...
std::string_view status_word(BatchStatus status);

struct BatchRow {
    std::string drawing;                    ///< output_stem()
    std::string options;                    ///< all that the result depends on beside the drawing, as text
    std::uint64_t bytes = 0;                ///< of the drawing's file
    std::uint64_t fingerprint = 0;          ///< of the same; 0 and no bytes = it could not be read
    std::uint64_t grammar_fingerprint = 0;  ///< of the grammar's text, if it is done
    BatchStatus status = BatchStatus::crashed;
    std::string message;  ///< why it is not done
    int elements = 0;
    int verbatim = 0;
    int terminals = 0;
    int rules = 0;
    std::map<std::string, int> kinds;  ///< of rules, with their numbers
    double drawing_bits = 0;
    double grammar_bits = 0;
    double error_max = 0;  ///< share of the diagonal
    double error_rms = 0;
    double tolerance = 0;
    std::vector<std::string> warnings;
    double seconds = 0;  ///< of wall time
};

/// One line of JSON, with its end.
std::string row_line(const BatchRow& row);

/// Nothing if this is no whole line of row_line().
std::optional<BatchRow> parse_row(std::string_view line);

}  // namespace rinceau
