#include "exports/json_text.h"

#include <algorithm>
#include <cmath>

namespace rinceau {

namespace {

/// Whether JSON can hold it as a string.
bool is_utf8(const std::string& bytes) {
    try {
        (void)Json(bytes).dump();
        return true;
    } catch (const Json::type_error&) {
        return false;
    }
}

constexpr unsigned continuation = 0x80;  // first byte after 0xC0 + the two upper bits
constexpr unsigned lead = 0xC0;
constexpr unsigned low_bits = 0x3F;

std::string as_characters(const std::string& bytes) {
    std::string text;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < continuation) {
            text += c;
        } else {
            text += static_cast<char>(lead | (byte >> 6U));
            text += static_cast<char>(continuation | (byte & low_bits));
        }
    }
    return text;
}

/// Nothing else than characters up to U+00FF; else false.
bool as_bytes(const std::string& text, std::string& bytes) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if (byte < continuation) {
            bytes += text[i];
            continue;
        }
        constexpr unsigned first_beyond = 0xC4;  // U+0100
        if (byte >= first_beyond || ++i == text.size()) return false;
        bytes += static_cast<char>(((byte & 3U) << 6U) | (static_cast<unsigned char>(text[i]) & low_bits));
    }
    return true;
}

std::string kind_of(const Json& value) {
    if (value.is_null()) return "null";
    if (value.is_object()) return "an object";
    if (value.is_array()) return "a list";
    constexpr std::size_t longest = 40;
    const std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
    return text.size() <= longest ? text : text.substr(0, longest) + "..";
}

/// Line and column of a byte, counted from 1.
SourcePlace place_of(std::string_view text, std::size_t byte, const std::string& file) {
    SourcePlace place{file, 1, 1};
    for (const char c : text.substr(0, std::min(byte, text.size()))) {
        ++place.column;
        if (c == '\n') place = {file, place.line + 1, 1};
    }
    return place;
}

/// "[json.exception.parse_error.101] parse error at line 1, column 5: syntax error while .." without its front.
std::string detail_of(const Json::exception& error) {
    const std::string message = error.what();
    const std::size_t colon = message.find(": ");
    const std::size_t bracket = message.find("] ");
    if (colon != std::string::npos) return message.substr(colon + 2);
    return bracket == std::string::npos ? message : message.substr(bracket + 2);
}

}  // namespace

Json parse_json_document(std::string_view text, const std::string& file) {
    constexpr int deepest = 16;  // a grammar has 6 levels
    constexpr std::size_t most_values = 50'000'000;
    std::size_t values = 0;
    const auto watch = [&](int depth, Json::parse_event_t, Json&) {
        if (depth > deepest)
            throw InputError({file}, "expected a grammar, found JSON that is nested deeper than any grammar");
        if (++values > most_values) throw LimitError({file}, "more than " + std::to_string(most_values) + " values in JSON");
        return true;
    };
    try {
        return Json::parse(text, watch);
    } catch (const Json::parse_error& error) {
        const SourcePlace place = place_of(text, error.byte > 0 ? error.byte - 1 : 0, file);
        throw InputError(place, "expected JSON, found a " + detail_of(error));
    } catch (const Json::exception& error) {  // a number beyond all numbers
        throw InputError({file}, "expected JSON, found a " + detail_of(error));
    }
}

Json text_json(const std::string& bytes) {
    if (is_utf8(bytes)) return bytes;
    return {{"bytes", as_characters(bytes)}};
}

void JsonValue::fail(const std::string& expected) const {
    throw InputError({file_},
                     (path_.empty() ? "the document" : path_) + ": expected " + expected + ", found " + kind_of(*value_));
}

void JsonValue::fail(const InputError& error) const {
    // what() begins with the place in a text that the user has never seen
    const std::string message = error.what();
    const std::size_t at = message.find("expected");
    throw InputError(
        {file_}, (path_.empty() ? "the document" : path_) + ": " + (at == std::string::npos ? message : message.substr(at)));
}

JsonValue JsonValue::member(const std::string& key) const {
    if (!value_->is_object()) fail("an object with '" + key + "'");
    const auto found = value_->find(key);
    if (found == value_->end()) fail("an object with '" + key + "'");
    return {*found, file_, path_.empty() ? key : path_ + '.' + key};
}

void JsonValue::expect_keys(std::initializer_list<std::string_view> known) const {
    if (!value_->is_object()) fail("an object");
    for (const auto& [key, value] : value_->items()) {
        if (std::ranges::find(known, key) != known.end()) continue;
        std::string list;
        for (const std::string_view name : known) list += (list.empty() ? "" : ", ") + std::string(name);
        throw InputError({file_}, (path_.empty() ? "the document" : path_) + ": expected one of the keys " + list +
                                      ", found '" + key + "'");
    }
}

std::string JsonValue::text() const {
    if (value_->is_string()) return value_->get<std::string>();
    std::string bytes;
    const bool wrapped =
        value_->is_object() && value_->size() == 1 && value_->contains("bytes") && (*value_)["bytes"].is_string();
    if (!wrapped || !as_bytes((*value_)["bytes"].get<std::string>(), bytes))
        fail("a string, or an object with 'bytes' and characters up to U+00FF in it");
    return bytes;
}

double JsonValue::number() const {
    if (!value_->is_number()) fail("a number");
    const double number = value_->get<double>();
    if (!std::isfinite(number)) fail("a finite number");
    return number;
}

int JsonValue::whole(int lowest, int highest) const {
    const double value = value_->is_number() ? value_->get<double>() : std::nan("");
    if (!(value >= lowest && value <= highest) || value != std::floor(value))
        fail("a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest));
    return static_cast<int>(value);
}

bool JsonValue::truth() const {
    if (!value_->is_boolean()) fail("true or false");
    return value_->get<bool>();
}

}  // namespace rinceau
