// Bash: one function that looks at the words so far, and tables of what the verbs take.

#include "cli/completion.h"

namespace rinceau {
namespace {

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
    return text;
}

/// Options that are followed by a value.
std::string names_with_value(const std::vector<ArgumentDescription>& options) {
    std::vector<std::string> names;
    for (const ArgumentDescription& option : options)
        if (!option.value.empty()) names.insert(names.end(), option.names.begin(), option.names.end());
    return joined(names, " ");
}

std::string all_names(const std::vector<ArgumentDescription>& options) {
    std::vector<std::string> names;
    for (const ArgumentDescription& option : options) names.insert(names.end(), option.names.begin(), option.names.end());
    return joined(names, " ");
}

/// The command that offers an argument's values.
std::string offer(const ArgumentDescription& argument) {
    if (!argument.choices.empty()) return "_rinceau_words '" + joined(argument.choices, " ") + "'";
    if (argument.is_file) return joined({"_rinceau_files", joined(argument.endings, " ")}, " ");
    return "COMPREPLY=()";
}

std::string value_cases(const VerbDescription& verb) {
    std::string text;
    for (const ArgumentDescription& option : verb.options) {
        if (option.value.empty()) continue;
        std::vector<std::string> patterns;
        for (const std::string& name : option.names) patterns.push_back(verb.name + ":" + name);
        text += "        " + joined(patterns, "|") + ") " + offer(option) + "; return ;;\n";
    }
    return text;
}

std::string place_cases(const VerbDescription& verb) {
    std::string text;
    for (std::size_t i = 0; i < verb.positionals.size(); ++i) {
        const std::string place = verb.positionals[i].repeated ? "*" : std::to_string(i);
        text += "        " + verb.name + ":" + place + ") " + offer(verb.positionals[i]) + " ;;\n";
    }
    return text;
}

constexpr const char* functions = R"(_rinceau_words() {
    mapfile -t COMPREPLY < <(compgen -W "$1" -- "$cur")
}

# Folders, and the files with one of these endings.
_rinceau_files() {
    local ending
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <({
        compgen -d -- "$cur"
        [ $# -gt 0 ] || compgen -f -- "$cur"
        for ending in "$@"; do compgen -f -X "!*$ending" -- "$cur"; done
    } | sort -u)
}

)";

constexpr const char* walk = R"(    local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} verb='' word i
    local -i place=0
    local with_value='' options=''
    # --option=value comes as three words
    if [[ $cur == = ]]; then
        cur=''
    elif [[ $prev == = ]]; then
        prev=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    for ((i = 1; i < COMP_CWORD; i++)); do
        word=${COMP_WORDS[i]}
        if [[ $word == = ]]; then
            ((i++))
        elif [[ $word == -?* ]]; then
            [[ " $with_value " == *" $word "* && ${COMP_WORDS[i + 1]} != = ]] && ((i++))
        elif [[ -z $verb ]]; then
            verb=$word
            _rinceau_verb
        else
            place+=1
        fi
    done
)";

}  // namespace

std::string bash_completion(const ProgramDescription& program) {
    std::vector<std::string> verbs;
    std::string tables, values, places;
    for (const VerbDescription& verb : program.verbs) {
        verbs.push_back(verb.name);
        tables += "        " + verb.name + ") with_value='" + names_with_value(verb.options) + "' options='" +
                  all_names(verb.options) + "' ;;\n";
        values += value_cases(verb);
        places += place_cases(verb);
    }
    return "# bash completion for " + program.name + "\n\n" + functions +
           "# What a verb takes.\n_rinceau_verb() {\n    case $verb in\n" + tables + "    esac\n}\n\n_rinceau() {\n" + walk +
           "    case $verb:$prev in\n" + values + "    esac\n    if [[ -z $verb ]]; then\n        _rinceau_words '" +
           joined(verbs, " ") + " " + all_names(program.options) +
           "'\n        return\n    fi\n    if [[ $cur == -?* || $cur == - ]]; then\n        _rinceau_words \"$options\"\n"
           "        return\n    fi\n    case $verb:$place in\n" +
           places + "    esac\n}\n\ncomplete -F _rinceau " + program.name + "\n";
}

}  // namespace rinceau
