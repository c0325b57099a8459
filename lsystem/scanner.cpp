#include "lsystem/scanner.h"

#include <algorithm>
#include <charconv>

#include "lsystem/mistakes.h"
#include "lsystem/number_text.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

void Scanner::skip_blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
}

std::string Scanner::found() const {
    if (at_ >= text_.size()) return "the end of the statement";
    std::size_t end = at_ + 1;
    constexpr std::size_t longest = 24;  // enough to recognise it
    while (end < text_.size() && end - at_ < longest && continues_name(text_[at_]) && continues_name(text_[end])) ++end;
    return '\'' + std::string(text_.substr(at_, end - at_)) + '\'';
}

void Scanner::fail(std::string_view expected) {
    skip_blanks();
    throw InputError(place_at(at_), "expected " + std::string(expected) + ", found " + found());
}

bool Scanner::at_end() {
    skip_blanks();
    return at_ >= text_.size();
}

std::size_t Scanner::position() {
    skip_blanks();
    return at_;
}

SourcePlace Scanner::place_at(std::size_t position) {
    last_place_ = place_after(last_place_, text_, position);
    return place_in(statement_, last_place_);
}

SourcePlace Scanner::place() { return place_at(position()); }

bool Scanner::peek(std::string_view token) {
    skip_blanks();
    return text_.substr(at_).starts_with(token);
}

bool Scanner::take(std::string_view token) {
    if (!peek(token)) return false;
    at_ += token.size();
    return true;
}

void Scanner::expect(std::string_view token) {
    if (!take(token)) fail('\'' + std::string(token) + '\'');
}

void Scanner::expect_end(std::string_view otherwise) {
    if (!at_end()) fail(otherwise);
}

std::string Scanner::name(std::string_view what) {
    skip_blanks();
    if (at_ >= text_.size() || !starts_name(text_[at_])) fail(what);
    const std::size_t start = at_;
    while (at_ < text_.size() && continues_name(text_[at_])) ++at_;
    return std::string(text_.substr(start, at_ - start));
}

std::string Scanner::property() {
    skip_blanks();
    const std::size_t start = at_;
    while (at_ < text_.size() && ((text_[at_] >= 'a' && text_[at_] <= 'z') || text_[at_] == '-')) ++at_;
    if (at_ == start) fail("the name of a property");
    return std::string(text_.substr(start, at_ - start));
}

std::string Scanner::word() {
    skip_blanks();
    const std::size_t start = at_;
    while (at_ < text_.size() && !is_blank(text_[at_]) &&
           std::string_view(",;()").find(text_[at_]) == std::string_view::npos)
        ++at_;
    return std::string(text_.substr(start, at_ - start));
}

double Scanner::number() {
    skip_blanks();
    double value = 0;
    const std::size_t start = at_ < text_.size() && text_[at_] == '+' ? at_ + 1 : at_;
    const char first = start < text_.size() ? text_[start] : ' ';
    if (!is_digit(first) && first != '.' && first != '-') fail("a number");
    const auto result = std::from_chars(text_.data() + start, text_.data() + text_.size(), value);
    // from_chars also reads "-inf" and "-nan"
    if (result.ec != std::errc{} || !(value - value == 0)) fail("a number between 1e-307 and 1e308 in size");
    at_ = static_cast<std::size_t>(result.ptr - text_.data());
    return value;
}

int Scanner::integer(std::string_view what) {
    skip_blanks();
    int value = 0;
    const auto result = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (result.ec != std::errc{} || value < 0) fail(what);
    at_ = static_cast<std::size_t>(result.ptr - text_.data());
    return value;
}

std::uint64_t Scanner::large_integer(std::string_view what) {
    skip_blanks();
    std::uint64_t value = 0;
    const auto result = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (result.ec != std::errc{}) fail(what);
    at_ = static_cast<std::size_t>(result.ptr - text_.data());
    return value;
}

std::string_view Scanner::peek_name() {
    skip_blanks();
    if (at_ >= text_.size() || !starts_name(text_[at_])) return {};
    std::size_t end = at_ + 1;
    while (end < text_.size() && continues_name(text_[end])) ++end;
    return text_.substr(at_, end - at_);
}

std::string_view Scanner::raw_quoted(std::size_t& start) {
    expect("\"");
    start = at_;
    const std::size_t end = text_.find('"', at_);
    if (end == std::string_view::npos) {
        --at_;
        fail("a closing quotation mark for this one");
    }
    at_ = end + 1;
    return text_.substr(start, end - start);
}

std::string Scanner::quoted() {
    expect("\"");
    const std::size_t start = at_ - 1;
    std::string value;
    for (; at_ < text_.size(); ++at_) {
        const char c = text_[at_];
        if (c == '"') {
            ++at_;
            return value;
        }
        if (c == '\n') {
            while (!value.empty() && is_blank(value.back())) value.pop_back();
            value += ' ';
            while (at_ + 1 < text_.size() && is_blank(text_[at_ + 1])) ++at_;
        } else if (c == '\\' && at_ + 1 < text_.size()) {
            const char escaped = text_[++at_];
            const std::size_t known = std::string_view("\"\\nrt").find(escaped);
            if (known == std::string_view::npos) fail("one of \\\" \\\\ \\n \\r \\t");
            value += "\"\\\n\r\t"[known];
        } else {
            value += c;
        }
    }
    at_ = start;
    fail("a closing quotation mark for this one");
}

void Scanner::keep(const InputError& error) {
    if (!add_mistake(mistakes_, error)) throw InputError(error);
}

bool Scanner::skip_to(std::string_view token) {
    const std::size_t found = text_.find(token, at_);
    at_ = std::min(found, text_.size());
    return found != std::string_view::npos;
}

void Scanner::skip_piece() {
    bool in_string = false;
    for (; at_ < text_.size(); ++at_) {
        const char c = text_[at_];
        if (c == ';' && !in_string) return;
        if (c == '"') in_string = !in_string;
        if (c == '\\' && in_string && at_ + 1 < text_.size()) ++at_;
    }
}

Expression Scanner::expression_or_one(std::string_view text, std::size_t start) {
    const SourcePlace place = place_at(start);
    try {
        return parse_expression(text, place);
    } catch (const InputError& error) {
        keep(error);
        return number_expression(1);
    }
}

Expression Scanner::expression_here(const ExpressionForm& form) {
    skip_blanks();
    std::size_t length = 0;
    Expression expression = parse_expression_before(text_.substr(at_), place_at(at_), form, length);
    at_ += length;
    return expression;
}

Expression Scanner::expression_until(std::string_view stops) {
    skip_blanks();
    const std::size_t start = at_;
    int depth = 0;
    for (; at_ < text_.size(); ++at_) {
        const char c = text_[at_];
        if (depth == 0 && stops.find(c) != std::string_view::npos) break;
        if (c == '(') ++depth;
        if (c == ')') --depth;
    }
    if (at_ == text_.size() && !stops.empty()) fail("')' behind the arguments");
    return expression_or_one(text_.substr(start, at_ - start), start);
}

Expression Scanner::condition() {
    skip_blanks();
    const std::size_t start = at_;
    if (!skip_to("->")) fail("'->' after the condition");
    return expression_or_one(text_.substr(start, at_ - start), start);
}

namespace {

bool is_bracket(const ModuleTemplate& module) { return module.symbol == "[" || module.symbol == "]"; }

bool is_command(char c) { return find_turtle_command({&c, 1}) != nullptr; }

}  // namespace

ModuleTemplate Scanner::module() {
    ModuleTemplate result;
    result.place = place();
    if (starts_name(text_[at_])) {
        result.symbol = name("a symbol");
    } else if (is_command(text_[at_]) && !peek("->")) {
        result.symbol.assign(1, text_[at_++]);
    } else {
        fail("a symbol or one of the commands + - f * | [ ] ; z fill stroke");
    }
    return result;
}

void Scanner::read_arguments(ModuleTemplate& module) {
    if (!take("(") || take(")")) return;
    do {
        module.arguments.push_back(expression_until(",)"));
    } while (take(","));
    expect(")");
}

void Scanner::skip_what_begins_no_module(std::string_view stops) {
    if (!take("->")) ++at_;
    while (at_ < text_.size() && !is_blank(text_[at_]) && !starts_name(text_[at_]) && !is_command(text_[at_]) &&
           stops.find(text_[at_]) == std::string_view::npos)
        ++at_;
}

std::vector<ModuleTemplate> Scanner::modules(std::string_view stops) {
    std::vector<ModuleTemplate> result;
    bool cut = false;  // arguments without an end have swallowed modules: whether brackets fit cannot be known
    while (!at_end() && stops.find(text_[at_]) == std::string_view::npos) {
        const std::size_t count = result.size();
        try {
            result.push_back(module());
            read_arguments(result.back());
        } catch (const InputError& error) {
            keep(error);
            if (result.size() == count) {
                skip_what_begins_no_module(stops);
            } else {
                result.pop_back();
                cut = true;
            }
        }
    }
    if (cut) std::erase_if(result, is_bracket);
    return result;
}

}  // namespace rinceau
