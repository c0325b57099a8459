#include "cli/manual_page.h"

#include <algorithm>

namespace rinceau {
namespace {

/// Text for roff: its own characters are escaped, hyphens are those of the command line.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '\\':
                result += "\\e";
                break;
            case '-':
                result += "\\-";
                break;
            case '\'':
                result += "\\(aq";
                break;
            case '^':
                result += "\\(ha";
                break;
            case '~':
                result += "\\(ti";
                break;
            case '`':
                result += "\\(ga";
                break;
            case '.':
                // at the start of a line it would be a request
                result += result.empty() || result.back() == '\n' ? "\\&." : ".";
                break;
            default:
                result += c;
        }
    }
    return result;
}

std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + escaped(text) + "\\fR"; }

std::string upper(std::string text) {
    std::ranges::transform(text, text.begin(), [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return text;
}

/// A sentence; help texts have no full stop.
std::string sentence(const std::string& text) {
    const bool ended = text.empty() || text.back() == '.' || text.back() == '\n';
    return escaped(text) + (ended ? "" : ".");
}

/// Lines as they are: examples and tables.
std::string display(const std::string& text) { return ".PP\n.nf\n" + escaped(text) + "\n.fi\n"; }

std::string argument_entry(const ArgumentDescription& argument) {
    std::string text = ".TP\n";
    const bool option = argument.names.front().starts_with('-');
    for (const std::string& name : argument.names)
        text += (&name == &argument.names.front() ? "" : ", ") + (option ? bold(name) : italic(name));
    if (option && !argument.value.empty()) text += " " + italic(argument.value);
    text += "\n" + sentence(argument.help);
    if (option && argument.required) text += " Required.";
    if (!argument.default_value.empty()) text += " Default: " + escaped(argument.default_value) + ".";
    if (!argument.choices.empty() && argument.value.find('|') == std::string::npos) {
        text += " One of";
        for (const std::string& choice : argument.choices)
            text += (&choice == &argument.choices.front() ? " " : ", ") + bold(choice);
        text += ".";
    }
    return text + "\n";
}

std::string synopsis(const ProgramDescription& program, const VerbDescription& verb) {
    std::string text = bold(program.name) + " " + bold(verb.name);
    for (const ArgumentDescription& argument : verb.positionals) {
        const std::string name = italic(argument.names.front()) + (argument.repeated ? " ..." : "");
        text += " " + (argument.required ? name : "[" + name + "]");
    }
    for (const ArgumentDescription& argument : verb.options)
        if (argument.required) text += " " + bold(argument.names.front()) + " " + italic(argument.value);
    return text + " [" + italic("options") + "]";
}

std::string verb_section(const ProgramDescription& program, const VerbDescription& verb) {
    std::string text = ".SS " + escaped(verb.name) + "\n" + synopsis(program, verb) + "\n.PP\n" + sentence(verb.help) + "\n";
    for (const ArgumentDescription& argument : verb.positionals) text += argument_entry(argument);
    for (const ArgumentDescription& argument : verb.options) text += argument_entry(argument);
    return text + display(verb.footer);
}

}  // namespace

std::string manual_page(const ProgramDescription& program, const std::string& version) {
    std::string text = ".TH " + upper(program.name) + " 1 \"\" \"" + escaped(program.name + " " + version) + "\" \"User Commands\"\n";
    text += ".SH NAME\n" + escaped(program.name) + " \\- " + "inverse procedural modelling of vector art\n";
    text += ".SH SYNOPSIS\n";
    for (const VerbDescription& verb : program.verbs) text += synopsis(program, verb) + "\n.br\n";
    text += bold(program.name) + " [" + italic("options") + "]\n";
    text += ".SH DESCRIPTION\n" + escaped(program.help) +
            "\n.PP\nA file name of \\- is standard input, or standard output; results go to standard output where no file is "
            "named, everything else to standard error.\n";
    text += ".SH OPTIONS\n";
    for (const ArgumentDescription& argument : program.options) text += argument_entry(argument);
    text += ".SH VERBS\n";
    for (const VerbDescription& verb : program.verbs) text += verb_section(program, verb);
    text += ".SH NOTES\n" + display(program.footer).substr(4);
    return text;
}

}  // namespace rinceau
