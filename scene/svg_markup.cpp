#include "scene/svg_markup.h"

#include <algorithm>

namespace rinceau {
namespace {

constexpr auto npos = std::string_view::npos;

/// Behind the '>' of the tag that starts at `at`; quoted values may hold one too.
std::size_t behind_tag(std::string_view text, std::size_t at) {
    char quote = '\0';
    for (; at < text.size(); ++at) {
        const char c = text[at];
        if (quote != '\0')
            quote = c == quote ? '\0' : quote;
        else if (c == '"' || c == '\'')
            quote = c;
        else if (c == '>')
            return at + 1;
    }
    return text.size();
}

std::size_t behind(std::string_view text, std::size_t at, std::string_view mark) {
    const std::size_t found = text.find(mark, at);
    return found == npos ? text.size() : found + mark.size();
}

/// The elements in the order of their start tags. The text is known to be well formed.
std::vector<SvgMarkup> elements_of(std::string_view text) {
    std::vector<SvgMarkup> elements;
    std::vector<std::size_t> open;
    std::size_t at = 0;
    while ((at = text.find('<', at)) != npos) {
        const std::string_view rest = text.substr(at);
        if (rest.starts_with("<!--")) {
            at = behind(text, at, "-->");
        } else if (rest.starts_with("<![CDATA[")) {
            at = behind(text, at, "]]>");
        } else if (rest.starts_with("<?")) {
            at = behind(text, at, "?>");
        } else if (rest.starts_with("<!")) {
            at = behind(text, at, ">");
        } else if (rest.starts_with("</")) {
            SvgMarkup& element = elements[open.back()];
            open.pop_back();
            element.content_end = at;
            element.end = at = behind(text, at, ">");
        } else {
            const std::size_t end = behind_tag(text, at);
            elements.push_back({at, end, end, end});
            if (text[end - 2] != '/') open.push_back(elements.size() - 1);
            at = end;
        }
    }
    return elements;
}

void collect_elements(const SvgNode& element, std::vector<const SvgNode*>& nodes) {
    nodes.push_back(&element);
    for (const SvgNode* child = element.first_child; child != nullptr; child = child->next)
        if (!is_text(*child)) collect_elements(*child, nodes);
}

}  // namespace

SvgMarkupIndex::SvgMarkupIndex(std::string_view text, const SvgTree& tree) {
    const std::vector<SvgMarkup> elements = elements_of(text);
    std::vector<const SvgNode*> nodes;
    collect_elements(tree.root(), nodes);
    for (std::size_t i = 0; i < std::min(nodes.size(), elements.size()); ++i) places_.emplace(nodes[i], elements[i]);
}

}  // namespace rinceau
