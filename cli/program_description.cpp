#include "cli/program_description.h"

#include <algorithm>
#include <cctype>

namespace rinceau {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find(separator, at), text.size());
        parts.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return parts;
}

std::vector<std::string> choices_of(const std::string& type) {
    const std::size_t open = type.find('{'), close = type.find('}');
    if (open != std::string::npos && close != std::string::npos && open < close)
        return split(type.substr(open + 1, close - open - 1), ',');
    return type.find('|') == std::string::npos ? std::vector<std::string>{} : split(type, '|');
}

/// ".svg, .png or .pdf": a point and letters, not inside a word.
std::vector<std::string> endings_of(const std::string& help) {
    const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
    std::vector<std::string> endings;
    for (std::size_t at = help.find('.'); at != std::string::npos; at = help.find('.', at + 1)) {
        if (at > 0 && help[at - 1] != ' ' && help[at - 1] != '(') continue;
        std::size_t end = at + 1;
        while (end < help.size() && is_letter(help[end])) ++end;
        const std::string ending = help.substr(at, end - at);
        if (ending.size() > 1 && std::ranges::find(endings, ending) == endings.end()) endings.push_back(ending);
    }
    return endings;
}

ArgumentDescription describe_argument(const CLI::Option& option) {
    ArgumentDescription argument;
    argument.help = option.get_description();
    argument.required = option.get_required();
    argument.repeated = option.get_items_expected_max() > 1;
    for (const std::string& name : option.get_snames()) argument.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) argument.names.push_back("--" + name);
    const bool positional = argument.names.empty();
    if (positional) argument.names = {option.get_single_name()};
    if (!positional && option.get_items_expected_max() == 0) return argument;

    const std::string type = option.get_type_name();
    argument.value = type.substr(0, type.find(':'));
    argument.default_value = option.get_default_str();
    argument.choices = choices_of(type);
    argument.endings = endings_of(argument.help);
    argument.is_file = argument.value == "FILE" || !argument.endings.empty();
    return argument;
}

bool is_shown(const CLI::Option& option) { return !option.get_group().empty(); }

VerbDescription describe_verb(const CLI::App& verb) {
    VerbDescription description{verb.get_name(), verb.get_description(), verb.get_footer(), {}, {}};
    for (const CLI::Option* option : verb.get_options()) {
        if (!is_shown(*option)) continue;
        (option->get_positional() ? description.positionals : description.options).push_back(describe_argument(*option));
    }
    return description;
}

}  // namespace

ProgramDescription describe_program(const CLI::App& program) {
    ProgramDescription description{program.get_name(), program.get_description(), program.get_footer(), {}, {}};
    for (const CLI::Option* option : program.get_options())
        if (is_shown(*option)) description.options.push_back(describe_argument(*option));
    for (const CLI::App* verb : program.get_subcommands([](const CLI::App* each) { return !each->get_group().empty(); }))
        description.verbs.push_back(describe_verb(*verb));
    return description;
}

}  // namespace rinceau
