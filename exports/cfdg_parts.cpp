#include "exports/cfdg_parts.h"

#include <algorithm>

#include "exports/number.h"
#include "geometry/angle.h"

namespace rinceau {

namespace {

class PartsWriter {
  public:
    PartsWriter(const Grammar& grammar, const DerivationGraph& graph, NoteList& notes)
        : grammar_(grammar), graph_(graph), notes_(notes), names_(cfdg_words()) {}

    std::string write() {
        const std::string start = names_.take("Picture");
        for (const GraphLook& look : graph_.looks) name_look(look);
        for (const GraphPart& part : graph_.parts) part_names_.push_back(part.symbol.empty() ? start : names_.take(part.symbol));
        std::string text = cfdg_head(grammar_, start, 0);
        for (std::size_t i = graph_.parts.size(); i-- > 0;) text += shape(i) + '\n';
        return text + paths_;
    }

  private:
    const Grammar& grammar_;
    const DerivationGraph& graph_;
    NoteList& notes_;
    UniqueNames names_;
    std::vector<std::string> look_names_;  ///< empty = nothing is drawn
    std::vector<std::string> part_names_;
    std::string paths_;

    void name_look(const GraphLook& look) {
        const Terminal& terminal = grammar_.terminals[static_cast<std::size_t>(look.terminal)];
        const Style style = look_style(grammar_, look);
        note_losses(terminal, style, notes_);
        look_names_.emplace_back();
        if (!cfdg_draws(terminal, style)) return;
        look_names_.back() = names_.take(terminal.symbol);
        paths_ += cfdg_path(look_names_.back(), terminal, style) + '\n';
    }

    /// Paint order is kept by heights: what is drawn is counted, and layers are higher than any count.
    std::string shape(std::size_t index) const {
        const GraphPart& part = graph_.parts[index];
        std::string text = "shape " + part_names_[index] + " {\n";
        const double layer = static_cast<double>(graph_.parts.back().placements);
        double below = 0;
        for (const PartItem& item : part.items) {
            const auto number = static_cast<std::size_t>(item.index);
            const std::string& name = item.is_look ? look_names_[number] : part_names_[number];
            if (!name.empty()) text += "  " + name + placing(item.pose, below + layer * item.layer) + '\n';
            below += item.is_look ? 1 : static_cast<double>(graph_.parts[number].placements);
        }
        return text + "}\n";
    }

    static std::string placing(const Similarity& pose, double height) {
        std::string text;
        const auto append = [&](const std::string& name, double value) {
            text += (text.empty() ? "" : " ") + name + ' ' + number_of(value);
        };
        if (pose.translation.x != 0) append("x", pose.translation.x);
        if (pose.translation.y != 0) append("y", pose.translation.y);
        // a mirror image about the x axis, then turned
        if (const double turn = arg(pose.linear); turn != 0) append("r", degrees(turn));
        if (const double scale = scale_of(pose); scale != 1) append("s", scale);
        if (pose.mirrored) append("flip", 0);
        if (height != 0) append("z", height);
        return text.empty() ? " []" : " [[ " + text + " ]]";
    }
};

}  // namespace

std::string cfdg_parts(const Grammar& grammar, const DerivationGraph& graph, NoteList& notes) {
    return PartsWriter(grammar, graph, notes).write();
}

}  // namespace rinceau
