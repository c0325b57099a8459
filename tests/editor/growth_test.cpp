// Growth in the editor: what it does to the state and to the document; the work itself is tested with the library.

#include <algorithm>
#include <type_traits>

#include <catch2/catch.hpp>

#include "editor/effects/read_document.h"
#include "editor/model/arrange_order.h"
#include "editor/model/command.h"
#include "editor/model/fill_order.h"
#include "editor/model/growth_view.h"
#include "editor/model/update.h"
#include "editor_desk.h"
#include "lsystem/grammar_text.h"

using namespace rinceau;

namespace {

constexpr const char* dots = R"(lsystem 1
canvas -5 -55 70 60
axiom: Row(7)
Row(m) : m > 0 -> [Column(6)] -(90) f(10) +(90) Row(m-1)
Column(m) : m > 0 -> [Dot] f(10) Column(m-1)
style 1: fill #3050a0
terminal Dot: style 1; path "M-2 -2L2 -2L2 2L-2 2Z"
)";

/// A state, what it asked for, and answers by hand.
struct Desk {
    EditorState state = initial_state();
    Requests requests;

    /// An action, or one of growth's.
    template <class Done>
    void act(const Done& done) {
        Action action;
        if constexpr (std::is_constructible_v<GrowthAction, const Done&>)
            action = GrowthAction{done};
        else
            action = done;
        Update next = update(std::move(state), action);
        state = std::move(next.state);
        std::ranges::move(next.requests, std::back_inserter(requests));
    }
    /// The newest request of its kind; null if there is none.
    template <class Asked>
    const Asked* newest() const {
        for (std::size_t i = requests.size(); i-- > 0;)
            if (const auto* one = std::get_if<Asked>(&requests[i])) return one;
        return nullptr;
    }
    void command(const std::string& name) {
        CAPTURE(name);
        REQUIRE(find_command(name) != nullptr);
        REQUIRE(is_enabled(*find_command(name), state));
        act(find_command(name)->action(state));
    }
};

/// Four elements in a row, as a source would be read.
std::shared_ptr<const GrowthSource> row_source(const SourceQuestion& question) {
    FiguredDrawing drawing{.grammar = *question.grammar};
    drawing.figures.push_back({"Dot", {Placement{}}, {{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}}, 3});
    Exemplar exemplar;
    exemplar.mean_edge = 10;
    exemplar.originals = 4;
    exemplar.symbols = {{"Dot", 1, 0.01}};
    for (int i = 0; i < 4; ++i) {
        const Point at{10.0 * i, 0};
        drawing.instances.push_back({0, translate(at)});
        exemplar.elements.push_back({.position = at, .radius = 3});
        if (i > 0) exemplar.edges.push_back({i - 1, i});
    }
    return std::make_shared<const GrowthSource>(GrowthSource{.question = question,
                                                             .drawing = std::make_shared<const FiguredDrawing>(drawing),
                                                             .exemplar = std::make_shared<const Exemplar>(exemplar)});
}

std::shared_ptr<const GrownPattern> two_dots(const std::shared_ptr<const GrowthSource>& source) {
    GrownPattern pattern{.source = source};
    pattern.arrangement = std::make_shared<const ElementArrangement>();
    pattern.placed = {{0, translate({0, 0}), {}}, {0, translate({10, 0}), {}}};
    pattern.picture = picture_of(*source->drawing, pattern.placed, {{-5, -5}, {15, 5}}, nullptr);
    return std::make_shared<const GrownPattern>(pattern);
}

/// The panel is open and the source is read.
Desk ready_desk() {
    Desk desk;
    desk.state.document = with_grammar(empty_document(), parse_grammar(dots, "dots"));
    desk.act(OpenGrowth{GrowthTab::arrangement});
    REQUIRE(desk.newest<ReadSource>() != nullptr);
    const ReadSource asked = *desk.newest<ReadSource>();
    desk.act(SourceRead{asked.job, row_source(asked.question)});
    return desk;
}

Desk grown_desk() {
    Desk desk = ready_desk();
    desk.act(BeginGrowth{});
    REQUIRE(desk.newest<GrowArrangement>() != nullptr);
    const GrowArrangement asked = *desk.newest<GrowArrangement>();
    desk.act(PatternGrown{asked.job, two_dots(asked.order->source), true});
    return desk;
}

}  // namespace

TEST_CASE("the source of growth follows the document while its panel is open, and only then") {
    Desk desk;
    desk.state.document = with_grammar(empty_document(), parse_grammar(dots, "dots"));
    desk.act(ShellAction{ShowPanel{EditorPanel::tools}});
    CHECK(desk.newest<ReadSource>() == nullptr);
    desk.act(ShellAction{ShowPanel{EditorPanel::growth}});
    REQUIRE(desk.newest<ReadSource>() != nullptr);
    const ReadSource first = *desk.newest<ReadSource>();
    CHECK(first.question.grammar == desk.state.document.resolved);
    CHECK(is_busy(desk.state));
    desk.requests.clear();
    desk.act(ShellAction{DismissMessages{}});
    CHECK(desk.newest<ReadSource>() == nullptr);  // it was asked for already
    desk.act(RulesAction{SetNumber{"Row.count", 5}});
    REQUIRE(desk.newest<ReadSource>() != nullptr);
    CHECK(desk.newest<ReadSource>()->question.grammar == desk.state.document.resolved);
    desk.act(SourceRead{first.job, row_source(first.question)});
    CHECK(current_source(desk.state) == nullptr);  // that was of the document before
    desk.act(SourceRead{desk.newest<ReadSource>()->job, row_source(desk.newest<ReadSource>()->question)});
    CHECK(current_source(desk.state) != nullptr);
    CHECK_FALSE(desk.state.growth.asked);
}

TEST_CASE("growth is a preview: the document changes when it is used, once, and Undo brings it back") {
    Desk desk = grown_desk();
    const Document before = desk.state.document;
    CHECK(shows_grown(desk.state));
    CHECK(canvas_picture(desk.state)->items.size() == 2);
    CHECK(same_document(desk.state.document, before));
    CHECK(desk.state.history.past.empty());
    desk.command("growth.use");
    REQUIRE(desk.newest<MakeGrownDocument>() != nullptr);
    const MakeGrownDocument asked = *desk.newest<MakeGrownDocument>();
    desk.act(GrownDocumentMade{asked.job, before.grammar, grown_document(asked.document, *asked.pattern)});
    CHECK(desk.state.history.past.size() == 1);
    CHECK_FALSE(shows_grown(desk.state));
    const DerivedPicture used = derive_picture(desk.state.document);
    REQUIRE(used.items.size() == 2);
    CHECK(abs(apply(used.items[0].pose, {}) - Point{0, 0}) < 1e-9);
    CHECK(abs(apply(used.items[1].pose, {}) - Point{10, 0}) < 1e-9);
    desk.act(Action{RulesAction{UndoEdit{}}});
    CHECK(same_document(desk.state.document, before));
    desk.command("growth.bring_back");
    CHECK(shows_grown(desk.state));
}

TEST_CASE("what has grown is not used for a document that was edited meanwhile") {
    Desk desk = grown_desk();
    desk.command("growth.use");
    const MakeGrownDocument asked = *desk.newest<MakeGrownDocument>();
    desk.act(Action{RulesAction{SetNumber{"Row.count", 5}}});
    const auto edited = desk.state.document.grammar;
    desk.act(GrownDocumentMade{asked.job, asked.document.grammar, grown_document(asked.document, *asked.pattern)});
    CHECK(desk.state.document.grammar == edited);
    CHECK(desk.state.messages.back().kind == MessageKind::warning);
    CHECK(has_grown(desk.state));
}

TEST_CASE("steps of the spray wait for those before them, and none is lost") {
    Desk desk = ready_desk();
    desk.act(TakeBrush{GrowthBrush::spray});
    CHECK(shows_grown(desk.state));  // a blank canvas
    const double radius = spray_radius(desk.state);
    CHECK(radius == Approx(30));
    desk.act(PressBrush{{0, 0}, 1});
    const GrowArrangement first = *desk.newest<GrowArrangement>();
    REQUIRE(first.order->steps.size() == 1);
    CHECK(std::get<SprayStep>(first.order->steps[0]).plants);
    desk.requests.clear();
    desk.act(DragBrush{{4 * radius, 0}, 1});
    desk.act(DragBrush{{4 * radius, 2 * radius}, 1});
    desk.act(ReleaseBrush{1});
    CHECK(desk.newest<GrowArrangement>() == nullptr);  // the first one runs
    desk.act(PatternGrown{first.job, two_dots(first.order->source), true});
    REQUIRE(desk.newest<GrowArrangement>() != nullptr);
    const std::vector<ArrangeStep> steps = desk.newest<GrowArrangement>()->order->steps;
    REQUIRE(steps.size() == 12);
    Point last{0, 0};
    for (const ArrangeStep& step : steps) {
        const SprayStep& spray = std::get<SprayStep>(step);
        CHECK_FALSE(spray.plants);
        CHECK(abs(spray.center - last) <= 0.5 * radius + 1e-9);
        last = spray.center;
    }
    CHECK(abs(last - Point{4 * radius, 2 * radius}) < 1e-9);
    CHECK(desk.newest<GrowArrangement>()->order->from == desk.state.growth.grown);
}

TEST_CASE("strokes are drawn by dragging, closed where they end near their begin, and erased again") {
    Desk desk = ready_desk();
    desk.act(TakeBrush{GrowthBrush::boundary});
    desk.act(PressBrush{{0, 0}, 1});
    for (const Point to : {Point{50, 0}, Point{50, 50}, Point{50.2, 50}, Point{0, 50}, Point{0, 2}})
        desk.act(DragBrush{to, 1});
    desk.act(ReleaseBrush{1});
    REQUIRE(desk.state.growth.guides->boundary.size() == 1);
    const DrawnStroke& ring = desk.state.growth.guides->boundary[0];
    CHECK(ring.size() == 6);  // the step shorter than the reach is left out, the end is the begin
    CHECK(ring.front() == ring.back());
    desk.act(TakeBrush{GrowthBrush::flow});
    desk.act(PressBrush{{0, 0}, 1});
    desk.act(DragBrush{{50, 0}, 1});
    desk.act(DropStroke{});
    desk.act(ReleaseBrush{1});
    CHECK(desk.state.growth.guides->flow.empty());
    CHECK(desk.state.growth.settings.arrangement.turn == ElementTurn::as_drawn);
    desk.act(PressBrush{{0, 0}, 1});
    desk.act(DragBrush{{50, 0}, 1});
    desk.act(ReleaseBrush{1});
    CHECK(desk.state.growth.guides->flow == std::vector<DrawnStroke>{{{0, 0}, {50, 0}}});
    CHECK(desk.state.growth.settings.arrangement.turn == ElementTurn::along_flow);
    desk.command("growth.erase_boundary");
    CHECK(desk.state.growth.guides->boundary.empty());
    CHECK(desk.state.growth.guides->flow.size() == 1);
}

TEST_CASE("a click on an edge asks for it to be flipped, and what cannot be flipped is told and forgotten") {
    Desk desk = ready_desk();
    desk.act(TakeBrush{GrowthBrush::flip});
    CHECK_FALSE(shows_grown(desk.state));
    desk.requests.clear();
    desk.act(PressBrush{{15, 3}, 1});
    CHECK(desk.newest<ReadSource>() == nullptr);  // beside all edges
    desk.act(PressBrush{{15, 0.5}, 1});
    REQUIRE(desk.newest<ReadSource>() != nullptr);
    const ReadSource asked = *desk.newest<ReadSource>();
    CHECK(asked.question.flips == std::vector<std::pair<int, int>>{{1, 2}});
    GrowthSource refused = *row_source(asked.question);
    refused.exemplar.reset();
    refused.mistake = "no quadrilateral";
    desk.act(SourceRead{asked.job, std::make_shared<const GrowthSource>(refused)});
    CHECK(desk.state.growth.flips.empty());
    CHECK(desk.state.messages.back().text.find("no quadrilateral") != std::string::npos);
    CHECK(desk.newest<ReadSource>()->question.flips.empty());
}

TEST_CASE("Esc stops what grows, keeps what stands, then puts the brush away, then clears") {
    Desk desk = ready_desk();
    desk.act(TakeBrush{GrowthBrush::spray});
    desk.act(PressBrush{{0, 0}, 1});
    const GrowArrangement asked = *desk.newest<GrowArrangement>();
    desk.command("select.none");
    REQUIRE(desk.newest<EndGrowth>() != nullptr);
    CHECK(desk.newest<EndGrowth>()->keep);
    desk.act(PatternGrown{asked.job, two_dots(asked.order->source), true});
    CHECK(has_grown(desk.state));
    CHECK(desk.state.growth.work == GrowthWork::none);
    desk.command("select.none");
    CHECK(brush_on_canvas(desk.state) == GrowthBrush::none);
    CHECK(shows_grown(desk.state));
    desk.command("select.none");
    CHECK_FALSE(shows_grown(desk.state));
    CHECK_FALSE(has_grown(desk.state));
    desk.command("growth.bring_back");
    CHECK(has_grown(desk.state));
}

TEST_CASE("what was dropped brings nothing any more, and another document begins without growth") {
    Desk desk = ready_desk();
    desk.act(BeginGrowth{});
    const GrowArrangement asked = *desk.newest<GrowArrangement>();
    desk.act(DropGrowth{});
    CHECK_FALSE(desk.newest<EndGrowth>()->keep);
    desk.act(PatternGrown{asked.job, two_dots(asked.order->source), true});
    CHECK_FALSE(has_grown(desk.state));
    desk = grown_desk();
    desk.state.file.saved = desk.state.document;
    desk.act(Action{FileAction{NewDocument{}}});
    CHECK_FALSE(has_grown(desk.state));
    CHECK_FALSE(shows_grown(desk.state));
}

TEST_CASE("an aggregate waits for the shapes, shows what is placed, and failures are told") {
    Desk desk;
    desk.state.document = with_grammar(empty_document(), parse_grammar(dots, "dots"));
    desk.command("growth.fill");
    CHECK(growth_is_open(desk.state));
    CHECK(desk.newest<FillPattern>() == nullptr);
    const ReadSource source = *desk.newest<ReadSource>();
    desk.act(SourceRead{source.job, row_source(source.question)});
    REQUIRE(desk.newest<FillPattern>() != nullptr);
    const FillPattern asked = *desk.newest<FillPattern>();
    desk.act(PatternGrown{asked.job, two_dots(asked.order->source), false});
    CHECK(has_grown(desk.state));
    CHECK(desk.state.growth.work == GrowthWork::filling);
    desk.act(GrowthFailed{asked.job, "no room"});
    CHECK(desk.state.growth.work == GrowthWork::none);
    CHECK(desk.state.messages.back().text == "no room");
}

TEST_CASE("a grid grows on by the real workers, is used, and the aggregate of its dots fills a region without overlap") {
    EditorDesk desk;
    desk.act(Action{FileAction{NewDocument{}}});
    desk.changeable().document = with_grammar(empty_document(), parse_grammar(dots, "dots"));
    GrowthSettings settings;
    settings.arrangement.count = 150;
    settings.aggregate.canvas = 1;
    desk.act(GrowthAction{SetGrowth{settings}});
    desk.act(GrowthAction{BeginGrowth{}});
    desk.until([&] { return !is_busy(desk.state()); });
    const auto grown = desk.state().growth.grown;
    REQUIRE(grown);
    REQUIRE(grown->arrangement);
    CHECK(grown->placed.size() == 150);
    for (const auto& [a, b] : grown->edges) CHECK(abs(b - a) == Approx(10).epsilon(0.01));
    desk.act(GrowthAction{UseGrowth{}});
    desk.until([&] { return !is_busy(desk.state()); });
    CHECK(desk.state().history.past.size() == 1);
    REQUIRE(desk.state().picture);
    CHECK(desk.state().picture->items.size() == 150);
    desk.act(Action{RulesAction{UndoEdit{}}});
    desk.act(GrowthAction{FillAggregate{}});
    desk.until([&] { return !is_busy(desk.state()); });
    const auto filled = desk.state().growth.grown;
    REQUIRE(filled);
    CHECK(filled->kind == GrowthTab::aggregate);
    CHECK(filled->placed.size() > 80);  // squares of 4 in 70 x 60
    for (std::size_t i = 0; i < filled->placed.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            CHECK(abs(filled->placed[i].pose.translation - filled->placed[k].pose.translation) >= 4);
}

TEST_CASE("the same strokes and steps give the same arrangement, however they are cut into orders") {
    const SourceQuestion question{with_grammar(empty_document(), parse_grammar(dots, "dots")).resolved, {}, true, {}};
    const auto source = std::make_shared<const GrowthSource>(growth_source(question, nullptr));
    REQUIRE(source->exemplar);
    ArrangeOrder whole{.source = source, .guides = std::make_shared<const GuideLines>(), .canvas = {{0, 0}, {100, 100}}};
    for (int i = 0; i < 6; ++i) whole.steps.push_back(SprayStep{{12.0 * i, 3.0 * i}, 25, i == 0});
    const GrownPattern at_once = arranged(whole, surroundings_of(whole));
    GrownPattern stepwise;
    for (const ArrangeStep& step : whole.steps) {
        ArrangeOrder part = whole;
        part.steps = {step};
        if (stepwise.arrangement) part.from = std::make_shared<const GrownPattern>(stepwise);
        stepwise = arranged(part, surroundings_of(part));
    }
    REQUIRE(at_once.placed.size() > 20);
    REQUIRE(stepwise.placed.size() == at_once.placed.size());
    for (std::size_t i = 0; i < at_once.placed.size(); ++i) CHECK(stepwise.placed[i].pose == at_once.placed[i].pose);
}
