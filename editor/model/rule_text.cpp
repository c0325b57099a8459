#include "editor/model/rule_text.h"

#include <algorithm>

#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"

namespace rinceau {

namespace {

/// What a picture may need before the text says that it is large.
constexpr std::uint64_t most_modules = 5'000'000;
constexpr double most_seconds = 3;

GrammarLoader loader_of(const Document& document) {
    return [used = document.used](const std::string& name) -> std::string {
        const auto file = used ? used->find(name) : UsedFiles::const_iterator{};
        if (used && file != used->end()) return file->second;
        throw InputError({name},
                         "expected a file that was used when the grammar was opened: save the text and open it again");
    };
}

void describe_picture(const std::string& text, const std::string& file, const Document& document, const Progress& progress,
                      TextFindings& findings) {
    std::size_t elements = 0;
    try {
        const Document next = with_grammar(document, parse_grammar(text, file));
        DeriveOptions derive = next.derive;
        derive.max_modules = most_modules;
        derive.max_seconds = most_seconds;
        visit_placements(
            *next.resolved, {.derive = derive}, [&](const Placement&) { ++elements; }, progress);
    } catch (const InputError& error) {
        findings.picture = std::string("It cannot be drawn: ") + error.what();
        return;
    } catch (const LimitError& error) {
        findings.picture = std::string("It is very large: ") + error.what();
        return;
    }
    findings.drawn = elements > 0;
    findings.picture = elements == 0   ? "It draws nothing"
                       : elements == 1 ? "It draws 1 element"
                                       : "It draws " + std::to_string(elements) + " elements";
}

}  // namespace

TextFindings check_rule_text(const std::string& text, const std::string& file, const Document& document,
                             const Progress& progress) {
    GrammarFindings found = inspect_grammar(text, file, loader_of(document));
    TextFindings findings{std::move(found.mistakes), std::move(found.hints), {}, false};
    if (findings.mistakes.empty()) describe_picture(text, file, document, progress, findings);
    return findings;
}

RuleText rule_text_of(const Document& document, std::uint64_t revision) {
    RuleText result;
    result.text = to_text(*document.grammar);
    result.grammar = document.grammar;
    if (!document.grammar->uses.empty()) result.file = document.grammar->uses.front().place.file;
    result.revision = result.checked = revision;
    return result;
}

std::size_t offset_of_place(const std::string& text, int line, int column) {
    std::size_t offset = 0;
    for (int i = 1; i < line; ++i) {
        const std::size_t end = text.find('\n', offset);
        if (end == std::string::npos) return text.size();
        offset = end + 1;
    }
    const std::size_t end = std::min(text.find('\n', offset), text.size());
    return std::min(offset + static_cast<std::size_t>(std::max(column - 1, 0)), end);
}

}  // namespace rinceau
