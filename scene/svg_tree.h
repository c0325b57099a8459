#pragma once
// The XML tree of a drawing: elements and texts with resolved namespaces, found by id. Immutable once built.

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "scene/svg_source.h"

namespace rinceau {

enum class SvgNamespace : std::uint8_t { none, svg, xlink, xml, declaration, other };

struct SvgAttribute {
    std::string_view name;  ///< local name, without prefix
    std::string_view value;
    SvgNamespace space = SvgNamespace::none;
};

/// An element, or a piece of text (then `name` is empty).
struct SvgNode {
    std::string_view name;  ///< local name
    std::string_view text;
    std::string_view space_name;  ///< the namespace's own name (URI), for elements that are not SVG
    SvgNamespace space = SvgNamespace::none;
    int line = 0;
    int position = 1;  ///< among the elements of its parent
    std::vector<SvgAttribute> attributes;
    const SvgNode* parent = nullptr;
    const SvgNode* first_child = nullptr;
    const SvgNode* next = nullptr;              ///< sibling of any sort
    const SvgNode* previous_element = nullptr;
    const SvgNode* next_element = nullptr;
};

inline bool is_text(const SvgNode& node) { return node.name.empty(); }
inline bool is_svg(const SvgNode& node) { return node.space == SvgNamespace::svg; }

/// The value of an attribute without namespace; null if there is none.
const std::string_view* find_attribute(const SvgNode& node, std::string_view name);
/// `href`, else `xlink:href`, trimmed; empty if there is neither.
std::string_view href_of(const SvgNode& node);

class SvgTree {
  public:
    SvgTree();
    ~SvgTree();
    SvgTree(SvgTree&&) noexcept;
    SvgTree& operator=(SvgTree&&) noexcept;

    const SvgNode& root() const { return nodes_.front(); }
    /// The first element with this id; null if there is none.
    const SvgNode* find(std::string_view id) const;
    std::size_t size() const { return nodes_.size(); }

  private:
    friend class SvgTreeBuilder;
    struct Document;
    std::unique_ptr<Document> document_;  ///< owns what the views in the nodes look at
    std::deque<SvgNode> nodes_;
    std::unordered_map<std::string_view, const SvgNode*> ids_;
};

/// From clean XML text (svg_source.h). Elements without any namespace count as SVG if the root is an `svg` without one.
/// Throws InputError with line and column if the XML is broken or the root is not an `svg`, LimitError beyond
/// options.max_depth.
SvgTree parse_svg_tree(const std::string& text, const SvgSourceOptions& options);

}  // namespace rinceau
