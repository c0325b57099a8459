#pragma once
// Writing a part of the tree as SVG text that stands for itself: definitions that it refers to, style resolved, ids renamed.

#include <string>
#include <vector>

#include "scene/svg_reader.h"

namespace rinceau {

/// What an element takes over from those around it, as declarations: the inherited properties specified on `context` and
/// its parents, the nearest last and alone. Font sizes are in px.
SpecifiedStyle inherited_declarations(const SvgContext& context);

class SvgFragmentWriter {
  public:
    SvgFragmentWriter(SvgReader& reader, std::string id_prefix) : reader_(reader), prefix_(std::move(id_prefix)) {}

    /// The node and all below it; `as_group`: a container that cannot stand alone (marker, symbol, root) as a `g`.
    std::string element_text(const SvgNode& node, bool as_group);
    /// "a:b;c:d" with references renamed, ready for a style attribute.
    std::string declarations_text(const SpecifiedStyle& style);
    /// Everything that the texts written so far refer to, that is not within `root`, and what that refers to, as elements
    /// for a `defs`.
    std::string definitions_text(const SvgNode& root);

  private:
    void write_element(const SvgNode& node, const SpecifiedStyle& inherited, bool as_group, bool inside_foreign, std::string& text);
    void write_attributes(const SvgNode& node, const SpecifiedStyle& inherited, bool as_group, std::string& text);
    void write_children(const SvgNode& node, bool inside_foreign, std::string& text);
    std::string renamed_references(std::string_view value);
    std::string renamed(std::string_view id) const;
    void refer_to(std::string_view id, bool by_use);

    struct Target {
        const SvgNode* node = nullptr;
        bool by_use = false;  ///< takes its style from where it is used
    };

    SvgReader& reader_;
    std::string prefix_;
    std::vector<Target> targets_;
};

}  // namespace rinceau
