#include "lsystem/edit_replace.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/measure_symbol.h"
#include "lsystem/to_scene.h"

using namespace rinceau;
using Catch::Matchers::Contains;

namespace {

Grammar grammar_of(const std::string& text) { return parse_grammar("lsystem 1\n" + text); }

Replacement own(const std::string& symbol, const std::string& with) {
    return {symbol, OwnModules{with.empty() ? ModuleTemplates{} : grammar_of("axiom: " + with).axiom}, with};
}

Element outline(Box box, Color color = {0, 128, 0}) {
    Element element;
    element.paths = {
        {box.low, {line_to({box.high.x, box.low.y}), line_to(box.high), line_to({box.low.x, box.high.y})}, true}};
    element.style.fill = color;
    return element;
}

Replacement drawing(const std::string& symbol, std::vector<Element> elements) {
    return {symbol, OtherDrawing{std::move(elements), "Leaf"}, "leaf.svg"};
}

std::string text_after(const std::string& text, const std::vector<Replacement>& replacements,
                       const ReplaceOptions& options = {}) {
    return to_text(replace_symbols(grammar_of(text), replacements, options).grammar);
}

std::vector<Placement> placements_of(const Grammar& grammar, const std::string& symbol) {
    std::vector<Placement> placements = interpret(grammar, {.addresses = true});
    std::erase_if(placements, [&](const Placement& placement) {
        return grammar.terminals[static_cast<std::size_t>(placement.terminal)].symbol != symbol;
    });
    return placements;
}

Box box_of(const Grammar& grammar, const Placement& placement) {
    return visible_box(to_scene(grammar, {placement}).elements);
}

void check_same_poses(const std::vector<Placement>& found, const std::vector<Placement>& expected, double tolerance = 1e-9) {
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        CHECK(abs(found[i].pose.linear - expected[i].pose.linear) < tolerance);
        CHECK(abs(found[i].pose.translation - expected[i].pose.translation) < tolerance);
        CHECK(found[i].pose.mirrored == expected[i].pose.mirrored);
    }
}

std::string message_of(const std::string& text, const std::vector<Replacement>& replacements,
                       const ReplaceOptions& options = {}) {
    try {
        replace_symbols(grammar_of(text), replacements, options);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

ModuleTemplate with_count(const std::string& symbol, int count) { return {symbol, {number_expression(count)}, {}}; }

const std::string windows =
    "axiom: *(2) f(3) +(20) Row(3) [| f(5) Window] Door\n"
    "Row(m) : m > 0 -> Window -(90) f(30) +(90) *(0.9) Row(m-1)\n"
    "style 1: fill #ff0000\n"
    "terminal Window: style 1; path \"M-10 -12H10V8H-10Z\"\n"
    "terminal Door: style 1; path \"M-5 -40H5V0H-5Z\"\n";

}  // namespace

TEST_CASE("A drawing takes the place of a terminal: everywhere centre on centre, as large as fits") {
    const Grammar before = grammar_of(windows);
    const EditResult result = replace_symbols(before, {drawing("Window", {outline({{100, 100}, {300, 200}})})});
    const auto old_places = placements_of(before, "Window");
    const auto places = placements_of(result.grammar, "Leaf");
    check_same_poses(places, old_places);
    const Box old_box = measure(before, {{"Window", {}, {}}}).box;
    const Box box = measure(result.grammar, {{"Leaf", {}, {}}}).box;
    CHECK(width(box) == Approx(width(old_box)));
    CHECK(height(box) == Approx(width(old_box) / 2));
    CHECK(center(box).x == Approx(center(old_box).x).margin(1e-6));
    CHECK(center(box).y == Approx(center(old_box).y));
    CHECK(result.changes.at(0) == "Window -> leaf.svg (1 outline, scaled by 0.1) in 4 places");
    CHECK(result.changes.at(1) == "no longer used and removed: Window");
    CHECK(placements_of(result.grammar, "Door").front().pose == placements_of(before, "Door").front().pose);
}

TEST_CASE("How large is a choice") {
    const Grammar before = grammar_of(windows);
    const Box wide{{0, 0}, {40, 10}};  // the window is 20 wide and 20 high
    const auto size_with = [&](ReplaceFit fit) {
        const EditResult result = replace_symbols(before, {drawing("Window", {outline(wide)})}, {.fit = fit});
        const Box box = measure(result.grammar, {{"Leaf", {}, {}}}).box;
        CHECK(center(box).y == Approx(2));
        return Point{width(box), height(box)};
    };
    CHECK(size_with(ReplaceFit::none) == Point{40, 10});
    CHECK(size_with(ReplaceFit::inside) == Point{20, 5});
    CHECK(size_with(ReplaceFit::cover) == Point{80, 20});
    CHECK(size_with(ReplaceFit::width) == Point{20, 5});
    CHECK(size_with(ReplaceFit::height) == Point{80, 20});
}

TEST_CASE("A turned drawing fits as it stands turned") {
    const EditResult result =
        replace_symbols(grammar_of(windows), {drawing("Window", {outline({{0, 0}, {40, 10}})})}, {.turn = 90});
    const Box box = measure(result.grammar, {{"Leaf", {}, {}}}).box;
    CHECK(width(box) == Approx(5));
    CHECK(height(box) == Approx(20));
}

TEST_CASE("A drawing of several looks is one symbol with a terminal each, in its order") {
    const std::vector<Element> elements{outline({{0, 0}, {10, 10}}), outline({{20, 0}, {30, 10}}),
                                        outline({{0, 0}, {5, 5}}, {255, 255, 0})};
    const EditResult result = replace_symbols(grammar_of(windows), {drawing("Window", elements)});
    const auto production = std::ranges::find(result.grammar.productions, "Leaf", &Production::symbol);
    REQUIRE(production != result.grammar.productions.end());
    REQUIRE(production->successor.size() == 2);
    const auto first = std::ranges::find(result.grammar.terminals, "Leaf1", &Terminal::symbol);
    REQUIRE(first != result.grammar.terminals.end());
    CHECK(first->paths.size() == 2);  // look alike and lie apart
    CHECK(result.changes.at(0) == "Window -> leaf.svg (3 outlines, scaled by 0.667) in 4 places");
}

TEST_CASE("A fragment of SVG comes along as it is") {
    Element text;
    text.verbatim = "<text>hello</text>";
    text.verbatim_box = {{0, 0}, {40, 10}};
    const EditResult result = replace_symbols(grammar_of(windows), {drawing("Window", {text})});
    const auto leaf = std::ranges::find(result.grammar.terminals, "Leaf", &Terminal::symbol);
    REQUIRE(leaf != result.grammar.terminals.end());
    CHECK_THAT(leaf->verbatim, Contains("<text>hello</text>"));
    CHECK(width(leaf->verbatim_box) == Approx(20));
}

TEST_CASE("Two symbols swap, and swap back") {
    const Grammar before = grammar_of(windows);
    const std::vector<Replacement> swap{own("Window", "Door"), own("Door", "Window")};
    const EditResult once = replace_symbols(before, swap, {.fit = ReplaceFit::none});
    CHECK(placements_of(once.grammar, "Door").size() == 4);
    CHECK(placements_of(once.grammar, "Window").size() == 1);
    const EditResult twice = replace_symbols(once.grammar, swap, {.fit = ReplaceFit::none});
    CHECK(to_text(twice.grammar) == to_text(before));
}

TEST_CASE("What stands behind a symbol that moves the turtle stays where it is") {
    const std::string text =
        "axiom: f(7) +(10) Path(4) Door Path(2) Door [Path(3)] Door\n"
        "Path(m) : m > 0 -> Stone +(13) f(20) *(0.9) | Path(m-1)\n"
        "terminal Stone: path \"M-5 -5H5V5H-5Z\"\nterminal Door: path \"M-5 -40H5V0H-5Z\"\n";
    const Grammar before = grammar_of(text);
    for (const std::string with : {"Stone", "", "[+(40) Stone] Stone"}) {
        CAPTURE(with);
        const EditResult result = replace_symbols(before, {own("Path", with)});
        check_same_poses(placements_of(result.grammar, "Door"), placements_of(before, "Door"));
    }
    SECTION("each new thing lies in the box of the old one, also where that is of another size") {
        const EditResult result = replace_symbols(before, {drawing("Path", {outline({{0, 0}, {1, 1}})})});
        check_same_poses(placements_of(result.grammar, "Door"), placements_of(before, "Door"));
        const auto leaves = placements_of(result.grammar, "Leaf");
        REQUIRE(leaves.size() == 3);
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            // the first stone of a path stands where the path begins
            const Placement start = placements_of(before, "Stone")[std::vector<std::size_t>{0, 4, 6}[i]];
            const Box place = measure(before, {with_count("Path", i == 0 ? 4 : i == 1 ? 2 : 3)}).box;
            const Similarity leaf = inverse(start.pose) * leaves[i].pose;
            const Box unit = measure(result.grammar, {{"Leaf", {}, {}}}).box;
            CHECK(scale_of(leaf) * width(unit) == Approx(std::min(width(place), height(place))).epsilon(1e-4));
            CHECK(abs(apply(leaf, center(unit)) - center(place)) < 1e-3);
        }
    }
}

TEST_CASE("A symbol whose numbers are computed gets a seat for each of them") {
    const std::string text =
        "axiom: Bunch(4)\n"
        "Bunch(m) : m > 0 -> [Row(m)] f(11) Bunch(m-1)\n"
        "Row(m) : m > 0 -> [Berry] -(90) f(13) +(90) Row(m-1)\n"
        "terminal Berry: path \"M-5 -5H5V5H-5Z\"\n";
    const Grammar before = grammar_of(text);
    const EditResult result = replace_symbols(before, {drawing("Row", {outline({{0, 0}, {100, 1}})})});
    const auto leaves = placements_of(result.grammar, "Leaf");
    REQUIRE(leaves.size() == 4);
    for (int m = 4; m > 0; --m) {
        const Box box = box_of(result.grammar, leaves[static_cast<std::size_t>(4 - m)]);
        CHECK(width(box) == Approx(13 * (m - 1) + 10));
        CHECK(box.low.x == Approx(-5));
    }
    CHECK_THAT(result.changes.at(0), Contains("scaled by 0.1 to 0.49"));
    CHECK(check_grammar(to_text(result.grammar)).empty());
}

TEST_CASE("Numbers are passed on to a symbol that takes as many, else it keeps its own") {
    const std::string text =
        "axiom: [Row(3)] [Ring(8)] [Star]\n"
        "Row(m) : m > 0 -> Star f(1) Row(m-1)\n"
        "Ring(m) : m > 0 -> [f(2) Dot] +(45) Ring(m-1)\n"
        "terminal Star: path \"M0 0H1V1Z\"\nterminal Dot: path \"M0 0H1V1Z\"\n";
    CHECK_THAT(text_after(text, {own("Row", "Ring")}, {.fit = ReplaceFit::none}),
               Contains("axiom: [Ring(3)] [Ring(8)] [Star]"));
    CHECK_THAT(text_after(text, {own("Star", "Ring")}, {.fit = ReplaceFit::none}), Contains("[Ring(8)] [Ring(8)]"));
    CHECK_THAT(text_after(text, {own("Row", "Ring(5)")}, {.fit = ReplaceFit::none}),
               Contains("axiom: [Ring(5)] [Ring(8)] [Star]"));
    CHECK_THAT(text_after(text, {own("Row", "Dot")}, {.fit = ReplaceFit::none}), Contains("axiom: [Dot] [Ring(8)] [Star]"));
}

TEST_CASE("A single address is an exception, and others keep their modules") {
    const std::string text =
        "axiom: Wall(3)\nWall(m) : m > 0 -> [Row(4)] f(40) Wall(m-1)\n"
        "Row(m) : m > 0 -> [Window] -(90) f(30) +(90) Row(m-1)\n"
        "except 1.1.2 -> +(5) Window\n"
        "terminal Window: path \"M-10 -20H10V0H-10Z\"\nterminal Door: path \"M-5 -40H5V0H-5Z\"\n";
    const Grammar before = grammar_of(text);
    const EditResult result = replace_symbols(before, {own("Window", "Door")}, {.at = {{1, 2, 3}}});
    CHECK(placements_of(result.grammar, "Window").size() == 11);
    REQUIRE(placements_of(result.grammar, "Door").size() == 1);
    CHECK(placements_of(result.grammar, "Door")[0].address == std::vector<int>{1, 2, 3});
    CHECK(result.changes.at(0) == "Window -> Door (scaled by 0.5) in 1 place");

    SECTION("where an exception stands already, it is changed") {
        const EditResult changed = replace_symbols(before, {own("Window", "Door")}, {.at = {{1, 1, 2}}});
        REQUIRE(changed.grammar.exceptions.size() == 1);
        const Placement door = placements_of(changed.grammar, "Door").at(0);
        CHECK(abs(door.pose.linear / Complex{0.5, 0} - polar(1, radians(5))) < 1e-9);
    }
    SECTION("a whole row, and the exception in it goes") {
        const EditResult changed = replace_symbols(before, {own("Row", "Door")}, {.at = {{1, 1}}});
        CHECK(placements_of(changed.grammar, "Window").size() == 8);
        CHECK(changed.grammar.exceptions.size() == 1);
        CHECK(changed.changes.at(1) == "1 exception below what was replaced removed");
    }
    SECTION("everywhere, exceptions included") {
        const EditResult changed = replace_symbols(before, {own("Window", "Door")});
        CHECK(placements_of(changed.grammar, "Door").size() == 12);
        CHECK(changed.grammar.exceptions.size() == 1);
    }
    CHECK_THAT(message_of(text, {own("Window", "Door")}, {.at = {{1, 2, 9}}}),
               Contains("expected Window at 1.2.9, found none there: it stands at 1.1.1, 1.1.2, 1.1.3"));
}

TEST_CASE("What is erased leaves the addresses of everything else alone") {
    const std::string text =
        "axiom: Window Door Window\nexcept 3 -> f(5) Window\nexcept 2 -> f(9) Door\n"
        "terminal Window: path \"M-10 -20H10V0H-10Z\"\nterminal Door: path \"M-5 -40H5V0H-5Z\"\n";
    const EditResult result = replace_symbols(grammar_of(text), {own("Window", "")});
    CHECK(placements_of(result.grammar, "Window").empty());
    REQUIRE(placements_of(result.grammar, "Door").size() == 1);
    CHECK(placements_of(result.grammar, "Door")[0].pose.translation == Point{0, 9});
    CHECK(result.changes.at(0) == "Window erased in 2 places");
}

TEST_CASE("Without exceptions nothing is left of what is erased") {
    const std::string text = text_after(windows, {own("Window", "")});
    CHECK_THAT(text, !Contains("Window"));
    CHECK_THAT(text, !Contains("|"));
    CHECK_THAT(text, Contains("-(90) f(30) +(90) *(0.9) Row(m-1)"));
}

TEST_CASE("Parts of another grammar come along under names that do not clash, and draw what they drew") {
    const Grammar donor = grammar_of(
        "define pitch = 9\ndefine m = 2\n"
        "axiom: ;(2) Row(5)\n"
        "Row(n) : n > 0 -> [;(1+n%2) Window] [;(2) Tick(n)] f(pitch*m) Row(n-1)\n"
        "Tick(m) -> +(m) Window\n"
        "style 1: fill #00ff00\nstyle 2: fill #0000ff\n"
        "terminal Window: style 2; path \"M-1 -1H1V1H-1Z\"\n");
    const Grammar before = grammar_of(windows);
    const Box door = measure(before, {{"Door", {}, {}}}).box;
    for (const ModuleTemplates& string : {ModuleTemplates{}, grammar_of("axiom: Row").axiom}) {
        const EditResult result = replace_symbols(before, {{"Door", OtherGrammar{donor, string, "Vine"}, "vine.lsys"}});
        CHECK(check_grammar(to_text(result.grammar)).empty());
        const auto placements = interpret(result.grammar);
        const auto alone = interpret(donor);
        REQUIRE(placements.size() == 4 + alone.size());
        const Similarity there = placements[4].pose * inverse(alone[0].pose);
        for (std::size_t i = 0; i < alone.size(); ++i) {
            CHECK(abs(placements[4 + i].pose.translation - apply(there, alone[i].pose.translation)) < 1e-9);
            const Scene one = to_scene(result.grammar, {placements[4 + i]});
            const Scene other = to_scene(donor, {alone[i]});
            CHECK(same_style(one.elements[0].style, other.elements[0].style, 1e-9));
        }
        std::vector<Placement> in_place(placements.begin() + 4, placements.end());
        const Similarity to_door = inverse(placements_of(before, "Door").at(0).pose);
        for (Placement& placement : in_place) placement.pose = to_door * placement.pose;
        const Box box = visible_box(to_scene(result.grammar, in_place).elements);
        CHECK(abs(center(box) - center(door)) < 1e-3);
        CHECK(std::max(width(box) / width(door), height(box) / height(door)) == Approx(1).epsilon(1e-4));
    }
}

TEST_CASE("The exceptions of another grammar come along with all of it") {
    const Grammar donor = grammar_of(
        "axiom: Row(4)\nRow(m) : m > 0 -> [Tick] f(3) Row(m-1)\nexcept 1.2 -> *(2) Tick\nexcept 1.3 ->\n"
        "terminal Tick: path \"M-1 -1H1V1H-1Z\"\n");
    const EditResult result =
        replace_symbols(grammar_of(windows), {{"Door", OtherGrammar{donor, {}, "Ticks"}, "ticks.lsys"}});
    const auto ticks = placements_of(result.grammar, "Tick");
    REQUIRE(ticks.size() == 3);
    CHECK(scale_of(ticks[1].pose) == Approx(2 * scale_of(ticks[0].pose)));
}

TEST_CASE("A copy of a symbol may hold what it draws itself") {
    const Grammar before = grammar_of(windows);
    const EditResult result = replace_symbols(
        before, {{"Window", OtherGrammar{before, grammar_of("axiom: Row").axiom, "Windows"}, "windows.lsys#Row"}});
    CHECK(placements_of(result.grammar, "Window").size() == 3 * 4);
    CHECK(result.grammar.terminals.size() == before.terminals.size());
}

TEST_CASE("A style in force does not colour what comes from elsewhere") {
    const std::string text = "axiom: ;(1) Window\nstyle 1: fill #ff0000\nterminal Window: path \"M-10 -20H10V0H-10Z\"\n";
    const EditResult result = replace_symbols(grammar_of(text), {drawing("Window", {outline({{0, 0}, {1, 1}}, {1, 2, 3})})});
    const Scene scene = to_scene(result.grammar, interpret(result.grammar));
    CHECK(std::get<Color>(scene.elements.at(0).style.fill) == Color{1, 2, 3});

    const EditResult restyled =
        replace_symbols(grammar_of(text), {drawing("Window", {outline({{0, 0}, {1, 1}}, {1, 2, 3})})}, {.restyle = true});
    const Scene red = to_scene(restyled.grammar, interpret(restyled.grammar));
    CHECK(std::get<Color>(red.elements.at(0).style.fill) == Color{255, 0, 0});
}

TEST_CASE("What nothing uses any more goes, unless it is kept or was never used") {
    const std::string text = windows + "Spare -> [Window] Knob\nterminal Knob: style 1; path \"M0 0H1V1Z\"\n";
    CHECK_THAT(text_after(text, {own("Window", "Door")}), Contains("terminal Knob: style 1"));
    CHECK_THAT(text_after(text, {own("Window", "Door")}), !Contains("Window"));
    CHECK_THAT(text_after(windows, {own("Window", "Door")}), !Contains("Window"));
    CHECK_THAT(text_after(windows, {own("Window", "Door")}, {.keep = true}), Contains("terminal Window"));
    CHECK_THAT(text_after(windows, {own("Row", "Door")}), !Contains("Row"));
}

TEST_CASE("Faults are named with their cure") {
    CHECK_THAT(message_of(windows, {own("Windov", "Door")}), Contains("found 'Windov': did you mean 'Window'?"));
    CHECK_THAT(message_of(windows, {own("Window", "door")}), Contains("found 'door': did you mean 'Door'?"));
    CHECK_THAT(message_of(windows, {own("Zebra", "Door")}), Contains("there is Row, Window, Door"));
    CHECK_THAT(message_of(windows, {own("f", "Door")}), Contains("a command of the turtle"));
    CHECK_THAT(message_of(windows, {drawing("Window", {})}), Contains("a drawing with something in it"));
    CHECK_THAT(message_of(windows, {own("Window", "Row")}), Contains("would hold itself without end"));
    CHECK_THAT(message_of(windows, {own("Window", "Door"), own("Window", "Row")}), Contains("found two"));
    CHECK_THAT(
        message_of("axiom: A [B]\nA < B -> [A]\nterminal A: path \"M0 0H1\"\nterminal B: path \"M0 0H1\"", {own("A", "B")}),
        Contains("a symbol that is no context"));
}

TEST_CASE("Colours in force do not paint what comes from elsewhere, and what the old thing left in force stays") {
    const std::string text =
        "axiom: fill(255, 0, 0) Pot Window\nPot -> Window fill(0, 0, 255)\n"
        "terminal Window: path \"M-10 -20H10V0H-10Z\"\n";
    const EditResult result = replace_symbols(grammar_of(text), {drawing("Pot", {outline({{0, 0}, {1, 1}}, {1, 2, 3})})});
    const Scene scene = to_scene(result.grammar, interpret(result.grammar));
    REQUIRE(scene.elements.size() == 2);
    CHECK(std::get<Color>(scene.elements[0].style.fill) == Color{1, 2, 3});
    CHECK(std::get<Color>(scene.elements[1].style.fill) == Color{0, 0, 255});
}

TEST_CASE("Random numbers elsewhere stay as they are") {
    const std::string text =
        "seed 3\naxiom: Row(5)\n"
        "Row(m) : m > 0 -> [+(uniform(-9, 9)) Window] f(uniform(5, 9)) Post [f(normal(0, 3)) Door] f(uniform(10, 15)) "
        "Row(m-1)\n"
        "terminal Window: path \"M-10 -20H10V0H-10Z\"\nterminal Door: path \"M-5 -40H5V0H-5Z\"\n"
        "terminal Post: path \"M-1 -40H1V0H-1Z\"\n";
    const Grammar before = grammar_of(text);
    for (const std::string with : {"", "Door", "[*(2) Door] Door"}) {
        CAPTURE(with);
        const EditResult result = replace_symbols(before, {own("Window", with), own("Post", with)});
        std::vector<Placement> doors = placements_of(result.grammar, "Door");
        const std::vector<Placement> old_doors = placements_of(before, "Door");
        for (const Placement& old_door : old_doors) {
            CHECK(std::ranges::any_of(doors, [&](const Placement& door) {
                return abs(door.pose.translation - old_door.pose.translation) < 1e-9 &&
                       abs(door.pose.linear - old_door.pose.linear) < 1e-9;
            }));
        }
    }
    CHECK_THAT(message_of("axiom: Path Door\nPath -> Door f(uniform(1, 2))\nterminal Door: path \"M-5 -40H5V0H-5Z\"",
                          {own("Path", "Door")}),
               Contains("found a way of random numbers"));
}

TEST_CASE("What only stands in the drawing is replaced, too") {
    const std::string text =
        "axiom: Bud f(9) Bud\nhomomorphism Bud -> [+(30) Window]\n"
        "terminal Window: path \"M-10 -20H10V0H-10Z\"\nterminal Door: path \"M-5 -40H5V0H-5Z\"\n";
    const Grammar before = grammar_of(text);
    const EditResult result = replace_symbols(before, {own("Window", "Door")}, {.fit = ReplaceFit::none});
    check_same_poses(placements_of(result.grammar, "Door"), placements_of(before, "Window"));
    const EditResult buds = replace_symbols(before, {own("Bud", "Door")}, {.fit = ReplaceFit::none});
    CHECK(placements_of(buds.grammar, "Door").size() == 2);
    CHECK(buds.grammar.productions.empty());
}
