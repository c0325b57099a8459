#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include <catch2/catch.hpp>

#include "program.h"

using namespace rinceau::test;
namespace fs = std::filesystem;

namespace {

const std::string line_drawing = R"(<svg xmlns="http://www.w3.org/2000/svg" width="90" height="20">
<rect x="0" width="10" height="20"/><rect x="20" width="10" height="20"/><rect x="40" width="10" height="20"/>
<rect x="60" width="10" height="20"/><rect x="80" width="10" height="20"/></svg>)";

fs::perms permissions(const std::string& name) { return fs::status(name).permissions(); }

}  // namespace

TEST_CASE("A dash reads standard input, and what has no output name goes to standard output") {
    const ScratchFolder scratch;
    const ProgramRun normal = run_rinceau({"normalize", "-"}, {.input = line_drawing, .folder = scratch.path()});
    CHECK(normal.status == 0);
    CHECK(normal.out.find("<svg") != std::string::npos);

    const std::string rules = read_file(sample("rosette.lsys"));
    const ProgramRun piped = run_rinceau({"render", "-"}, {.input = rules, .folder = scratch.path()});
    const ProgramRun named = run_rinceau({"render", sample("rosette.lsys"), "-o", "-"}, {.folder = scratch.path()});
    CHECK(piped.status == 0);
    CHECK(piped.out == named.out);
    CHECK(run_rinceau({"check", "-"}, {.input = rules}).status == 0);
    CHECK(run_rinceau({"derive", "-"}, {.input = rules}).out == run_rinceau({"derive", sample("rosette.lsys")}).out);
    CHECK(scratch.names().empty());
}

TEST_CASE("The ending of the name chooses the format") {
    const ScratchFolder scratch;
    for (const auto& [ending, start] :
         {std::pair<std::string, std::string>{"svg", "<?xml"}, {"png", "\x89PNG\r\n"}, {"PDF", "%PDF-"}}) {
        const std::string name = scratch.file("picture." + ending);
        CHECK(run_rinceau({"render", sample("rosette.lsys"), "-o", name}).status == 0);
        const std::string bytes = read_file(name);
        CHECK((bytes.starts_with(start) || bytes.starts_with("<svg")));
    }
}

TEST_CASE("The transformation spaces come as a table and as plots") {
    const ScratchFolder scratch;
    const std::string table = scratch.file("spaces.csv");
    const std::string plots = scratch.file("spaces.svg");
    REQUIRE(run_rinceau({"analyze", sample("tiles.svg"), "--spaces", table}).status == 0);
    REQUIRE(run_rinceau({"analyze", sample("tiles.svg"), "--spaces", plots}).status == 0);
    CHECK(read_file(table).starts_with("from,to,from_element,to_element,alpha,d,s,beta,mirrored,cluster\n"));
    CHECK(run_rinceau({"normalize", plots, "-o", scratch.file("again.svg")}).status == 0);
}

TEST_CASE("An output takes the place of the old file as a whole, keeps its permissions, and leaves nothing beside it") {
    const ScratchFolder scratch;
    const std::string name = scratch.file("a picture.svg");
    write_file(name, std::string(1 << 20, 'x'));
    fs::permissions(name, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
    const fs::perms before = permissions(name);
    REQUIRE(run_rinceau({"render", sample("rosette.lsys"), "-o", name}).status == 0);
    CHECK(read_file(name) == run_rinceau({"render", sample("rosette.lsys")}).out);
    CHECK(permissions(name) == before);
    CHECK(scratch.names() == std::vector<std::string>{"a picture.svg"});
}

TEST_CASE("An output that is a symbolic link stays one") {
    const ScratchFolder scratch;
    fs::create_directory(scratch.path() / "real");
    write_file(scratch.path() / "real" / "picture.svg", "old");
    fs::create_symlink(scratch.path() / "real" / "picture.svg", scratch.path() / "link.svg");
    REQUIRE(run_rinceau({"render", sample("rosette.lsys"), "-o", scratch.file("link.svg")}).status == 0);
    CHECK(fs::is_symlink(scratch.path() / "link.svg"));
    CHECK(read_file(scratch.path() / "real" / "picture.svg").find("<svg") != std::string::npos);
}

TEST_CASE("An output by a link that leads to no file yet makes that file, and the link stays one") {
    const ScratchFolder scratch;
    fs::create_directory(scratch.path() / "real");
    fs::create_symlink("real/picture.svg", scratch.path() / "one.svg");
    fs::create_symlink("one.svg", scratch.path() / "link.svg");
    REQUIRE(run_rinceau({"render", sample("rosette.lsys"), "-o", scratch.file("link.svg")}).status == 0);
    CHECK(fs::is_symlink(scratch.path() / "link.svg"));
    CHECK(fs::is_symlink(scratch.path() / "one.svg"));
    CHECK(read_file(scratch.path() / "real" / "picture.svg").find("<svg") != std::string::npos);
    fs::create_symlink("round.svg", scratch.path() / "round.svg");
    CHECK(run_rinceau({"render", sample("rosette.lsys"), "-o", scratch.file("round.svg")}).status == 4);
}

TEST_CASE("An output with a second name is replaced under its own alone") {
    const ScratchFolder scratch;
    write_file(scratch.path() / "picture.svg", "old");
    fs::create_hard_link(scratch.path() / "picture.svg", scratch.path() / "kept.svg");
    REQUIRE(run_rinceau({"render", sample("rosette.lsys"), "-o", scratch.file("picture.svg")}).status == 0);
    CHECK(read_file(scratch.path() / "kept.svg") == "old");
    CHECK(read_file(scratch.path() / "picture.svg").find("<svg") != std::string::npos);
}

TEST_CASE("An output that root writes still belongs to whom it did") {
    if (::geteuid() != 0) return;  // nobody else can give files away
    constexpr uid_t somebody = 12345;
    const ScratchFolder scratch;
    const std::string name = scratch.file("picture.svg");
    write_file(name, "old");
    REQUIRE(::chown(name.c_str(), somebody, somebody + 1) == 0);
    REQUIRE(run_rinceau({"render", sample("rosette.lsys"), "-o", name}).status == 0);
    struct stat status {};
    REQUIRE(::stat(name.c_str(), &status) == 0);
    CHECK(status.st_uid == somebody);
    CHECK(status.st_gid == somebody + 1);
    CHECK(read_file(name).find("<svg") != std::string::npos);
}

TEST_CASE("An output that cannot be written gives status 4 before any work and is not harmed") {
    const ScratchFolder scratch;
    fs::create_directory(scratch.path() / "folder.svg");
    for (const std::string& name : {scratch.file("folder.svg"), scratch.file("missing/picture.svg")}) {
        CAPTURE(name);
        const ProgramRun run = run_rinceau({"render", sample("rosette.lsys"), "-o", name});
        CHECK(run.status == 4);
        CHECK(run.err.starts_with(name + ": cannot be written: "));
    }
    CHECK(scratch.names() == std::vector<std::string>{"folder.svg"});
}

TEST_CASE("A full disk gives status 4") {
    CHECK(run_rinceau({"render", sample("rosette.lsys")}, {.output_to = "/dev/full"}).status == 4);
    const ScratchFolder scratch;
    fs::create_symlink("/dev/full", scratch.path() / "full.svg");
    CHECK(run_rinceau({"render", sample("rosette.lsys"), "-o", scratch.file("full.svg")}).status == 4);
    CHECK(fs::is_symlink(scratch.path() / "full.svg"));
}

TEST_CASE("An input that cannot be read gives status 1 and its name") {
    const ScratchFolder scratch;
    for (const std::string& name : {scratch.file("missing.svg"), scratch.path().string()})
        for (const std::string verb : {"analyze", "normalize", "render", "derive", "check"}) {
            CAPTURE(verb, name);
            const ProgramRun run = run_rinceau({verb, name});
            CHECK(run.status == 1);
            CHECK(run.err.starts_with(name + ": cannot be read: "));
            CHECK(run.out.empty());
        }
}

TEST_CASE("Input and output may be the same file, and names may hold spaces and begin with a dash") {
    const ScratchFolder scratch;
    write_file(scratch.path() / "- my drawing.svg", line_drawing);
    const std::vector<std::string> in_place = {"normalize", "-o", "- my drawing.svg", "--", "- my drawing.svg"};
    REQUIRE(run_rinceau(in_place, {.folder = scratch.path()}).status == 0);
    const std::string once = read_file(scratch.path() / "- my drawing.svg");
    REQUIRE(run_rinceau(in_place, {.folder = scratch.path()}).status == 0);
    CHECK(read_file(scratch.path() / "- my drawing.svg") == once);
}

TEST_CASE("An interrupt leaves either the old file or the whole new one, and nothing beside it") {
    const ScratchFolder scratch;
    const std::string name = scratch.file("rules.lsys");
    for (const int after_ms : {1, 5, 20, 60}) {
        write_file(name, "old");
        const ProgramRun run =
            run_rinceau({"analyze", sample("keyboard.svg"), "-o", name}, {.interrupt_after_ms = after_ms});
        CAPTURE(after_ms, run.err);
        CHECK((run.signal == SIGINT || run.status == 0));
        CHECK(scratch.names() == std::vector<std::string>{"rules.lsys"});
        CHECK((read_file(name) == "old" || run_rinceau({"check", name}).status == 0));
    }
}
