// A project holds all of a document.

#include "editor/model/project.h"

#include <cmath>

#include "editor/effects/read_document.h"
#include "lsystem/grammar_text.h"
#include "scene/svg_write.h"
#include "tests/editor/editor_desk.h"

using namespace rinceau;

namespace {

Document with_everything(const std::string& sample) {
    Document document = read_document(sample_path(sample)).document;
    document.analysis.tolerance = 0.1 + 0.2;
    document.analysis.weights.nearness = 1.0 / 3;
    document.analysis.objective = Objective::paper;
    document.analysis.symmetrize = true;
    document.analysis.similarity.mirrored_copies = false;
    document.derive.depth = 7;
    document.derive.seed = 0xFFFFFFFFFFFFFFFFU;
    document.locked = {"Row.count", "style1.opacity"};
    return document;
}

}  // namespace

TEST_CASE("a project read again is the document that was written") {
    for (const char* sample : {"facade.svg", "mandala.svg", "vine.lsys", "meadow.lsys"}) {
        INFO(sample);
        const Document document = with_everything(sample);
        const ViewTransform view{{1.0 / 3, -2e-7}, 1e5 / 7, {100, 100}};
        const std::string text = to_json(Project{document, view, {}});
        const Project read = parse_project(text, RINCEAU_SOURCE_DIR "/samples/x.rinceau");
        CHECK(to_text(*read.document.grammar) == to_text(*document.grammar));
        CHECK(to_text(*read.document.resolved) == to_text(*document.resolved));
        CHECK(same_analysis(read.document.analysis, document.analysis));
        CHECK(read.document.derive.depth == document.derive.depth);
        CHECK(read.document.derive.seed == document.derive.seed);
        CHECK(read.document.locked == document.locked);
        CHECK(bool(read.document.used) == bool(document.used));
        REQUIRE(read.view);
        CHECK(read.view->center == view.center);
        CHECK(read.view->zoom == view.zoom);
        REQUIRE(bool(read.document.drawing) == bool(document.drawing));
        if (document.drawing) CHECK(write_svg(*read.document.drawing) == write_svg(*document.drawing));
        CHECK(to_json(Project{read.document, view, {}}) == text);
    }
}

TEST_CASE("a project that uses other files holds them: it opens where they are not") {
    const TestFolder folder;
    EditorDesk desk;
    desk.open(sample_path("meadow.lsys"));
    desk.act(FileAction{SaveFileAs{folder / "meadow.rinceau"}});
    desk.until([&] { return !is_busy(desk.state()); });
    CHECK_FALSE(desk.was_told("uses flower.lsys"));
    EditorDesk other;
    other.open(folder / "meadow.rinceau");
    CHECK(to_text(*other.state().document.resolved) == to_text(*desk.state().document.resolved));
    // A grammar alone does not; that is said.
    other.act(FileAction{SaveFileAs{folder / "meadow.lsys"}});
    other.until([&] { return !is_busy(other.state()); });
    CHECK(other.was_told("uses flower.lsys, which is not beside it"));
}

TEST_CASE("a copy for emergencies of a file from before 1970 can be read") {
    const ProjectOrigin origin{"/old.lsys", FileStamp{.modified = -86'400'000'000'000, .bytes = 5, .node = 7}};
    const Project read = parse_project(to_json(Project{empty_document(), {}, origin}), "x.rinceau");
    REQUIRE(read.origin);
    CHECK(read.origin->stamp == origin.stamp);
}

TEST_CASE("mistakes in a project are named with their place") {
    const std::string good = to_json(Project{with_everything("facade.svg"), {}, {}});
    const auto message = [&](const std::string& part, const std::string& instead) {
        std::string text = good;
        const std::size_t at = text.find(part);
        REQUIRE(at != std::string::npos);
        text.replace(at, part.size(), instead);
        try {
            parse_project(text, "x.rinceau");
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("nothing is wrong");
    };
    using Catch::Contains;
    CHECK_THAT(message("\"paper\"", "\"paint\""), Contains("analysis.objective: expected \"bits\" or \"paper\""));
    CHECK_THAT(message("\"depth\": 7", "\"depth\": 7.5"), Contains("derive.depth: expected a whole number"));
    CHECK_THAT(message("\"locked\"", "\"looked\""), Contains("found 'looked'"));
    CHECK_THAT(message("18446744073709551615", "99999999999999999999"), Contains("derive.seed: expected a whole number"));
    CHECK_THAT(message("lsystem 1\\n", "lsystem 1\\n)"), Contains("x.rinceau: grammar, line 2, column 1: expected"));
    CHECK_THAT(message("<svg", "<sgv"), Contains("x.rinceau (drawing)"));
    CHECK_THAT(message("\"version\": 1", "\"version\": 1]"), Contains("x.rinceau:3:"));
}
