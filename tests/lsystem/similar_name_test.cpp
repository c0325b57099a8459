#include <catch2/catch.hpp>

#include "geometry/random.h"
#include "lsystem/similar_name.h"

using namespace rinceau;

TEST_CASE("the distance of two names counts letters and exchanges, not cases") {
    CHECK(edit_distance("Window", "window", 2) == 0);
    CHECK(edit_distance("Window", "Windows", 2) == 1);
    CHECK(edit_distance("Window", "Widnow", 2) == 1);
    CHECK(edit_distance("Window", "Wnidwo", 2) == 2);
    CHECK(edit_distance("", "ab", 2) == 2);
    CHECK(edit_distance("abc", "xyz", 2) == 3);
    CHECK(edit_distance("a", "abcdefgh", 2) == 3);
}

TEST_CASE("the distance is symmetric, and changes is 1 for an added letter") {
    Random random(3);
    const auto word = [&] {
        std::string text;
        for (std::uint32_t i = random.below(8); i > 0; --i) text += static_cast<char>('a' + random.below(3));
        return text;
    };
    for (int i = 0; i < 2000; ++i) {
        const std::string a = word(), b = word();
        std::string changed = b;
        changed.insert(random.below(static_cast<std::uint32_t>(changed.size() + 1)), 1, 'b');
        const int distance = edit_distance(a, b, 9);
        INFO(a << ' ' << b << ' ' << changed);
        CHECK(distance == edit_distance(b, a, 9));
        CHECK(edit_distance(b, changed, 9) == 1);
        CHECK(edit_distance(a, b, 2) == std::min(distance, 3));
    }
}

TEST_CASE("a similar name is the nearest one, and none where none is near") {
    const std::vector<std::string_view> names{"Windows", "Window", "Wall", "A", "B2"};
    CHECK(similar_name("Windw", names) == "Window");
    CHECK(similar_name("windows", names) == "Windows");
    CHECK(similar_name("C", names).empty());
    CHECK(similar_name("a", names) == "A");
    CHECK(similar_name("Wxyz", names).empty());
    CHECK(similar_name("", names).empty());
    CHECK(similar_name(std::string(1000, 'x'), names).empty());
}
