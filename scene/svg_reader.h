#pragma once
// What the parts of the SVG reader share while they walk a tree: where the walk stands, and what it has found so far.

#include <map>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "scene/element.h"
#include "scene/svg_css.h"
#include "scene/svg_read.h"
#include "scene/svg_style.h"
#include "scene/svg_tree.h"

namespace rinceau {

/// Warnings by kind, each with a count and the first place; can be taken back to an earlier state when a part of the
/// drawing turns out to be kept verbatim as a whole.
class SvgWarningLog {
  public:
    using Mark = std::size_t;

    /// `kind` is a sentence with "{}" where the count goes, if it has one; the text must outlive the log.
    void add(std::string_view kind, const SvgNode& node) { entries_.push_back({kind, {}, node.line, nullptr}); }
    /// A value that is not understood: `kind` has "{value}" where the first such value goes. An element counts once.
    void add_value(std::string kind, std::string_view value, const SvgNode& node);
    Mark mark() const { return entries_.size(); }
    void take_back(Mark mark) { entries_.resize(mark); }
    /// One warning for each kind, in the order of first occurrence.
    std::vector<Warning> summary(const std::string& file_name) const;

  private:
    struct Entry {
        std::string_view kind;
        std::string value;
        int line = 0;
        const SvgNode* counts_once = nullptr;  ///< null = counts each time
    };
    std::vector<Entry> entries_;
    std::set<std::string> value_kinds_;
};

/// Where the walk stands: an element with all that holds for it, and the way it was reached (through `use` as well).
struct SvgContext {
    const SvgContext* parent = nullptr;
    const SvgNode* node = nullptr;
    SpecifiedStyle specified;
    SvgStyle style;
    Affine map;         ///< from the element's user space to SVG px of the outermost viewport (y down)
    UnitContext units;  ///< viewport and font size inside the element
    int depth = 1;
    /// Inside a marker: what fill and stroke of the marked shape came to, for context-fill and context-stroke.
    const Style* context_style = nullptr;
};

/// The definition of a gradient with everything that it takes over from the ones that it refers to.
struct SvgGradientDefinition {
    GradientKind kind = GradientKind::linear;
    GradientSpread spread = GradientSpread::pad;
    bool user_space = false;
    Affine transform;
    std::string_view x1, y1, x2, y2, cx, cy, r, fx, fy, fr;  ///< as written, empty = not given
    std::vector<GradientStop> stops;
};

/// A clip in scene space (svg_clip.cpp).
struct SvgClip;

struct SvgClipInPlace {
    Affine map;
    std::shared_ptr<const SvgClip> clip;
};

struct SvgReader {
    const SvgTree& tree;
    const SvgReadOptions& options;
    StyleSheet sheet;
    CssTree css;

    Scene scene;
    SvgWarningLog warnings;

    UnitContext root_units;          ///< inside the root element
    double tolerance = 1e-3;         ///< smaller differences do not show
    double pixel = 1;                ///< a px of the outermost viewport in the unit of the scene
    std::size_t drawn = 0;           ///< elements drawn so far, those taken back again included
    std::size_t verbatim_bytes = 0;  ///< text of kept parts so far, those taken back again included
    std::size_t kept_parts = 0;      ///< numbers the ids in kept parts
    std::size_t blended = 0;         ///< elements so far that blend with what is below them

    std::unordered_set<const SvgNode*> open;  ///< elements being drawn now, against references that lead back to them
    std::unordered_map<const SvgNode*, std::shared_ptr<const SvgGradientDefinition>> gradients;
    std::unordered_map<const SvgNode*, SvgClipInPlace> clips;  ///< the last use of each
};

/// At the start of a walk over the tree, which must outlive it as the options must.
SvgReader reader_of(const SvgTree& tree, const SvgReadOptions& options);

/// SVG px (y down) to scene space (y up).
constexpr Affine scene_from_svg{1, 0, 0, -1, 0, 0};
inline Affine scene_map(const SvgContext& context) { return scene_from_svg * context.map; }

/// Warns of a value that is not understood: "{} <element> elements have the attribute name="value", which is not understood;
/// instead". Empty values say nothing and are no faults.
void note_fault(SvgReader& reader, const SvgNode& node, std::string_view name, std::string_view value,
                std::string_view instead);

/// Marks an element as being drawn as long as it lives; `fresh` is false if it is being drawn already.
class SvgOpening {
  public:
    SvgOpening(SvgReader& reader, const SvgNode& node)
        : reader_(reader), node_(node), fresh(reader.open.insert(&node).second) {}
    ~SvgOpening() {
        if (fresh) reader_.open.erase(&node_);
    }
    SvgOpening(const SvgOpening&) = delete;
    SvgOpening& operator=(const SvgOpening&) = delete;

  private:
    SvgReader& reader_;
    const SvgNode& node_;

  public:
    const bool fresh;
};

SourcePlace place_of(const SvgReader& reader, const SvgNode& node);
/// "#id" to the element; null if there is none.
const SvgNode* find_reference(const SvgReader& reader, std::string_view reference);
SpecifiedStyle specified_style(SvgReader& reader, const SvgNode& node);

/// The context of a node below `parent`: style, transform of its own, depth. Throws LimitError beyond the depth limit.
SvgContext enter(SvgReader& reader, const SvgContext& parent, const SvgNode& node);

/// The contexts of a definition's ancestors as the tree has them (not as the walk went), the root first and the parent
/// last, without any transforms: what a definition inherits.
std::vector<std::unique_ptr<SvgContext>> ancestor_contexts(SvgReader& reader, const SvgNode& node);

/// Takes all elements from `first` on, and the warnings since `mark`, back.
void take_back(SvgReader& reader, std::size_t first, SvgWarningLog::Mark mark);

/// Adds a drawn element. Throws LimitError beyond max_elements.
void add_element(SvgReader& reader, Element element, const SvgNode& node);

}  // namespace rinceau
