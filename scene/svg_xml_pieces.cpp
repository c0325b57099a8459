#include "scene/svg_xml_pieces.h"

#include <string_view>

#include "scene/svg_number.h"
#include "scene/svg_source.h"

namespace rinceau {
namespace {

struct OpenElement {
    std::string_view name;
    std::size_t at = 0;
};

/// Reads the document tag by tag and deals its text out to the pieces.
class PieceCutter {
  public:
    PieceCutter(const std::string& text, const std::string& file_name) : text_(text), file_name_(file_name) {
        pieces_.emplace_back();
        stack_.push_back(0);
    }

    std::vector<XmlPiece> cut() {
        while (at_ < text_.size()) step();
        copy_until(text_.size());
        if (!open_.empty())
            fail(text_.size(), "expected </" + std::string(open_.back().name) + "> for the element opened at line " +
                                   std::to_string(place_in_text(text_, open_.back().at, {}).line) + ", found the end of the file");
        if (!any_element_) fail(text_.size(), "expected an <svg> element, found none");
        return std::move(pieces_);
    }

  private:
    [[noreturn]] void fail(std::size_t at, const std::string& message) const {
        throw InputError(place_in_text(text_, at, file_name_), message);
    }

    bool starts_with(std::string_view token) const { return text_.compare(at_, token.size(), token) == 0; }

    XmlPiece& piece() { return pieces_[stack_.back()]; }

    void copy_until(std::size_t end) {
        piece().text.append(text_, copied_, end - copied_);
        copied_ = end;
    }

    /// Everything up to and with `terminator` belongs to the thing that opens here.
    void skip_past(std::string_view terminator, std::size_t from, const char* what) {
        const std::size_t end = text_.find(terminator, from);
        if (end == std::string::npos)
            fail(at_, std::string("expected \"") + std::string(terminator) + "\" at the end of " + what + ", found the end of the file");
        at_ = end + terminator.size();
    }

    void step() {
        const std::size_t tag = text_.find('<', at_);
        read_text(at_, tag == std::string::npos ? text_.size() : tag);
        if (tag == std::string::npos) {
            at_ = text_.size();
            return;
        }
        at_ = tag;
        if (starts_with("<!--")) return skip_past("-->", at_ + 4, "a comment");
        if (starts_with("<![CDATA[")) return skip_past("]]>", at_ + 9, "a CDATA section");
        if (starts_with("<?")) return skip_past("?>", at_ + 2, "a processing instruction");
        if (starts_with("<!")) return skip_past(">", at_ + 2, "a declaration");
        if (starts_with("</")) return close_element();
        open_element();
    }

    /// White space alone between two tags of a text element is a word space, but the XML library would drop it.
    void read_text(std::size_t begin, std::size_t end) {
        if (text_level_ == 0 || begin == end || !trimmed(std::string_view(text_).substr(begin, end - begin)).empty()) return;
        copy_until(begin);
        piece().text += "&#x20;";
        copied_ = begin + 1;
    }

    std::size_t name_end(std::size_t from) const {
        std::size_t end = from;
        while (end < text_.size() && !is_svg_space(text_[end]) && text_[end] != '>' && text_[end] != '/') ++end;
        return end;
    }

    std::size_t tag_end() const {
        char quote = 0;
        for (std::size_t i = at_ + 1; i < text_.size(); ++i) {
            const char c = text_[i];
            if (quote != 0) {
                if (c == quote) quote = 0;
            } else if (c == '"' || c == '\'') {
                quote = c;
            } else if (c == '>') {
                return i;
            } else if (c == '<') {
                fail(i, "expected \">\" at the end of a tag, found \"<\"");
            }
        }
        fail(at_, quote != 0 ? "expected a closing quotation mark in this tag, found the end of the file"
                             : "expected \">\" at the end of this tag, found the end of the file");
    }

    void open_element() {
        const std::size_t end = tag_end(), name_stop = name_end(at_ + 1);
        const std::string_view name = std::string_view(text_).substr(at_ + 1, name_stop - at_ - 1);
        if (name.empty()) fail(at_, "expected the name of an element after \"<\"");
        if (open_.empty() && any_element_) fail(at_, "expected the end of the file after the root element, found <" + std::string(name) + ">");
        any_element_ = true;
        const bool self_closing = text_[end - 1] == '/';
        at_ = end + 1;
        const int level = static_cast<int>(open_.size()) + 1;
        if (level % piece_depth == 0) begin_piece(self_closing);
        if (self_closing) return;
        open_.push_back({name, name_stop - name.size() - 1});
        if (text_level_ > 0 || name == "text" || name.ends_with(":text")) ++text_level_;
    }

    void begin_piece(bool self_closing) {
        copy_until(at_);
        pieces_[stack_.back()].inner.push_back(pieces_.size());
        pieces_.emplace_back();
        pieces_.back().first_line = place_in_text(text_, at_, {}).line;
        pieces_.back().text = "<x>";
        if (self_closing) {
            pieces_.back().text += "</x>";
        } else {
            stack_.push_back(pieces_.size() - 1);
        }
    }

    void end_piece(std::size_t close_at) {
        copy_until(close_at);
        const std::size_t inner = stack_.back();
        pieces_[inner].text += "</x>";
        stack_.pop_back();
        // The lines that the content took keep the numbers of the following ones right.
        for (const char c : pieces_[inner].text)
            if (c == '\n') piece().text += '\n';
    }

    void close_element() {
        const std::size_t end = tag_end(), name_stop = name_end(at_ + 2);
        const std::string_view name = std::string_view(text_).substr(at_ + 2, name_stop - at_ - 2);
        if (open_.empty()) fail(at_, "found </" + std::string(name) + "> without an opening tag");
        if (open_.back().name != name)
            fail(at_, "expected </" + std::string(open_.back().name) + ">, found </" + std::string(name) + ">");
        if (open_.size() % piece_depth == 0) end_piece(at_);
        open_.pop_back();
        if (text_level_ > 0) --text_level_;
        at_ = end + 1;
    }

    const std::string& text_;
    const std::string& file_name_;
    std::vector<XmlPiece> pieces_;
    std::vector<std::size_t> stack_;  ///< pieces that are being written, outermost first
    std::vector<OpenElement> open_;
    std::size_t at_ = 0;
    std::size_t copied_ = 0;  ///< the text before this has been dealt out
    int text_level_ = 0;      ///< open elements from the outermost text element inwards
    bool any_element_ = false;
};

}  // namespace

std::vector<XmlPiece> cut_into_pieces(const std::string& text, const std::string& file_name) {
    return PieceCutter(text, file_name).cut();
}

}  // namespace rinceau
