// What the analysis finds, beside what a person would write, and how long it takes.

#include <charconv>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>

#include "tables.h"

using namespace rinceau::test;

namespace {

constexpr const char* usage =
    "usage: analyze_bench [--largest ELEMENTS] [--only NAME] [--seeds COUNT] [--corpus FOLDER]\n"
    "                     [--objective bits|paper|both]\n"
    "Without --corpus: every drawing with known rules, expected rules/axiom symbols beside those found.\n"
    "--corpus: every .svg of the folder. --objective both: rules and bits of both, side by side.\n";

struct Arguments {
    SceneTableOptions scenes;
    std::string corpus;
};

template <class Number>
bool read_number(std::string_view text, Number& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size() && number > 0;
}

bool read_option(std::string_view name, std::string_view value, Arguments& arguments) {
    if (name == "--largest") return read_number(value, arguments.scenes.largest);
    if (name == "--seeds") return read_number(value, arguments.scenes.seeds);
    if (name == "--only") return arguments.scenes.only = value, true;
    if (name == "--objective") {
        arguments.scenes.objective = value == "paper" ? rinceau::Objective::paper : rinceau::Objective::bits;
        arguments.scenes.both = value == "both";
        return value == "bits" || value == "paper" || value == "both";
    }
    if (name == "--corpus") return arguments.corpus = value, true;
    return false;
}

bool read_arguments(std::span<char*> words, Arguments& arguments) {
    if (words.size() % 2 != 0) return false;
    for (std::size_t k = 0; k < words.size(); k += 2) {
        if (!read_option(words[k], words[k + 1], arguments)) return false;
    }
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    if (!read_arguments({argv + 1, static_cast<std::size_t>(argc - 1)}, arguments)) {
        std::fputs(usage, stderr);
        return 2;
    }
    if (arguments.corpus.empty()) {
        print_scene_table(arguments.scenes);
        return 0;
    }
    if (print_drawing_table(arguments.corpus, arguments.scenes.objective, arguments.scenes.both)) return 0;
    std::fprintf(stderr, "%s: no .svg in it\n", arguments.corpus.c_str());
    return 1;
}
