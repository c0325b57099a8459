// Zsh: _arguments with a specification per option and argument.

#include "cli/completion.h"

namespace rinceau {
namespace {

/// Inside single quotes, with the characters escaped that mean something in a specification.
std::string specified(const std::string& text, const std::string& special) {
    std::string result;
    for (const char c : text) {
        if (special.find(c) != std::string::npos) result += '\\';
        if (c == '\'')
            result += "'\\''";
        else
            result += c;
    }
    return result;
}

std::string action_of(const ArgumentDescription& argument) {
    std::string text;
    if (!argument.choices.empty()) {
        for (const std::string& choice : argument.choices) text += (text.empty() ? "" : " ") + choice;
        return "(" + text + ")";
    }
    if (!argument.is_file) return " ";
    for (const std::string& ending : argument.endings) text += (text.empty() ? "" : "|") + ending;
    return text.empty() ? "_files" : "_files -g \"*(" + text + ")\"";
}

std::string option_specification(const ArgumentDescription& option) {
    const std::string value =
        option.value.empty() ? "" : ":" + specified(option.value, ":\\") + ":" + action_of(option);
    const std::string rest = "[" + specified(option.help, "[]:\\") + "]" + value + "'";
    if (option.names.size() == 1)
        return (option.repeated ? "'*" : "'") + option.names.front() + rest;
    std::string all, list;
    for (const std::string& name : option.names) {
        all += (all.empty() ? "" : " ") + name;
        list += (list.empty() ? "" : ",") + name;
    }
    return (option.repeated ? "'*'" : "'(" + all + ")'") + ("{" + list + "}'") + rest;
}

std::string positional_specification(const ArgumentDescription& argument, std::size_t place) {
    return "'" + (argument.repeated ? "*" : std::to_string(place + 1)) + ":" + specified(argument.names.front(), ":\\") + ":" +
           action_of(argument) + "'";
}

}  // namespace

std::string zsh_completion(const ProgramDescription& program) {
    std::string verbs, cases;
    for (const VerbDescription& verb : program.verbs) {
        verbs += "    '" + verb.name + ":" + specified(verb.help, ":\\") + "'\n";
        cases += "    " + verb.name + ")\n      _arguments";
        for (const ArgumentDescription& option : verb.options) cases += " \\\n        " + option_specification(option);
        for (std::size_t i = 0; i < verb.positionals.size(); ++i)
            cases += " \\\n        " + positional_specification(verb.positionals[i], i);
        cases += "\n      ;;\n";
    }
    std::string options;
    for (const ArgumentDescription& option : program.options) options += " \\\n      " + option_specification(option);
    return "#compdef " + program.name + "\n# zsh completion for " + program.name + "\n\n_rinceau() {\n  local -a verbs\n  verbs=(\n" +
           verbs +
           "  )\n  if (( CURRENT == 2 )); then\n    _describe -t verbs verb verbs\n    _arguments" + options +
           "\n    return\n  fi\n  # the verb is the command for what follows\n  shift words\n  (( CURRENT-- ))\n"
           "  case ${words[1]} in\n" +
           cases + "  esac\n}\n\n_rinceau \"$@\"\n";
}

}  // namespace rinceau
