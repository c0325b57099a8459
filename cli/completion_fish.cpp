// Fish: one command per verb, option and kind of file.

#include "cli/completion.h"

namespace rinceau {
namespace {

std::string fish_text(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\') result += '\\';
        result += c;
    }
    return result + "'";
}

/// The switches that offer an argument's values; one set per line.
std::vector<std::string> offers(const ArgumentDescription& argument) {
    if (!argument.choices.empty()) {
        std::string words;
        for (const std::string& choice : argument.choices) words += (words.empty() ? "" : " ") + choice;
        return {" -a " + fish_text(words)};
    }
    if (!argument.is_file) return {""};
    if (argument.endings.empty()) return {" -F"};
    std::vector<std::string> lines;
    for (const std::string& ending : argument.endings) lines.push_back(" -k -a '(__fish_complete_suffix " + ending + ")'");
    return lines;
}

std::string names_of(const ArgumentDescription& option) {
    std::string text;
    for (const std::string& name : option.names)
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    return text;
}

std::string option_lines(const std::string& start, const ArgumentDescription& option) {
    std::string text;
    const std::string described = " -d " + fish_text(option.help) + "\n";
    if (option.value.empty()) return start + names_of(option) + described;
    for (const std::string& offer : offers(option))
        text += start + names_of(option) + (offer == " -F" ? " -r" : " -x") + offer + described;
    return text;
}

}  // namespace

std::string fish_completion(const ProgramDescription& program) {
    const std::string command = "complete -c " + program.name;
    std::string text = "# fish completion for " + program.name + "\n\n" + command + " -f\n";
    for (const ArgumentDescription& option : program.options)
        text += option_lines(command + " -n __fish_use_subcommand", option);
    for (const VerbDescription& verb : program.verbs) {
        text += "\n" + command + " -n __fish_use_subcommand -a " + verb.name + " -d " + fish_text(verb.help) + "\n";
        const std::string start = command + " -n '__fish_seen_subcommand_from " + verb.name + "'";
        for (const ArgumentDescription& option : verb.options) text += option_lines(start, option);
        for (const ArgumentDescription& argument : verb.positionals)
            for (const std::string& offer : offers(argument))
                if (!offer.empty()) text += start + offer + "\n";
    }
    return text;
}

}  // namespace rinceau
