#include "scene/svg_entities.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "scene/svg_number.h"

namespace rinceau {

namespace {

constexpr int deepest_entity = 32;
constexpr double largest_growth = 64.0 * 1024 * 1024;

// The offset behind `mark`, searched from `from`; the text's size if it does not occur.
std::size_t behind(std::string_view text, std::string_view mark, std::size_t from) {
    const std::size_t at = text.find(mark, from);
    return at == std::string_view::npos ? text.size() : at + mark.size();
}

std::string_view read_name(TextCursor& cursor) {
    const std::size_t start = cursor.at;
    const auto ends = [](char c) { return is_svg_space(c) || c == '>' || c == '"' || c == '\'' || c == '[' || c == ';'; };
    while (!cursor.at_end() && !ends(cursor.peek())) ++cursor.at;
    return cursor.text.substr(start, cursor.at - start);
}

// The declaration "<!ENTITY name 'text'>" whose name comes next; the first one of a name holds. Line breaks become spaces.
void read_entity(TextCursor cursor, XmlEntities& entities) {
    skip_space(cursor);
    const std::string name(read_name(cursor));
    skip_space(cursor);
    const char quote = cursor.peek();
    if (name.empty() || name == "%" || (quote != '"' && quote != '\'')) return;
    const std::size_t end = cursor.text.find(quote, cursor.at + 1);
    if (end == std::string_view::npos) return;
    std::string value(cursor.text.substr(cursor.at + 1, end - cursor.at - 1));
    std::replace_if(
        value.begin(), value.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    entities.emplace(name, std::move(value));
}

// From behind "<!DOCTYPE" to behind its '>'; the text's size if it does not end.
std::size_t read_doctype(std::string_view text, std::size_t at, XmlEntities& entities) {
    constexpr std::string_view entity_mark = "<!ENTITY";
    bool in_subset = false;
    while (at < text.size()) {
        const char c = text[at];
        const std::string_view rest = text.substr(at);
        if (c == '"' || c == '\'') {
            at = behind(text, text.substr(at, 1), at + 1);
        } else if (rest.starts_with("<!--")) {
            at = behind(text, "-->", at + 4);
        } else if (rest.starts_with("<?")) {
            at = behind(text, "?>", at + 2);
        } else if (rest.starts_with(entity_mark)) {
            at += entity_mark.size();
            read_entity({text, at}, entities);
        } else {
            if (c == '[') in_subset = true;
            if (c == ']') in_subset = false;
            ++at;
            if (c == '>' && !in_subset) return at;
        }
    }
    return text.size() + 1;
}

// A reference "&name;" in the text; `quote` is the delimiter of the attribute value around it, 0 in character data.
struct Reference {
    std::size_t begin = 0, end = 0;
    XmlEntities::const_iterator entity;
    char quote = '\0';
};

std::optional<Reference> reference_at(std::string_view text, std::size_t at, const XmlEntities& entities, char quote) {
    TextCursor cursor{text, at + 1};
    const auto entity = entities.find(read_name(cursor));
    if (entity == entities.end() || cursor.peek() != ';') return std::nullopt;
    return Reference{at, cursor.at + 1, entity, quote};
}

std::vector<Reference> references_in(std::string_view text, const XmlEntities& entities, char quote) {
    std::vector<Reference> references;
    for (std::size_t at = text.find('&'); at != std::string_view::npos; at = text.find('&', at)) {
        const std::optional<Reference> reference = reference_at(text, at, entities, quote);
        if (reference) references.push_back(*reference);
        at = reference ? reference->end : at + 1;
    }
    return references;
}

// All references of a document: not those in comments, CDATA sections and processing instructions.
std::vector<Reference> document_references(std::string_view text, const XmlEntities& entities) {
    constexpr std::pair<std::string_view, std::string_view> opaque[] = {{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}};
    std::vector<Reference> references;
    bool in_tag = false;
    char quote = '\0';
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '&' && (quote != '\0' || !in_tag)) {
            const std::optional<Reference> reference = reference_at(text, at, entities, quote);
            if (reference) references.push_back(*reference);
            at = reference ? reference->end : at + 1;
            continue;
        }
        if (c == '<' && !in_tag) {
            const auto skipped = std::find_if(std::begin(opaque), std::end(opaque),
                                              [&](const auto& marks) { return text.substr(at).starts_with(marks.first); });
            if (skipped != std::end(opaque)) {
                at = behind(text, skipped->second, at + skipped->first.size());
                continue;
            }
            in_tag = true;
        } else if (in_tag && quote == '\0') {
            if (c == '"' || c == '\'') quote = c;
            if (c == '>') in_tag = false;
        } else if (c == quote) {
            quote = '\0';
        }
        ++at;
    }
    return references;
}

// An attribute value takes no '<' and not its own delimiter.
void append_value(std::string& result, std::string_view part, char quote) {
    for (const char c : part) {
        if (quote != '\0' && c == '<') {
            result += "&lt;";
        } else if (quote != '\0' && c == quote) {
            result += c == '"' ? "&quot;" : "&apos;";
        } else {
            result += c;
        }
    }
}

class Expander {
  public:
    Expander(const XmlEntities& entities, const SourcePlace& place) : entities_(entities), place_(place) {}

    // Bytes of an entity once everything in it is expanded; grows fast, so a double.
    double size_of(XmlEntities::const_iterator entity, int depth) {
        if (const auto known = sizes_.find(entity->first); known != sizes_.end()) return known->second;
        if (depth > deepest_entity) {
            throw LimitError(place_, "entity \"" + entity->first + "\" refers to itself or nests deeper than " +
                                         std::to_string(deepest_entity) + " levels");
        }
        // Escapes in attribute values make a character six long at most.
        constexpr double longest_escape = 6;
        double size = longest_escape * static_cast<double>(entity->second.size());
        for (const Reference& inner : references_in(entity->second, entities_, '\0'))
            size += size_of(inner.entity, depth + 1);
        sizes_[entity->first] = size;
        return size;
    }

    void append(std::string& result, XmlEntities::const_iterator entity, char quote) const {
        const std::string_view text = entity->second;
        std::size_t at = 0;
        for (const Reference& inner : references_in(text, entities_, quote)) {
            append_value(result, text.substr(at, inner.begin - at), quote);
            append(result, inner.entity, quote);
            at = inner.end;
        }
        append_value(result, text.substr(at), quote);
    }

  private:
    const XmlEntities& entities_;
    SourcePlace place_;
    std::map<std::string, double, std::less<>> sizes_;
};

}  // namespace

SourcePlace place_in_text(std::string_view text, std::size_t offset, const std::string& file_name) {
    SourcePlace place{file_name, 1, 1};
    for (const char c : text.substr(0, offset)) {
        const bool continues = (static_cast<unsigned char>(c) & 0xC0) == 0x80;
        if (c == '\n') {
            ++place.line;
            place.column = 1;
        } else if (!continues) {
            ++place.column;
        }
    }
    return place;
}

XmlDoctype find_doctype(std::string_view text, const std::string& file_name) {
    constexpr std::string_view mark = "<!DOCTYPE";
    for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at)) {
        const std::string_view rest = text.substr(at);
        if (rest.starts_with("<!--")) {
            at = behind(text, "-->", at + 4);
        } else if (rest.starts_with("<?")) {
            at = behind(text, "?>", at + 2);
        } else if (rest.starts_with(mark)) {
            XmlDoctype doctype{at, at, {}};
            doctype.end = read_doctype(text, at + mark.size(), doctype.entities);
            if (doctype.end > text.size()) throw InputError(place_in_text(text, at, file_name), "the DOCTYPE does not end");
            return doctype;
        } else {
            return {};
        }
    }
    return {};
}

std::string with_entities_expanded(std::string_view text, const XmlEntities& entities, std::size_t max_bytes,
                                   const std::string& file_name) {
    if (entities.empty()) return std::string(text);
    const std::vector<Reference> references = document_references(text, entities);

    if (references.empty()) return std::string(text);

    // How long will the result be?
    const SourcePlace place = place_in_text(text, references.front().begin, file_name);
    Expander expander(entities, place);
    double growth = 0;
    for (const Reference& reference : references) growth += expander.size_of(reference.entity, 1);
    if (growth > largest_growth || static_cast<double>(text.size()) + growth > static_cast<double>(max_bytes)) {
        throw LimitError(place, "the expansion of entities is too large (more than " +
                                    std::to_string(std::min(static_cast<std::size_t>(largest_growth), max_bytes)) +
                                    " bytes)");
    }

    // Put the entities in.
    std::string result;
    result.reserve(text.size());
    std::size_t at = 0;
    for (const Reference& reference : references) {
        result += text.substr(at, reference.begin - at);
        expander.append(result, reference.entity, reference.quote);
        at = reference.end;
    }
    result += text.substr(at);
    return result;
}

}  // namespace rinceau
