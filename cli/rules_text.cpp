#include "cli/rules_text.h"

#include <array>
#include <charconv>
#include <cmath>

#include "lsystem/grammar_text.h"

namespace rinceau {
namespace {

// More than a person reads.
constexpr std::size_t longest_axiom = 200;  // modules

std::string count(int number, const std::string& singular, const std::string& plural) {
    return std::to_string(number) + " " + (number == 1 ? singular : plural);
}

std::string short_number(double value) {
    constexpr int digits = 3;
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits).ptr;
    return {text.data(), end};
}

std::string terminal_line(const TerminalReport& terminal) {
    std::string line = terminal.symbol + ": " + count(terminal.instances, "copy", "copies");
    if (terminal.mirrored > 0) line += ", " + std::to_string(terminal.mirrored) + " of them mirrored";
    return line;
}

}  // namespace

std::string summary_line(const AnalysisReport& report) {
    const auto bits = [](double value) { return std::to_string(std::llround(value)); };
    const std::string moved = report.symmetrized ? "regular layout" : report.stochastic ? "a relative of the drawing" : "";
    std::string line = count(report.elements, "element", "elements") + ", " +
                       count(static_cast<int>(report.terminals.size()), "terminal", "terminals") + ", " +
                       count(static_cast<int>(report.productions.size()), "rule", "rules") + "; " +
                       bits(report.grammar_bits) + " bits instead of " + bits(report.drawing_bits) +
                       (moved.empty() ? "; largest deviation "
                                      : "; " + moved + ", elements moved by " + short_number(report.check.rms_deviation) +
                                            " (root mean square) and at most ") +
                       short_number(report.check.max_deviation) + " of the diagonal";
    if (report.objective == Objective::paper) line += "; rules in the order of the paper's importance function";
    if (report.verbatim > 0) line += "; " + count(report.verbatim, "element", "elements") + " kept verbatim";
    return line;
}

std::string rules_text(const Analysis& analysis) {
    Grammar shown = analysis.grammar;
    shown.comments = {summary_line(analysis.report)};
    for (const TerminalReport& terminal : analysis.report.terminals) shown.comments.push_back(terminal_line(terminal));
    if (!shown.exceptions.empty())
        shown.comments.push_back(count(static_cast<int>(shown.exceptions.size()), "exception", "exceptions") +
                                 ", not shown");
    if (shown.axiom.size() > longest_axiom) {
        shown.comments.push_back("the axiom has " + std::to_string(shown.axiom.size()) + " modules, of which the first " +
                                 std::to_string(longest_axiom) + " are shown");
        shown.axiom.resize(longest_axiom);
    }
    shown.exceptions.clear();
    shown.styles.clear();
    shown.terminals.clear();
    return to_text(shown);
}

}  // namespace rinceau
