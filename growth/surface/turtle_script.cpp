#include "growth/surface/turtle_script.h"

#include <string>

#include "scene/input_error.h"

namespace rinceau {
namespace {

class ScriptWriter {
  public:
    explicit ScriptWriter(long max_elements) : max_elements_(max_elements) {}

    void add(const TurtleEvent& event) {
        switch (event.kind) {
            case TurtleEventKind::turned:
                break;
            case TurtleEventKind::moved:
                add_move(event.pose.translation);
                break;
            case TurtleEventKind::placed:
                add_element(*event.placement);
                break;
            case TurtleEventKind::pushed:
            case TurtleEventKind::opened:
                open(event);
                break;
            case TurtleEventKind::popped:
                at_ = event.pose.translation;
                close(brackets_, event.kind);
                break;
            case TurtleEventKind::closed:
                close(symbols_, event.kind);
                break;
        }
    }

    TurtleScript take() { return std::move(script_); }

  private:
    struct Open {
        int deed = 0;
        std::size_t brackets = 0;  ///< that were open
        bool broken = false;       ///< one of these has ended
    };
    TurtleScript script_;
    long max_elements_;
    Point at_;
    std::vector<Open> brackets_, symbols_;

    int next_deed() const { return static_cast<int>(script_.deeds.size()); }

    void add_move(Point to) {
        if (to == at_) return;
        at_ = to;
        script_.deeds.push_back({TurtleEventKind::moved, to});
    }

    void add_element(const Placement& placement) {
        if (static_cast<long>(script_.elements.size()) >= max_elements_) {
            throw LimitError({}, "the drawing has more than " + std::to_string(max_elements_) +
                                     " elements; raise --max-shapes or derive fewer steps");
        }
        script_.deeds.push_back({TurtleEventKind::placed, at_, static_cast<int>(script_.elements.size())});
        script_.elements.push_back(placement);
    }

    void open(const TurtleEvent& event) {
        auto& stack = event.kind == TurtleEventKind::pushed ? brackets_ : symbols_;
        stack.push_back({next_deed(), brackets_.size(), false});
        script_.deeds.push_back({event.kind, at_});
    }

    void close(std::vector<Open>& stack, TurtleEventKind kind) {
        const Open group = stack.back();
        stack.pop_back();
        const bool nested_well = brackets_.size() + symbols_.size() < max_nested_groups;
        if (kind == TurtleEventKind::popped) {
            // symbols that began in the bracket and have not ended are no groups
            for (auto symbol = symbols_.rbegin(); symbol != symbols_.rend() && symbol->deed > group.deed; ++symbol)
                symbol->broken = true;
        }
        const bool whole = !group.broken && (kind == TurtleEventKind::popped || group.brackets == brackets_.size());
        if (whole && nested_well) script_.deeds[static_cast<std::size_t>(group.deed)].last = next_deed();
        script_.deeds.push_back({kind, at_});
    }
};

}  // namespace

TurtleScript turtle_script(const Grammar& grammar, const DeriveOptions& options, long max_elements,
                           const Progress& progress) {
    ScriptWriter writer(max_elements);
    InterpretOptions interpretation;
    interpretation.derive = options;
    interpretation.addresses = true;
    visit_turtle(
        grammar, interpretation, [&](const TurtleEvent& event) { writer.add(event); }, progress);
    return writer.take();
}

}  // namespace rinceau
