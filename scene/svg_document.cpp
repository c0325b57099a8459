#include "scene/svg_document.h"

#include <algorithm>
#include <cassert>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/svg_number.h"

namespace rinceau {

namespace {

// The XML library looks through all attributes of an element for each new one.
constexpr std::size_t most_attributes = 1000;

// Elements this deep start a part of their own; well below the 98 levels at which tinyxml2 ends.
constexpr int levels_per_part = 64;

// The text of all parts that start at the same level: one document, whose lines are those of the whole.
struct LevelText {
    std::string text;
    int line = 1;
};

// Reads the text tag by tag, checks that tags match, and deals it out to the levels.
class PartSplitter {
  public:
    PartSplitter(const std::string& text, const SvgSourceOptions& options) : text_(text), options_(options) {
        stand_in_ = "part";
        while (text.find(stand_in_) != std::string::npos) stand_in_ += '_';
    }

    std::vector<std::string> split() {
        levels_.push_back({});
        while (at_ < text_.size()) {
            const std::size_t tag = std::min(text_.find('<', at_), text_.size());
            read_content(tag);
            if (tag < text_.size()) read_markup();
        }
        if (!open_.empty()) {
            fail(open_.back().begin, "element <" + std::string(open_.back().name) + "> is not closed");
        }
        std::vector<std::string> texts;
        for (std::size_t i = 0; i < levels_.size(); ++i) {
            texts.push_back(i == 0 ? std::move(levels_[i].text)
                                   : "<" + stand_in_ + ">" + levels_[i].text + "</" + stand_in_ + ">");
        }
        return texts;
    }

    const std::string& stand_in() const { return stand_in_; }

  private:
    struct OpenElement {
        std::string_view name;
        std::size_t begin = 0;
    };

    [[noreturn]] void fail(std::size_t at, const std::string& message) const {
        throw InputError(place_in_text(text_, at, options_.file_name), message);
    }

    // Character data up to `end`. White space alone between tags inside <text> is kept by writing its first character as a
    // reference.
    void read_content(std::size_t end) {
        std::string_view content = std::string_view(text_).substr(at_, end - at_);
        if (text_depth_ > 0 && !content.empty() && trimmed(content).empty()) {
            put("&#32;");
            if (content.front() != '\n') content.remove_prefix(1);
        }
        put(content);
        at_ = end;
    }

    void put(std::string_view piece) {
        LevelText& level = levels_[level_];
        level.text += piece;
        for (const char c : piece) level.line += c == '\n' ? 1 : 0;
        line_ = std::max(line_, level.line);
    }

    // Brings the current level's text to the line that has been reached.
    void catch_up() {
        LevelText& level = levels_[level_];
        level.text.append(static_cast<std::size_t>(line_ - level.line), '\n');
        level.line = line_;
    }

    void put_up_to(std::size_t end) {
        put(std::string_view(text_).substr(at_, end - at_));
        at_ = end;
    }

    void read_markup() {
        const std::string_view rest = std::string_view(text_).substr(at_);
        if (rest.starts_with("<!--")) return put_up_to(behind("-->", "comment"));
        if (rest.starts_with("<![CDATA[")) return put_up_to(behind("]]>", "CDATA section"));
        if (rest.starts_with("<?")) return put_up_to(behind("?>", "processing instruction"));
        if (rest.starts_with("<!")) return put_up_to(behind(">", "declaration"));
        if (rest.starts_with("</")) return read_end_tag();
        read_start_tag();
    }

    std::size_t behind(std::string_view mark, const char* what) const {
        const std::size_t end = text_.find(mark, at_ + 2);
        if (end == std::string::npos) fail(at_, std::string(what) + " is not closed");
        return end + mark.size();
    }

    std::string_view name_at(std::size_t at) const {
        std::size_t end = at;
        while (end < text_.size() && !is_svg_space(text_[end]) && text_[end] != '>' && text_[end] != '/' &&
               text_[end] != '<')
            ++end;
        return std::string_view(text_).substr(at, end - at);
    }

    // The '>' of the tag that starts here; quoted values may hold one too.
    std::size_t tag_end() const {
        char quote = '\0';
        for (std::size_t at = at_ + 1; at < text_.size(); ++at) {
            const char c = text_[at];
            if (quote != '\0') {
                if (c == quote) quote = '\0';
            } else if (c == '"' || c == '\'') {
                quote = c;
            } else if (c == '>') {
                return at;
            } else if (c == '<') {
                break;
            }
        }
        fail(at_, "tag <" + std::string(name_at(at_ + 1)) + " is not closed");
    }

    void check_attribute_count(std::size_t begin, std::size_t end) const {
        std::size_t count = 0;
        char quote = '\0';
        for (std::size_t at = begin; at < end; ++at) {
            const char c = text_[at];
            if (quote != '\0')
                quote = c == quote ? '\0' : quote;
            else if (c == '"' || c == '\'')
                quote = c, ++count;
        }
        if (count > most_attributes)
            throw LimitError(place_in_text(text_, begin, options_.file_name),
                             "an element has more than " + std::to_string(most_attributes) + " attributes");
    }

    void read_start_tag() {
        const std::size_t end = tag_end();
        const std::string_view name = name_at(at_ + 1);
        if (name.empty()) fail(at_, "expected the name of an element after \"<\"");
        const std::size_t begin = at_;
        const bool is_empty = text_[end - 1] == '/';
        const bool starts_part = !open_.empty() && open_.size() % levels_per_part == 0;
        if (static_cast<int>(open_.size()) >= options_.max_depth) {
            throw LimitError(place_in_text(text_, begin, options_.file_name),
                             "elements nest deeper than the limit of " + std::to_string(options_.max_depth) + " levels");
        }
        check_attribute_count(begin, end);
        if (starts_part) enter_part();
        put_up_to(end + 1);
        if (is_empty) {
            if (starts_part) leave_part();
            return;
        }
        open_.push_back({name, begin});
        if (name == "text" || name.ends_with(":text")) ++text_depth_;
    }

    void read_end_tag() {
        const std::string_view name = name_at(at_ + 2);
        if (open_.empty()) fail(at_, "end tag </" + std::string(name) + "> without an open element");
        if (open_.back().name != name) {
            const SourcePlace opened = place_in_text(text_, open_.back().begin, {});
            fail(at_, "expected </" + std::string(open_.back().name) + "> (opened in line " + std::to_string(opened.line) +
                          "), found </" + std::string(name) + ">");
        }
        open_.pop_back();
        if (name == "text" || name.ends_with(":text")) --text_depth_;
        put_up_to(behind(">", "end tag"));
        if (!open_.empty() && open_.size() % levels_per_part == 0) leave_part();
    }

    void enter_part() {
        put("<" + stand_in_ + ">");
        ++level_;
        if (level_ == levels_.size()) levels_.push_back({});
        catch_up();
    }

    void leave_part() {
        --level_;
        catch_up();
        put("</" + stand_in_ + ">");
    }

    const std::string& text_;
    const SvgSourceOptions& options_;
    std::string stand_in_;
    std::vector<LevelText> levels_;
    std::size_t level_ = 0;
    std::size_t at_ = 0;
    int line_ = 1;
    int text_depth_ = 0;
    std::vector<OpenElement> open_;
};

std::unique_ptr<tinyxml2::XMLDocument> parse_part(const std::string& text, const SvgSourceOptions& options) {
    auto document = std::make_unique<tinyxml2::XMLDocument>();
    document->Parse(text.data(), text.size());
    if (!document->Error()) return document;
    throw InputError({options.file_name, document->ErrorLineNum(), 1},
                     std::string("this is not well-formed XML (") + document->ErrorName() + ")");
}

void collect_stand_ins(tinyxml2::XMLElement* element, const std::string& name, std::vector<tinyxml2::XMLElement*>& found) {
    for (; element; element = element->NextSiblingElement()) {
        if (name == element->Name()) {
            found.push_back(element);
        } else {
            collect_stand_ins(element->FirstChildElement(), name, found);
        }
    }
}

// Puts the parts of the deeper document into the places that stand for them, both in document order.
void put_back(tinyxml2::XMLDocument& document, const tinyxml2::XMLDocument& deeper, tinyxml2::XMLElement* first,
              const std::string& stand_in) {
    std::vector<tinyxml2::XMLElement*> places;
    collect_stand_ins(first, stand_in, places);
    const tinyxml2::XMLElement* part = deeper.RootElement()->FirstChildElement();
    for (tinyxml2::XMLElement* place : places) {
        assert(part);
        tinyxml2::XMLNode* parent = place->Parent();
        parent->InsertAfterChild(place, part->DeepClone(&document));
        parent->DeleteChild(place);
        part = part->NextSiblingElement();
    }
}

}  // namespace

std::unique_ptr<tinyxml2::XMLDocument> parse_svg_document(const std::string& text, const SvgSourceOptions& options) {
    PartSplitter splitter(text, options);
    const std::vector<std::string> levels = splitter.split();
    std::vector<std::unique_ptr<tinyxml2::XMLDocument>> documents;
    for (const std::string& level : levels) documents.push_back(parse_part(level, options));
    for (std::size_t i = documents.size() - 1; i > 0; --i) {
        // Below the first level the root is the holder of the parts, named as the stand-ins are.
        tinyxml2::XMLElement* root = documents[i - 1]->RootElement();
        put_back(*documents[i - 1], *documents[i], i == 1 ? root : root->FirstChildElement(), splitter.stand_in());
    }
    return std::move(documents.front());
}

}  // namespace rinceau
