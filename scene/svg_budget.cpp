#include "scene/svg_budget.h"

#include "scene/svg_outline.h"

namespace rinceau {
namespace {

/// Counts each part of the tree once, however often it is used.
class ExpansionCounter {
  public:
    explicit ExpansionCounter(const SvgReader& reader) : reader_(reader) {}

    double count(const SvgNode& node, int depth) {
        if (is_text(node)) return 0;
        const auto [known, fresh] = counts_.emplace(&node, 0.0);
        // A reference back to an element that is being counted draws nothing.
        if (!fresh) return known->second;
        if (depth > reader_.options.max_depth)
            throw LimitError(place_of(reader_, node), "elements and references are nested more than " +
                                                          std::to_string(reader_.options.max_depth) +
                                                          " deep; flatten the drawing or raise the depth limit");
        double sum = is_shape(node.name) || node.name == "text" || node.name == "image" ? 1 : 0;
        for (const SvgNode* child = node.first_child; child != nullptr; child = child->next)
            if (!draws_through_others(*child)) sum += count(*child, depth + 1);
        if (node.name == "use")
            if (const SvgNode* target = find_reference(reader_, href_of(node))) sum += count(*target, depth + 1);
        check(sum, node);
        counts_[&node] = sum;
        return sum;
    }

  private:
    static bool draws_through_others(const SvgNode& node) {
        return node.name == "defs" || node.name == "symbol" || node.name == "clipPath" || node.name == "mask" ||
               node.name == "pattern" || node.name == "marker";
    }

    void check(double sum, const SvgNode& node) const {
        if (sum > static_cast<double>(reader_.options.max_elements))
            throw LimitError(place_of(reader_, node), "the drawing has more than " + std::to_string(reader_.options.max_elements) +
                                                          " elements once every use is expanded; raise the limit or simplify the drawing");
    }

    const SvgReader& reader_;
    std::unordered_map<const SvgNode*, double> counts_;
};

}  // namespace

std::size_t expanded_elements(const SvgReader& reader) {
    return static_cast<std::size_t>(ExpansionCounter(reader).count(reader.tree.root(), 1));
}

}  // namespace rinceau
