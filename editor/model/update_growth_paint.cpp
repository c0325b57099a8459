// Growth by the mouse: the spray, strokes for the flow and the boundary, edges of the connectivity.

#include <cmath>
#include <utility>

#include "editor/model/update_growth.h"

namespace rinceau {
namespace {

bool draws(GrowthBrush brush) { return brush == GrowthBrush::flow || brush == GrowthBrush::boundary; }

void keep_guides(GrowthState& growth, GuideLines guides) {
    growth.guides = std::make_shared<const GuideLines>(std::move(guides));
}

void flip(Update& update, Point at, double reach) {
    GrowthState& growth = update.state.growth;
    const GrowthSource* source = current_source(update.state);
    if (source == nullptr || !source->exemplar) return;
    if (const auto edge = exemplar_edge_at(*source->exemplar, at, reach)) growth.flips.push_back(*edge);
}

void begin_spray(Update& update, Point at) {
    const double radius = spray_radius(update.state);
    if (radius <= 0) {
        const auto& source = update.state.growth.source;
        tell(update, MessageKind::mistake,
             source && !source->mistake.empty() ? source->mistake : "The elements are still being found: try again at once");
        return;
    }
    update.state.growth.sprayed = at;
    ask_for_growth(update, {SprayStep{at, radius, true}});
}

/// Steps short enough that the brush leaves no gap.
void spray_to(Update& update, Point to) {
    constexpr double step = 0.5;  // of the radius
    GrowthState& growth = update.state.growth;
    const double radius = spray_radius(update.state);
    if (radius <= 0) return;
    const Point from = *growth.sprayed;
    const int count = static_cast<int>(abs(to - from) / (step * radius));
    if (count == 0) return;
    std::vector<ArrangeStep> steps;
    for (int i = 1; i <= count; ++i) {
        const Point at = from + (step * radius * i / abs(to - from)) * (to - from);
        steps.push_back(SprayStep{at, radius, false});
        growth.sprayed = at;
    }
    ask_for_growth(update, std::move(steps));
}

/// A line that ends where it begins, nearly, is closed.
DrawnStroke closed_if_near(DrawnStroke stroke, double reach) {
    constexpr std::size_t least = 4;
    constexpr double near = 4;  // times the reach: a hand closes a line less well than it hits one
    if (stroke.size() >= least && abs(stroke.back() - stroke.front()) <= near * reach) stroke.push_back(stroke.front());
    return stroke;
}

void keep_stroke(Update& update, GrowthBrush brush, double reach) {
    GrowthState& growth = update.state.growth;
    DrawnStroke stroke = std::exchange(growth.stroke, {});
    if (stroke.size() < 2) return;
    GuideLines guides = *growth.guides;
    if (brush == GrowthBrush::boundary) {
        guides.boundary.push_back(closed_if_near(std::move(stroke), reach));
    } else {
        guides.flow.push_back(std::move(stroke));
        if (growth.settings.arrangement.turn != ElementTurn::along_flow) {
            growth.settings.arrangement.turn = ElementTurn::along_flow;
            tell(update, MessageKind::note,
                 "Elements follow the flow from now on: what grows anew is turned along the strokes");
        }
    }
    keep_guides(growth, std::move(guides));
}

}  // namespace

void perform_one(Update& update, const TakeBrush& action) {
    GrowthState& growth = update.state.growth;
    const GrowthBrush brush = growth.settings.brush == action.brush ? GrowthBrush::none : action.brush;
    perform_one(update, DropStroke{});
    growth.settings.brush = brush;
    if (brush == GrowthBrush::none) return;
    open_growth_panel(update.state, GrowthTab::arrangement);
    if (brush == GrowthBrush::flip) {
        growth.settings.edges = true;
        show_growth(update, false);
        return;
    }
    if (!growth.grown || growth.grown->kind != GrowthTab::arrangement) begin_blank(update);
    show_growth(update, true);
}

void perform_one(Update& update, const PressBrush& action) {
    const GrowthBrush brush = brush_on_canvas(update.state);
    if (brush == GrowthBrush::spray) begin_spray(update, action.at);
    if (brush == GrowthBrush::flip) flip(update, action.at, action.reach);
    if (draws(brush)) update.state.growth.stroke = {action.at};
}

void perform_one(Update& update, const DragBrush& action) {
    GrowthState& growth = update.state.growth;
    if (growth.sprayed) spray_to(update, action.to);
    if (!growth.stroke.empty() && abs(action.to - growth.stroke.back()) >= action.reach && action.to != growth.stroke.back())
        growth.stroke.push_back(action.to);
}

void perform_one(Update& update, const ReleaseBrush& action) {
    update.state.growth.sprayed.reset();
    keep_stroke(update, update.state.growth.settings.brush, action.reach);
}

void perform_one(Update& update, const DropStroke&) {
    update.state.growth.sprayed.reset();
    update.state.growth.stroke.clear();
}

void perform_one(Update& update, const EraseStrokes& action) {
    GrowthState& growth = update.state.growth;
    GuideLines guides = *growth.guides;
    std::vector<DrawnStroke>& lines = action.of == GrowthBrush::boundary ? guides.boundary : guides.flow;
    if (lines.empty()) return;
    lines.resize(action.all ? 0 : lines.size() - 1);
    keep_guides(growth, std::move(guides));
}

void perform_one(Update& update, const ForgetFlips&) { update.state.growth.flips.clear(); }

}  // namespace rinceau
