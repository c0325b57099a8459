#include "scene/svg_splice.h"

#include <algorithm>

#include "scene/svg_number.h"

namespace rinceau {
namespace {

class ReferenceWalk {
  public:
    ReferenceWalk(const SvgTree& tree, const std::unordered_set<const SvgNode*>& removed) : tree_(tree), removed_(removed) {}

    std::vector<const SvgNode*> find() {
        read(tree_.root(), false);
        // what is kept may refer to more
        for (std::size_t i = 0; i < kept_.size(); ++i) read_kept(*kept_[i]);
        std::erase_if(kept_, [&](const SvgNode* node) { return is_inside_kept(*node->parent); });
        std::ranges::sort(kept_, {}, [&](const SvgNode* node) { return order_.at(node); });
        return kept_;
    }

  private:
    void read(const SvgNode& node, bool gone) {
        order_.emplace(&node, order_.size());
        gone = gone || removed_.contains(&node);
        if (gone && is_svg(node) && node.name == "style") keep(node);
        if (!gone) read_references(node);
        for (const SvgNode* child = node.first_child; child != nullptr; child = child->next)
            if (!is_text(*child))
                read(*child, gone);
            else if (!gone)
                read_value(child->text);
    }

    void read_kept(const SvgNode& node) {
        read_references(node);
        for (const SvgNode* child = node.first_child; child != nullptr; child = child->next)
            if (!is_text(*child)) read_kept(*child);
    }

    void read_references(const SvgNode& node) {
        for (const SvgAttribute& attribute : node.attributes) {
            const std::string_view value = trimmed(attribute.value);
            if (value.starts_with('#')) refer_to(value.substr(1));
            read_value(value);
        }
    }

    void read_value(std::string_view value) {
        for (std::size_t at = value.find("url("); at != std::string_view::npos; at = value.find("url(", at + 1)) {
            const std::size_t begin = value.find('#', at);
            if (begin == std::string_view::npos) return;
            const std::size_t end = value.find_first_of("\"') ", begin);
            refer_to(value.substr(begin + 1, end == std::string_view::npos ? end : end - begin - 1));
        }
    }

    void refer_to(std::string_view id) {
        const SvgNode* node = tree_.find(id);
        for (const SvgNode* up = node; up != nullptr; up = up->parent)
            if (removed_.contains(up)) return keep(*node);
    }

    void keep(const SvgNode& node) {
        if (known_.insert(&node).second) kept_.push_back(&node);
    }

    bool is_inside_kept(const SvgNode& node) const {
        for (const SvgNode* up = &node; up != nullptr; up = up->parent)
            if (known_.contains(up)) return true;
        return false;
    }

    const SvgTree& tree_;
    const std::unordered_set<const SvgNode*>& removed_;
    std::unordered_map<const SvgNode*, std::size_t> order_;
    std::unordered_set<const SvgNode*> known_;
    std::vector<const SvgNode*> kept_;
};

}  // namespace

std::string with_edits(const std::string& text, std::vector<TextEdit> edits) {
    std::ranges::stable_sort(edits, {}, &TextEdit::begin);
    std::string result;
    std::size_t done = 0;
    for (const TextEdit& edit : edits) {
        result.append(text, done, edit.begin - done);
        result += edit.text;
        done = edit.end;
    }
    return result.append(text, done);
}

std::vector<const SvgNode*> referred_to(const SvgTree& tree, const std::unordered_set<const SvgNode*>& removed) {
    return ReferenceWalk(tree, removed).find();
}

TextEdit addition_to_definitions(const std::string& text, const SvgTree& tree, const SvgMarkupIndex& markup,
                                 const std::string& elements) {
    for (const SvgNode* child = tree.root().first_child; child != nullptr; child = child->next) {
        if (is_text(*child) || !is_svg(*child) || child->name != "defs") continue;
        const SvgMarkup& defs = markup.of(*child);
        if (defs.tag_end < defs.end) return {defs.content_end, defs.content_end, elements};
        const std::string tag = text.substr(defs.begin, defs.end - defs.begin);
        const std::string name = tag.substr(1, tag.find_first_of(" \t\n\r/", 1) - 1);
        return {defs.begin, defs.end, tag.substr(0, tag.rfind('/')) + ">" + elements + "</" + name + ">"};
    }
    const std::size_t inside = markup.of(tree.root()).tag_end;
    return {inside, inside, "<defs xmlns=\"http://www.w3.org/2000/svg\">" + elements + "</defs>"};
}

TextEdit removal(const std::string& text, const SvgMarkup& element) {
    std::size_t begin = element.begin;
    while (begin > 0 && is_svg_space(text[begin - 1])) --begin;
    const bool own_line = begin > 0 && text[begin - 1] == '>' && element.end < text.size() &&
                          (is_svg_space(text[element.end]) || text[element.end] == '<');
    return {own_line ? begin : element.begin, element.end, {}};
}

}  // namespace rinceau
