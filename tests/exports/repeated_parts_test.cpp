#include "exports/repeated_parts.h"

#include <catch2/catch.hpp>
#include <map>
#include <random>

using namespace rinceau;

namespace {

/// With names replaced until none is left, as often as the depth says.
std::string written_out(const std::vector<NamedPart>& parts) {
    std::map<char, std::string> texts;
    for (const NamedPart& part : parts) texts[part.name] = part.text;
    std::string text(1, parts.back().name);
    for (int round = 0; round < parts.back().depth; ++round) {
        std::string next;
        for (const char c : text) next += texts.contains(c) ? texts[c] : std::string(1, c);
        text = next;
    }
    for (const char c : text) CHECK_FALSE(texts.contains(c));
    return text;
}

std::string plain(const BracketedString& string, const std::vector<int>& tokens) {
    std::string text;
    for (const int token : tokens) {
        const auto number = static_cast<std::size_t>(token);
        text += number < string.atoms.size() ? string.atoms[number]
                                             : '[' + plain(string, string.groups[number - string.atoms.size()]) + ']';
    }
    return text;
}

}  // namespace

TEST_CASE("Named parts write out to the same string, brackets whole") {
    std::mt19937 random(7);
    for (int trial = 0; trial < 50; ++trial) {
        BracketedString string{.atoms = {"1", "22", "333", "4444"}};
        for (int group = 0; group < 4; ++group) {
            std::vector<int> content;
            for (unsigned k = 0; k < 1 + random() % 6; ++k)
                content.push_back(static_cast<int>(random() % (4U + static_cast<unsigned>(group))));
            string.groups.push_back(content);
        }
        for (int k = 0; k < 300; ++k) string.whole.push_back(static_cast<int>(random() % 8));
        const auto parts = named_parts(string, "abcdefghijkls");
        CHECK(parts.back().name == 's');
        CHECK(written_out(parts) == plain(string, string.whole));
        for (const NamedPart& part : parts) {
            int open = 0;
            for (const char c : part.text) {
                open += c == '[' ? 1 : c == ']' ? -1 : 0;
                REQUIRE(open >= 0);
            }
            CHECK(open == 0);
        }
    }
}

TEST_CASE("A row of 2^k is k names long") {
    BracketedString string{.atoms = {"abcdefgh"}};
    string.whole.assign(1024, 0);
    std::size_t length = 0;
    for (const NamedPart& part : named_parts(string, "ABCDEFGHIJKLMNS")) length += part.text.size();
    CHECK(length < 60);
}
