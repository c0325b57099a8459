#pragma once
// The command line as data, read off the parser's own definitions: what the manual page and the shells are told.

#include <string>
#include <vector>

#include <CLI/App.hpp>

namespace rinceau {

struct ArgumentDescription {
    std::vector<std::string> names;  ///< "-o", "--output"; of a positional argument its only name, "RULES"
    std::string value;               ///< what stands for its value in help: "FILE"; empty for a flag
    std::string help;
    std::string default_value;
    std::vector<std::string> choices;  ///< the words that it takes; empty = others too
    std::vector<std::string> endings;  ///< of the files that it takes, ".lsys", as its help names them
    bool is_file = false;
    bool required = false;
    bool repeated = false;  ///< may be given more than once
};

struct VerbDescription {
    std::string name;
    std::string help;
    std::string footer;  ///< with an example
    std::vector<ArgumentDescription> positionals;
    std::vector<ArgumentDescription> options;
};

struct ProgramDescription {
    std::string name;
    std::string help;
    std::string footer;
    std::vector<ArgumentDescription> options;
    std::vector<VerbDescription> verbs;  ///< in the order in which they are listed
};

/// What `program` shows in its help; what is hidden there is left out. A value is a list of choices if it is written "a|b" or
/// its check names them "{a,b}"; it is a file if it is called FILE, or if the help names endings of files.
ProgramDescription describe_program(const CLI::App& program);

}  // namespace rinceau
