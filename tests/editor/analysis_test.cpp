#include <algorithm>
#include <catch2/catch.hpp>

#include "editor/effects/read_document.h"
#include "editor/model/update.h"
#include "editor/model/wished_analysis.h"
#include "lsystem/numbers.h"

using namespace rinceau;

namespace {

const std::string path = RINCEAU_SOURCE_DIR "/samples/facade.svg";

/// The real analysis; with the options that a drawing is opened with it is made once for all tests.
std::shared_ptr<const Analysis> found_in(const Scene& drawing, const AnalyzeOptions& options) {
    const auto analysed = [&] { return std::make_shared<const Analysis>(analyze(drawing, options)); };
    if (!same_analysis(options, {})) return analysed();
    static const std::shared_ptr<const Analysis> as_opened = analysed();
    return as_opened;
}

/// A state, and what was asked of the world on the way to it.
struct Editing {
    EditorState state = initial_state();
    Requests requests;

    void act(const Action& action) {
        Update next = update(std::move(state), action);
        state = std::move(next.state);
        requests = std::move(next.requests);
    }
    template <class R>
    const R* request() const {
        const auto found = std::ranges::find_if(requests, [](const Request& r) { return std::holds_alternative<R>(r); });
        return found == requests.end() ? nullptr : &std::get<R>(*found);
    }
    std::uint64_t job() const { return state.analysis.job; }
    /// As the worker does it.
    void finish() { act(AnalysisAction{AnalysisDone{job(), found_in(*state.document.drawing, state.analysis.options)}}); }
    void draw() {
        if (const auto* asked = request<DerivePicture>())
            act(CanvasAction{
                PictureDerived{asked->revision, std::make_shared<const DerivedPicture>(derive_picture(asked->document))}});
    }
    bool was_told(const std::string& part) const {
        return std::ranges::any_of(state.messages,
                                   [&](const EditorMessage& m) { return m.text.find(part) != std::string::npos; });
    }
};

Editing opened() {
    Editing editing;
    editing.act(FileAction{OpenFile{path}});
    editing.act(FileAction{read_document(path)});
    return editing;
}

Editing analysed() {
    Editing editing = opened();
    editing.finish();
    editing.draw();
    return editing;
}

AnalyzeOptions nearer(double weight) { return {.weights = {.nearness = weight}}; }

std::string a_count(const EditorState& state) {
    for (const GrammarNumber& number : grammar_numbers(*state.document.grammar))
        if (number.kind == NumberKind::count) return number.name;
    return {};
}

}  // namespace

TEST_CASE("the first analysis of a drawing is no edit") {
    Editing editing = opened();
    REQUIRE(editing.state.analysis.running);
    editing.act(AnalysisAction{AnalysisProgress{editing.job(), "rules", 0.5}});
    CHECK(editing.state.analysis.stage == "rules");
    editing.finish();
    CHECK(editing.request<DerivePicture>() != nullptr);
    CHECK_FALSE(editing.state.analysis.running);
    CHECK(editing.state.document.report != nullptr);
    CHECK_FALSE(editing.state.document.grammar->productions.empty());
    CHECK(editing.state.history.past.empty());
    CHECK_FALSE(has_unsaved_changes(editing.state));
}

TEST_CASE("answers of an analysis that another took the place of are dropped") {
    Editing editing = opened();
    const auto old = editing.job();
    const auto found = found_in(*editing.state.document.drawing, {});
    SECTION("by another analysis") { editing.act(AnalysisAction{StartAnalysis{nearer(2)}}); }
    SECTION("by another document") {
        editing.act(FileAction{OpenFile{path}});
        editing.act(FileAction{read_document(path)});
    }
    SECTION("by none: it was stopped") {
        editing.act(AnalysisAction{CancelAnalysis{}});
        CHECK(editing.request<StopAnalysis>() != nullptr);
        CHECK_FALSE(editing.state.analysis.running);
    }
    const auto grammar = editing.state.document.grammar;
    const bool running = editing.state.analysis.running;
    editing.act(AnalysisAction{AnalysisProgress{old, "late", 1}});
    editing.act(AnalysisAction{AnalysisDone{old, found}});
    editing.act(AnalysisAction{AnalysisFailed{old, "late"}});
    CHECK(editing.state.document.grammar == grammar);
    CHECK(editing.state.analysis.running == running);
    CHECK(editing.state.analysis.stage != "late");
}

TEST_CASE("an analysis that fails leaves the document and says so") {
    Editing editing = analysed();
    const Document before = editing.state.document;
    editing.act(AnalysisAction{StartAnalysis{nearer(2)}});
    editing.act(AnalysisAction{AnalysisFailed{editing.job(), "the memory does not suffice"}});
    CHECK(same_document(editing.state.document, before));
    CHECK_FALSE(editing.state.analysis.running);
    CHECK(editing.was_told("the memory does not suffice"));
}

TEST_CASE("a slider is followed by previews, its end is one edit, and undo gives back the identical document") {
    Editing editing = analysed();
    const Document before = editing.state.document;
    const ViewTransform view = editing.state.canvas.view;
    editing.act(AnalysisAction{TryAnalysis{nearer(2)}});
    REQUIRE(editing.request<RunAnalysis>() != nullptr);
    editing.act(AnalysisAction{TryAnalysis{nearer(3)}});
    CHECK(wished_analysis(editing.state).weights.nearness == 3);
    editing.finish();
    CHECK(same_document(editing.state.document, before));
    while (editing.state.analysis.running) editing.finish();
    REQUIRE(editing.state.preview);
    CHECK(editing.state.preview->analysis.weights.nearness == 3);
    CHECK(editing.state.history.past.empty());
    editing.act(AnalysisAction{StartAnalysis{nearer(3)}});
    CHECK_FALSE(editing.state.analysis.running);
    CHECK(editing.state.history.past.size() == 1);
    CHECK(editing.state.document.analysis.weights.nearness == 3);
    CHECK(editing.state.canvas.view == view);
    editing.act(RulesAction{UndoEdit{}});
    CHECK(same_document(editing.state.document, before));
}

TEST_CASE("a slider that is let go before the answer comes is recorded when it comes") {
    Editing editing = analysed();
    editing.act(AnalysisAction{TryAnalysis{nearer(2)}});
    const auto job = editing.job();
    editing.act(AnalysisAction{StartAnalysis{nearer(2)}});
    CHECK(editing.job() == job);  // what runs is what is wished
    CHECK(editing.state.history.past.empty());
    editing.finish();
    CHECK(editing.state.history.past.size() == 1);
    CHECK_FALSE(editing.state.preview);
}

TEST_CASE("what is tried is dropped with its preview") {
    Editing editing = analysed();
    const Document before = editing.state.document;
    editing.act(AnalysisAction{TryAnalysis{nearer(2)}});
    editing.finish();
    REQUIRE(editing.state.preview);
    editing.act(AnalysisAction{TryAnalysis{nearer(3)}});
    editing.act(RulesAction{DropPreview{}});
    CHECK_FALSE(editing.state.preview);
    CHECK_FALSE(editing.state.analysis.running);
    CHECK(same_document(editing.state.document, before));
    CHECK(same_analysis(wished_analysis(editing.state), before.analysis));
}

TEST_CASE("what is found while something is dragged waits until it is let go") {
    Editing editing = analysed();
    editing.act(AnalysisAction{StartAnalysis{nearer(2)}});
    editing.act(RulesAction{SetNumber{a_count(editing.state), 7, true}});
    const auto preview = editing.state.preview->grammar;
    editing.finish();
    REQUIRE(editing.state.preview);
    CHECK(editing.state.preview->grammar == preview);
    CHECK(editing.state.document.analysis.weights.nearness == 1);
    editing.act(RulesAction{DropPreview{}});
    CHECK(editing.state.document.analysis.weights.nearness == 2);
}

TEST_CASE("edits that new rules replace are told of, and undo brings them back") {
    Editing editing = analysed();
    editing.act(RulesAction{SetNumber{a_count(editing.state), 7}});
    const Document edited = editing.state.document;
    REQUIRE(rules_were_edited(edited));
    editing.act(AnalysisAction{StartAnalysis{edited.analysis}});
    editing.finish();
    CHECK_FALSE(rules_were_edited(editing.state.document));
    CHECK(editing.was_told("Undo"));
    editing.act(RulesAction{UndoEdit{}});
    CHECK(same_document(editing.state.document, edited));
}

TEST_CASE("the same rules found again are no edit") {
    Editing editing = analysed();
    editing.act(AnalysisAction{StartAnalysis{editing.state.document.analysis}});
    editing.finish();
    CHECK(editing.state.history.past.empty());
    CHECK_FALSE(has_unsaved_changes(editing.state));
}

namespace {

void map_elements(Editing& editing) {
    const auto* asked = editing.request<MapElements>();
    REQUIRE(asked != nullptr);
    editing.act(AnalysisAction{
        ElementsMapped{std::make_shared<const ElementItems>(items_of_elements(asked->picture, *asked->drawing)), {}}});
}

Editing with_clusters() {
    Editing editing = analysed();
    editing.act(AnalysisAction{ShowClusters{true}});
    const TabulateClusters asked = *editing.request<TabulateClusters>();
    const PreparedDrawing prepared = prepare_drawing(*asked.drawing);
    const Instancing& instancing = prepared.readings.front().instancing;
    const std::vector<std::string> names(instancing.looks.size(), "look");
    editing.act(AnalysisAction{
        ClustersFound{asked.job, std::make_shared<const DrawingClusters>(DrawingClusters{
                                     asked.drawing, asked.options, cluster_table(instancing, names, prepared.diagonal)})}});
    REQUIRE(editing.state.clusters.found->table.rows.size() > 1);
    return editing;
}

}  // namespace

TEST_CASE("a cluster that is pointed at is lit on the canvas, element by element") {
    Editing editing = with_clusters();
    editing.act(AnalysisAction{HoverCluster{0}});
    CHECK_FALSE(editing.state.canvas.lit);
    map_elements(editing);
    REQUIRE(editing.state.canvas.lit);
    const auto& elements = editing.state.clusters.found->table.rows.front().elements;
    CHECK(static_cast<std::size_t>(std::ranges::count(*editing.state.canvas.lit, 1)) == elements.size());
    SECTION("and no longer when it is left") {
        editing.act(AnalysisAction{HoverCluster{-1}});
        CHECK_FALSE(editing.state.canvas.lit);
    }
    SECTION("and stays so when it is kept") {
        editing.act(AnalysisAction{KeepCluster{0}});
        editing.act(AnalysisAction{HoverCluster{-1}});
        CHECK(editing.state.canvas.lit);
        editing.act(AnalysisAction{KeepCluster{0}});
        CHECK_FALSE(editing.state.canvas.lit);
    }
    SECTION("and is forgotten with its drawing") {
        editing.act(FileAction{OpenFile{path}});
        editing.act(FileAction{read_document(path)});
        CHECK_FALSE(editing.state.canvas.lit);
        CHECK_FALSE(editing.state.clusters.found);
        CHECK(editing.request<TabulateClusters>() != nullptr);
    }
}

TEST_CASE("every element of a drawing has its item in the picture of its rules") {
    const Editing editing = analysed();
    const ElementItems items = items_of_elements(editing.state.picture, *editing.state.document.drawing);
    std::vector<std::int32_t> orders = items.order_of_element;
    std::ranges::sort(orders);
    std::vector<std::int32_t> all(editing.state.picture->items.size());
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<std::int32_t>(k);
    CHECK(orders == all);
    std::size_t by_terminal = 0;
    for (std::size_t t = 0; t < editing.state.picture->grammar->terminals.size(); ++t)
        by_terminal += elements_of_terminal(items, static_cast<int>(t)).size();
    CHECK(by_terminal == all.size());
}

TEST_CASE("terminals that are merged by hand become one, and undo parts them") {
    Editing editing = analysed();
    const Document before = editing.state.document;
    const auto terminals = before.grammar->terminals.size();
    REQUIRE(terminals >= 2);
    editing.act(AnalysisAction{ChooseTerminal{before.grammar->terminals[0].symbol}});
    editing.act(AnalysisAction{ChooseTerminal{before.grammar->terminals[1].symbol}});
    editing.act(AnalysisAction{MergeTerminals{}});
    map_elements(editing);
    REQUIRE(editing.state.analysis.running);
    REQUIRE(editing.state.analysis.options.grouping.size() == 1);
    editing.finish();
    CHECK(editing.state.document.grammar->terminals.size() == terminals - 1);
    editing.act(RulesAction{UndoEdit{}});
    CHECK(same_document(editing.state.document, before));
}
