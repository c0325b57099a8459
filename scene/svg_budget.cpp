#include "scene/svg_budget.h"

#include <algorithm>

#include "scene/svg_outline.h"

namespace rinceau {
namespace {

struct Expansion {
    double drawn = 0;    ///< shapes, texts and images
    double visited = 0;  ///< elements of any kind
    int depth = 0;       ///< levels of elements and references
};

/// Counts each part of the tree once, however often it is used.
class ExpansionCounter {
  public:
    explicit ExpansionCounter(const SvgReader& reader) : reader_(reader) {}

    /// `level` bounds the recursion itself, which can be no deeper than the drawing.
    Expansion count(const SvgNode& node, int level) {
        if (is_text(node)) return {};
        const auto [known, fresh] = counts_.emplace(&node, Expansion{});
        // A reference back to an element that is being counted draws nothing.
        if (!fresh) return known->second;
        check_depth(level, node);
        Expansion sum{is_shape(node.name) || node.name == "text" || node.name == "image" ? 1.0 : 0.0, 1, 0};
        for (const SvgNode* child = node.first_child; child != nullptr; child = child->next)
            if (!draws_through_others(*child)) add(sum, count(*child, level + 1));
        if (node.name == "use")
            if (const SvgNode* target = find_reference(reader_, href_of(node))) add(sum, count(*target, level + 1));
        ++sum.depth;
        check_depth(sum.depth, node);
        check_count(std::max(sum.drawn, sum.visited / visits_an_element), node);
        counts_[&node] = sum;
        return sum;
    }

  private:
    // Groups and references around each drawn element, far more than any real drawing has.
    static constexpr double visits_an_element = 4;

    static void add(Expansion& sum, const Expansion& part) {
        sum.drawn += part.drawn;
        sum.visited += part.visited;
        sum.depth = std::max(sum.depth, part.depth);
    }

    static bool draws_through_others(const SvgNode& node) {
        return node.name == "defs" || node.name == "symbol" || node.name == "clipPath" || node.name == "mask" ||
               node.name == "pattern" || node.name == "marker";
    }

    void check_depth(int depth, const SvgNode& node) const {
        if (depth > reader_.options.max_depth)
            throw LimitError(place_of(reader_, node), "elements and references are nested more than " +
                                                          std::to_string(reader_.options.max_depth) +
                                                          " deep; flatten the drawing or raise the depth limit");
    }

    void check_count(double count, const SvgNode& node) const {
        if (count > static_cast<double>(reader_.options.max_elements))
            throw LimitError(place_of(reader_, node),
                             "the drawing has more than " + std::to_string(reader_.options.max_elements) +
                                 " elements once every use is expanded; raise the limit or simplify the drawing");
    }

    const SvgReader& reader_;
    std::unordered_map<const SvgNode*, Expansion> counts_;
};

}  // namespace

std::size_t expanded_elements(const SvgReader& reader) {
    return static_cast<std::size_t>(ExpansionCounter(reader).count(reader.tree.root(), 1).drawn);
}

}  // namespace rinceau
