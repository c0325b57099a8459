#include "cli/batch_row.h"

#include <array>

#include "cli/batch_row_json.h"

namespace rinceau {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 5> words{"done", "input_at_fault", "limit_reached", "output_not_written", "crashed"};

std::optional<BatchStatus> status_of(std::string_view word) {
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i] == word) return static_cast<BatchStatus>(i);
    return std::nullopt;
}

BatchRow row_of(const Json& json, BatchStatus status) {
    return {.drawing = json.at("drawing"),
            .options = json.at("options"),
            .bytes = json.at("bytes"),
            .fingerprint = json.at("fingerprint"),
            .grammar_fingerprint = json.at("grammar_fingerprint"),
            .status = status,
            .message = json.at("message"),
            .elements = json.at("elements"),
            .verbatim = json.at("verbatim"),
            .terminals = json.at("terminals"),
            .rules = json.at("rules"),
            .kinds = json.at("kinds"),
            .drawing_bits = json.at("drawing_bits"),
            .grammar_bits = json.at("grammar_bits"),
            .error_max = json.at("error_max"),
            .error_rms = json.at("error_rms"),
            .tolerance = json.at("tolerance"),
            .warnings = json.at("warnings"),
            .seconds = json.at("seconds")};
}

}  // namespace

std::string_view status_word(BatchStatus status) { return words[static_cast<std::size_t>(status)]; }

void add_findings(Json& json, const BatchRow& row) {
    json["status"] = status_word(row.status);
    json["message"] = row.message;
    json["elements"] = row.elements;
    json["verbatim"] = row.verbatim;
    json["terminals"] = row.terminals;
    json["rules"] = row.rules;
    json["kinds"] = row.kinds;
    json["drawing_bits"] = row.drawing_bits;
    json["grammar_bits"] = row.grammar_bits;
    json["error_max"] = row.error_max;
    json["error_rms"] = row.error_rms;
    json["tolerance"] = row.tolerance;
    json["warnings"] = row.warnings;
}

std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string row_line(const BatchRow& row) {
    Json json{{"drawing", row.drawing}};
    add_findings(json, row);
    json["seconds"] = row.seconds;
    json["options"] = row.options;
    json["bytes"] = row.bytes;
    json["fingerprint"] = row.fingerprint;
    json["grammar_fingerprint"] = row.grammar_fingerprint;
    return line_of(json) + "\n";
}

std::optional<BatchRow> parse_row(std::string_view line) {
    try {
        const Json json = Json::parse(line);
        const auto status = status_of(json.at("status").get<std::string>());
        if (!status) return std::nullopt;
        return row_of(json, *status);
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

}  // namespace rinceau
