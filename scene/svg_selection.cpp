#include "scene/svg_selection.h"

#include <unordered_map>

#include "scene/svg_draw.h"
#include "scene/svg_effects.h"

namespace rinceau {
namespace {

bool is_group(const SvgNode& node) { return is_svg(node) && (node.name == "g" || node.name == "a"); }

bool has_editor_attribute(const SvgNode& node, std::string_view name, std::string_view value) {
    for (const SvgAttribute& attribute : node.attributes)
        if (attribute.space == SvgNamespace::other && attribute.name == name && attribute.value == value) return true;
    return false;
}

bool is_layer(const SvgNode& node) { return has_editor_attribute(node, "groupmode", "layer"); }
bool is_locked(const SvgNode& node) { return has_editor_attribute(node, "insensitive", "true"); }
bool has_rules(const SvgNode& node) { return is_group(node) && find_attribute(node, rules_group_attribute) != nullptr; }

class Selector {
  public:
    Selector(SvgReader& reader, std::span<const std::string> ids) : reader_(reader) {
        for (const std::string& id : ids)
            if (const SvgNode* node = reader.tree.find(id)) ask_for(*node);
        if (ids.empty()) asked_.insert(&reader.tree.root());
    }

    SvgSelection select(const SvgContext& root) {
        SvgSelection result;
        const bool all = asked_.contains(root.node);
        for (const SvgNode* child = root.node->first_child; child != nullptr; child = child->next)
            if (!is_text(*child)) visit(root, *child, all);
        enter_single_group();
        if (chosen_.empty()) return result;
        if (chosen_.size() == 1 && has_rules(*chosen_.front())) {
            result.rules = result.parent = chosen_.front();
            for (const SvgNode* child = result.rules->first_child; child != nullptr; child = child->next)
                if (!is_text(*child)) result.chosen.push_back(child);
            return result;
        }
        result.parent = chosen_.back()->parent;
        result.chosen = std::move(chosen_);
        return result;
    }

  private:
    /// The element itself, or the one around it that can be replaced as a whole. What stands in definitions is passed over.
    void ask_for(const SvgNode& node) {
        const SvgNode* meant = &node;
        for (const SvgNode* up = &node; up->parent != nullptr; up = up->parent) {
            if (!is_group(*up)) meant = up;
        }
        for (const SvgNode* up = meant; up->parent != nullptr; up = up->parent) {
            if (has_rules(*up)) meant = up;
        }
        if (is_drawn_kind(*meant) || meant->parent == nullptr) asked_.insert(meant);
    }

    void visit(const SvgContext& parent, const SvgNode& node, bool wanted) {
        wanted = wanted || asked_.contains(&node);
        if (is_locked(node)) return;
        if (!is_group(node)) {
            if (wanted && draws(parent, node)) chosen_.push_back(&node);
            return;
        }
        const SvgContext context = enter(reader_, parent, node);
        if (!context.style.displayed) return;
        if (wanted && !is_layer(node) && (has_rules(node) || is_free(parent, node))) {
            chosen_.push_back(&node);
            return;
        }
        for (const SvgNode* child = node.first_child; child != nullptr; child = child->next)
            if (!is_text(*child)) visit(context, *child, wanted);
    }

    /// Of one group alone its content is meant: the group with its transform and effects stays.
    void enter_single_group() {
        while (chosen_.size() == 1 && is_group(*chosen_.front()) && !has_rules(*chosen_.front())) {
            std::vector<const SvgNode*> content;
            for (const SvgNode* child = chosen_.front()->first_child; child != nullptr; child = child->next)
                if (!is_text(*child) && is_drawn_kind(*child)) content.push_back(child);
            chosen_ = std::move(content);
        }
    }

    /// Nothing below would be lost if the node were taken as a whole.
    bool is_free(const SvgContext& parent, const SvgNode& node) {
        if (!is_drawn_kind(node)) return !is_undrawn_content(node);
        if (is_locked(node)) return false;
        if (!is_group(node)) return draws(parent, node);
        if (const auto known = free_.find(&node); known != free_.end()) return known->second;
        const SvgContext context = enter(reader_, parent, node);
        bool all = context.style.displayed && !is_layer(node);
        for (const SvgNode* child = node.first_child; all && child != nullptr; child = child->next)
            all = is_text(*child) || is_free(context, *child);
        return free_[&node] = all;
    }

    /// Draws it to see, and takes it back.
    bool draws(const SvgContext& parent, const SvgNode& node) {
        const SvgMark mark = mark_of(reader_);
        const std::size_t drawn = reader_.drawn, kept_parts = reader_.kept_parts, kept_bytes = reader_.verbatim_bytes;
        draw_node(reader_, parent, node);
        const bool any = reader_.scene.elements.size() > mark.elements;
        take_back(reader_, mark.elements, mark.warnings);
        reader_.blended = mark.blended;
        reader_.drawn = drawn;
        reader_.kept_parts = kept_parts;
        reader_.verbatim_bytes = kept_bytes;
        return any;
    }

    SvgReader& reader_;
    std::unordered_set<const SvgNode*> asked_;
    std::unordered_map<const SvgNode*, bool> free_;
    std::vector<const SvgNode*> chosen_;
};

}  // namespace

SvgSelection select_elements(SvgReader& reader, const SvgContext& root, std::span<const std::string> ids) {
    return Selector(reader, ids).select(root);
}

}  // namespace rinceau
