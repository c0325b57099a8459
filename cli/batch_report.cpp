#include "cli/batch_report.h"

#include "cli/batch_row_json.h"
#include "cli/batch_work.h"
#include "files/output_file.h"
#include "lsystem/number_text.h"

namespace rinceau {
namespace {

using Json = nlohmann::ordered_json;

constexpr int schema_version = 1;

/// Empty for a drawing that gave nothing.
std::string output_of(const BatchRow& row) { return row.status == BatchStatus::done ? grammar_file(row.drawing) : ""; }

std::string field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

std::string kinds_text(const BatchRow& row) {
    std::string text;
    for (const auto& [kind, number] : row.kinds) text += (text.empty() ? "" : "; ") + kind + " " + std::to_string(number);
    return text;
}

std::string warnings_text(const BatchRow& row) {
    std::string text;
    for (const std::string& warning : row.warnings) text += (text.empty() ? "" : "; ") + warning;
    return text;
}

constexpr const char* csv_header =
    "input,output,status,message,elements,verbatim,terminals,rules,kinds,drawing_bits,grammar_bits,error_max,error_rms,"
    "tolerance,warnings\n";

std::string csv_record(const BatchEntry& entry) {
    const BatchRow& row = entry.row;
    std::string record = field(entry.input) + "," + field(output_of(row)) + "," + std::string(status_word(row.status)) +
                         "," + field(row.message);
    for (const int number : {row.elements, row.verbatim, row.terminals, row.rules}) record += "," + std::to_string(number);
    record += "," + field(kinds_text(row));
    for (const double number : {row.drawing_bits, row.grammar_bits, row.error_max, row.error_rms, row.tolerance})
        record += "," + number_text(number);
    return record + "," + field(warnings_text(row)) + "\n";
}

std::string json_object(const BatchEntry& entry) {
    Json json{{"input", entry.input}, {"output", output_of(entry.row)}};
    add_findings(json, entry.row);
    return line_of(json);
}

}  // namespace

void write_batch_csv(const std::string& name, const BatchEntries& entries) {
    OutputFile file(name);
    file.write(csv_header);
    entries([&file](const BatchEntry& entry) { file.write(csv_record(entry)); });
    file.finish();
}

void write_batch_json(const std::string& name, const BatchEntries& entries) {
    OutputFile file(name);
    std::size_t drawings = 0, done = 0;
    file.write("{\"schema\": " + std::to_string(schema_version) + ",\n\"rows\": [");
    entries([&](const BatchEntry& entry) {
        file.write((drawings == 0 ? "\n" : ",\n") + json_object(entry));
        ++drawings;
        if (entry.row.status == BatchStatus::done) ++done;
    });
    file.write("\n],\n\"drawings\": " + std::to_string(drawings) + ",\n\"done\": " + std::to_string(done) +
               ",\n\"failed\": " + std::to_string(drawings - done) + "}\n");
    file.finish();
}

}  // namespace rinceau
