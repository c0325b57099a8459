// Many drawings by one command: the same as one by one, and whole whatever happens.

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using namespace rinceau::test;
namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

/// A row of `count` squares, `step` apart.
std::string row_of_squares(int count, int step) {
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"900\" height=\"40\">";
    for (int i = 0; i < count; ++i)
        svg += "<rect x=\"" + std::to_string(i * step) + "\" y=\"10\" width=\"9\" height=\"9\" fill=\"#a33\"/>";
    return svg + "</svg>";
}

/// "art" in a scratch folder: rows of squares, also in folders below, and one file that is no drawing.
struct Art {
    ScratchFolder scratch;
    Words stems;  ///< sorted

    explicit Art(int drawings) {
        for (int i = 0; i < drawings; ++i) {
            const std::string stem = (i % 3 == 0 ? "deep/er/" : "") + ("row " + std::to_string(10 + i));
            write(stem + (i % 5 == 4 ? ".SVG" : ".svg"), row_of_squares(3 + i, 12 + i));
            stems.push_back(stem);
        }
        write("notes.txt", "no drawing");
        write(".hidden.svg", "no drawing");
        std::ranges::sort(stems);
    }
    void write(const std::string& name, const std::string& text) const {
        const fs::path file = scratch.path() / "art" / name;
        fs::create_directories(file.parent_path());
        write_file(file, text);
    }
    std::string file(const std::string& name) const { return scratch.file(name); }
    std::string read(const std::string& name) const { return read_file(scratch.path() / name); }
    bool has(const std::string& name) const { return fs::exists(scratch.path() / name); }

    ProgramRun run(Words words, ProgramOptions options = {}) const {
        words.insert(words.begin(), "analyze");
        options.folder = scratch.path();
        return run_rinceau(words, options);
    }
    /// Everything in a folder with its content, but for the journal, which tells seconds.
    std::map<std::string, std::string> contents(const std::string& folder) const {
        std::map<std::string, std::string> files;
        for (const auto& entry : fs::recursive_directory_iterator(scratch.path() / folder))
            if (entry.is_regular_file() && entry.path().extension() != ".jsonl")
                files[fs::relative(entry.path(), scratch.path() / folder).string()] = read_file(entry.path());
        return files;
    }
    Words journal(const std::string& name) const {
        Words lines;
        if (!has(name)) return lines;
        std::istringstream text(read(name));
        for (std::string line; std::getline(text, line);) lines.push_back(line);
        return lines;
    }
};

std::string drawing_of(const std::string& line) { return nlohmann::json::parse(line).at("drawing"); }

Words drawings_of(const Words& lines) {
    Words drawings;
    for (const std::string& line : lines) drawings.push_back(drawing_of(line));
    std::ranges::sort(drawings);
    return drawings;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string rows = "out/.rinceau/rows.jsonl";

}  // namespace

TEST_CASE("Many drawings give each what it gives alone, whatever the number of processes") {
    const Art art(7);
    const Words words{"art",           "-o", "out", "--report", "table.csv", "--report", "out/table.json", "--report",
                      "out/sheet.html"};
    Words one = words, three = words;
    for (const std::string word : {"--jobs", "1"}) one.push_back(word);
    for (const std::string word : {"--jobs", "3"}) three.push_back(word);
    REQUIRE(art.run(one).status == 0);
    const auto first = art.contents("out");
    const std::string table = art.read("table.csv");
    for (const std::string& stem : art.stems) {
        CAPTURE(stem);
        const std::string drawing = art.file("art/" + stem + (art.has("art/" + stem + ".svg") ? ".svg" : ".SVG"));
        const ProgramRun alone = run_rinceau({"analyze", drawing, "-o", "-"});
        CHECK(art.read("out/" + stem + ".lsys") == alone.out);
    }
    CHECK(std::count(table.begin(), table.end(), '\n') == 8);
    CHECK(!contains(table, "hidden"));

    fs::remove_all(art.scratch.path() / "out");
    const ProgramRun again = art.run(three);
    CHECK(again.status == 0);
    CHECK(art.contents("out") == first);
    CHECK(art.read("table.csv") == table);
    CHECK(again.out.empty());
    CHECK(std::count(again.err.begin(), again.err.end(), '\n') == 8);  // one a drawing, and the sum
}

TEST_CASE("A drawing at fault is a row with its message, and all others are done") {
    const Art art(3);
    art.write("bad.svg", "<svg xmlns='http://www.w3.org/2000/svg'>\n<rect></svg>");
    const ProgramRun run = art.run({"art", "vanished.svg", "-o", "out", "--report", "t.json", "--report", "out/s.html"});
    CHECK(run.status == 5);
    const auto report = nlohmann::json::parse(art.read("t.json"));
    CHECK(report.at("done") == 3);
    CHECK(report.at("failed") == 2);
    std::map<std::string, nlohmann::json> by_input;
    for (const auto& row : report.at("rows")) by_input[row.at("input")] = row;
    CHECK(by_input.at("art/bad.svg").at("status") == "input_at_fault");
    CHECK(contains(by_input.at("art/bad.svg").at("message"), "art/bad.svg:2"));
    CHECK(contains(by_input.at("vanished.svg").at("message"), "vanished.svg: cannot be read"));
    CHECK(contains(art.read("out/s.html"), "art/bad.svg:2"));
    CHECK(!art.has("out/bad.lsys"));

    // What was at fault is not read again until it changes.
    CHECK(contains(art.run({"art", "-o", "out", "--resume"}).err, "4 of 4 drawings are whole already"));
    art.write("bad.svg", row_of_squares(4, 20));
    CHECK(art.run({"art", "-o", "out", "--resume"}).status == 0);
    CHECK(art.has("out/bad.lsys"));
}

TEST_CASE("A batch that is killed goes on where it was, with nothing lost and nothing done twice") {
    const Art art(24);
    const Words words{"art", "-o", "out", "--jobs", "2", "--report", "t.csv", "--report", "out/s.html", "--resume"};
    Words elsewhere = words;
    std::ranges::replace(elsewhere, std::string("out"), std::string("whole"));
    std::ranges::replace(elsewhere, std::string("out/s.html"), std::string("whole/s.html"));
    REQUIRE(art.run(elsewhere).status == 0);
    const std::string table = art.read("t.csv");
    fs::remove(art.scratch.path() / "t.csv");

    Words before;
    std::map<std::string, fs::file_time_type> written;
    for (const std::size_t kill_at : {3u, 8u, 13u}) {
        const ProgramRun killed = art.run(words, {.signal_when = [&] { return art.journal(rows).size() >= kill_at; }});
        REQUIRE(killed.signal == SIGKILL);
        CHECK(!art.has("t.csv"));
        // What the run that was killed had found done, this one has left alone.
        const Words now = art.journal(rows);
        REQUIRE(now.size() >= kill_at);
        CHECK(std::equal(before.begin(), before.end(), now.begin()));
        for (const auto& [name, time] : written) CHECK(fs::last_write_time(name) == time);
        before = now;
        for (const std::string& line : now) {
            const std::string name = art.file("out/" + drawing_of(line) + ".lsys");
            written[name] = fs::last_write_time(name);
        }
    }
    const std::string cut = before.back().substr(0, before.back().size() / 2);
    write_file(art.scratch.path() / rows, art.read(rows) + cut);  // as a machine that went down may leave it

    REQUIRE(art.run(words).status == 0);
    Words after = art.journal(rows);
    CHECK(std::erase(after, cut) == 1);
    CHECK(drawings_of(after) == art.stems);
    CHECK(art.read("t.csv") == table);
    CHECK(art.contents("out") == art.contents("whole"));
    for (const auto& [name, time] : written) CHECK(fs::last_write_time(name) == time);
}

TEST_CASE("An interrupt ends a batch between drawings, and all that was done counts") {
    const Art art(24);
    const Words words{"art", "-o", "out", "--jobs", "2", "--resume"};
    const ProgramRun run = art.run(words, {.signal_when = [&] { return art.journal(rows).size() >= 4; }, .signal = SIGINT});
    CHECK(run.signal == SIGINT);
    CHECK(contains(run.err, "--resume goes on"));
    const std::size_t done = art.journal(rows).size();
    CHECK(done < 24);
    for (const auto& [name, content] : art.contents("out")) CHECK(name.ends_with(".lsys"));
    const ProgramRun rest = art.run(words);
    CHECK(rest.status == 0);
    CHECK(contains(rest.err, std::to_string(done) + " of 24 drawings are whole already"));
    CHECK(drawings_of(art.journal(rows)) == art.stems);
}

TEST_CASE("Shards take each drawing once, do not depend on other drawings, and make up the whole") {
    const Art art(20);
    REQUIRE(art.run({"art", "-o", "whole", "--report", "whole.csv", "--report", "whole/s.html"}).status == 0);
    Words all;
    std::map<std::string, Words> shares;
    for (const std::string i : {"1", "2", "3"}) {
        REQUIRE(art.run({"art", "-o", "out", "--shard", i + "/3", "--report", "out/s" + i + ".html"}).status == 0);
        shares[i] = drawings_of(art.journal("out/.rinceau/rows-" + i + "-of-3.jsonl"));
        CHECK(!shares[i].empty());
        all.insert(all.end(), shares[i].begin(), shares[i].end());
        fs::remove(art.scratch.path() / "out" / ("s" + i + ".html"));
    }
    std::ranges::sort(all);
    CHECK(all == art.stems);

    // One report of all, for which nothing has to be done again.
    const ProgramRun sum = art.run({"art", "-o", "out", "--resume", "--report", "sum.csv", "--report", "out/s.html"});
    CHECK(sum.status == 0);
    CHECK(contains(sum.err, "20 of 20 drawings are whole already"));
    CHECK(art.read("sum.csv") == art.read("whole.csv"));
    CHECK(art.contents("out") == art.contents("whole"));

    // A drawing that comes or goes moves no other to another share.
    const std::string gone = shares["2"].front();
    fs::remove(art.scratch.path() / "art" / (gone + (art.has("art/" + gone + ".svg") ? ".svg" : ".SVG")));
    art.write("one more.svg", row_of_squares(4, 20));
    for (const auto& [i, share] : shares) {
        REQUIRE(art.run({"art", "-o", "later", "--shard", i + "/3"}).status == 0);
        Words expected = share, found = drawings_of(art.journal("later/.rinceau/rows-" + i + "-of-3.jsonl"));
        std::erase(expected, gone);
        std::erase(found, "one more");
        CHECK(found == expected);
    }
}

TEST_CASE("What has changed since is done again: the drawing, the options, an output that is gone") {
    const Art art(5);
    const Words words{"art", "-o", "out", "--resume"};
    REQUIRE(art.run(words).status == 0);
    CHECK(contains(art.run(words).err, "5 of 5 drawings"));
    const std::string before = art.read("out/row 11.lsys");
    std::string changed = art.read("art/row 11.svg");  // of the same length
    changed.replace(changed.find("#a33"), 4, "#3a3");
    art.write("row 11.svg", changed);
    fs::remove(art.scratch.path() / "out" / "row 12.lsys");
    CHECK(contains(art.run(words).err, "3 of 5 drawings"));
    CHECK(art.read("out/row 11.lsys") != before);
    CHECK(art.has("out/row 12.lsys"));
    Words others = words;
    for (const std::string word : {"--objective", "paper"}) others.push_back(word);
    const std::string by_bits = art.read("out/row 11.lsys");
    CHECK(!contains(art.run(others).err, "whole already"));
    CHECK(contains(art.run(others).err, "5 of 5 drawings"));
    // What other options have written in the meantime does not count as done.
    CHECK(art.run(words).status == 0);
    CHECK(art.read("out/row 11.lsys") == by_bits);
    // This run asks for pictures, too.
    Words with_sheet = words;
    for (const std::string word : {"--report", "out/sheet.html"}) with_sheet.push_back(word);
    CHECK(!contains(art.run(with_sheet).err, "whole already"));
    CHECK(art.has("out/pictures/row 11_after.png"));
}

TEST_CASE("A drawing that several arguments name is done once, and names that meet are refused") {
    const Art art(4);
    fs::create_directory_symlink(art.scratch.path() / "art", art.scratch.path() / "art" / "loop");
    const ProgramRun once = art.run({"art", "./art/row 11.svg", "art/deep", "art/../art", "-o", "out"});
    CHECK(once.status == 0);
    CHECK(drawings_of(art.journal(rows)) == art.stems);

    art.write("deep/row 11.svg", row_of_squares(5, 15));
    const ProgramRun refused = art.run({"art/row 11.svg", "art/deep", "-o", "second"});
    CHECK(refused.status == 2);
    CHECK(contains(refused.err, "'art/row 11.svg'"));
    CHECK(contains(refused.err, "'art/deep/row 11.svg'"));
    CHECK(!art.has("second"));
}

TEST_CASE("What takes too long or too much memory is a row, and is tried again") {
    const Art art(2);
    std::string scattered = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"900\" height=\"900\">";
    for (unsigned i = 0, at = 1; i < 20000; ++i, at = at * 1103515245U + 12345U)
        scattered += "<circle cx=\"" + std::to_string(at % 90001 / 100.0) + "\" cy=\"" +
                     std::to_string(at / 7 % 90001 / 100.0) + "\" r=\"" + std::to_string(1 + i % 97) + "\"/>";
    art.write("many.svg", scattered + "</svg>");
    const ProgramRun slow = art.run({"art/many.svg", "-o", "out", "--seconds-per-file", "0.05", "--report", "t.json"});
    CHECK(slow.status == 5);
    CHECK(contains(art.read("t.json"), "\"limit_reached\""));
    CHECK(contains(slow.err, "not done after 0.05 s"));
    CHECK(art.contents("out").empty());
#ifndef RINCEAU_SANITIZED  // a sanitizer's shadow is larger than any limit
    const ProgramRun large =
        art.run({"art/many.svg", "-o", "out", "--resume", "--memory-per-file", "16", "--report", "t.json"});
    CHECK(large.status == 5);
    CHECK(contains(art.read("t.json"), "the memory does not suffice"));
#endif
    CHECK(art.run({"art/row 11.svg", "-o", "out", "--resume"}).status == 0);
}

TEST_CASE("Two runs cannot write the same rows") {
    const Art art(2);
    REQUIRE(art.run({"art", "-o", "out"}).status == 0);
    const int journal = ::open(art.file(rows).c_str(), O_RDWR | O_CLOEXEC);
    struct flock whole {};
    whole.l_type = F_WRLCK;
    whole.l_whence = SEEK_SET;
    REQUIRE(::fcntl(journal, F_SETLK, &whole) == 0);
    const std::string before = art.read(rows);  // closing a file of the same name gives up the lock
    REQUIRE(::fcntl(journal, F_SETLK, &whole) == 0);
    const ProgramRun second = art.run({"art", "-o", "out"});
    CHECK(second.status == 4);
    CHECK(contains(second.err, "another rinceau is at work"));
    CHECK(art.run({"art", "-o", "out", "--shard", "1/2"}).status == 0);
    ::close(journal);
    CHECK(art.read(rows) == before);
}

TEST_CASE("A wrong command line for many drawings gives status 2 and makes nothing") {
    const Art art(2);
    const std::vector<Words> wrong = {
        {"art/row 10.svg", "art/row 11.svg"},
        {"art", "-o", "out.lsys"},
        {"art", "-", "-o", "out"},
        {"art", "-o", "out", "--print"},
        {"art", "-o", "out", "--spaces", "s.csv"},
        {"art", "-o", "out", "--report", "t.txt"},
        {"art", "-o", "out", "--report", "outside.html"},
        {"art", "-o", "out", "--jobs", "-1"},
        {"art", "-o", "out", "--shard", "0/3"},
        {"art", "-o", "out", "--shard", "4/3"},
        {"art", "-o", "out", "--shard", "2"},
        {"art", "-o", "out", "--shard", "1/2x"},
        {"art", "-o", "out", "--seconds-per-file", "-1"},
    };
    for (const Words& words : wrong) {
        CAPTURE(words);
        const ProgramRun run = art.run(words);
        CHECK(run.status == 2);
        CHECK(run.err.starts_with("rinceau: "));
        CHECK(art.scratch.names() == Words{"art"});
    }
    fs::create_directory(art.scratch.path() / "empty");
    CHECK(art.run({"empty", "-o", "out"}).status == 1);
}
