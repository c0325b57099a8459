#pragma once
// JSON that people and other programs have written: values, and where one stands in a document.

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "scene/input_error.h"

namespace rinceau {

using Json = nlohmann::ordered_json;

/// Bytes as JSON holds them: a string if they are UTF-8, else {"bytes": ".."} with a character U+0000 to U+00FF per byte.
Json text_json(const std::string& bytes);

/// Throws InputError with line and column where the text is no JSON, and for one that is nested deeper than any grammar;
/// LimitError for more values than a grammar can have.
Json parse_json_document(std::string_view text, const std::string& file);

/// A value and where it stands: "productions[3].condition".
class JsonValue {
  public:
    JsonValue(const Json& value, std::string file, std::string path = {})
        : value_(&value), file_(std::move(file)), path_(std::move(path)) {}

    const Json& json() const { return *value_; }

    [[noreturn]] void fail(const std::string& expected) const;
    /// The mistake of a part, which `error` says.
    [[noreturn]] void fail(const InputError& error) const;

    bool has(const std::string& key) const { return value_->contains(key) && !(*value_)[key].is_null(); }
    JsonValue member(const std::string& key) const;
    /// Every key is one of `known`, or is said to be unknown. Also says so if this is no object.
    void expect_keys(std::initializer_list<std::string_view> known) const;
    /// Calls visit(JsonValue) for each element.
    template <class Visit>
    void each(Visit visit) const {
        if (!value_->is_array()) fail("a list");
        for (std::size_t i = 0; i < value_->size(); ++i)
            visit(JsonValue((*value_)[i], file_, path_ + '[' + std::to_string(i) + ']'));
    }

    /// Throw InputError with the place if the value is something else.
    std::string text() const;
    double number() const;
    int whole(int lowest, int highest) const;
    bool truth() const;

  private:
    const Json* value_;
    std::string file_;
    std::string path_;
};

}  // namespace rinceau
