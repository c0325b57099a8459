#include "lsystem/check_edit.h"

#include <algorithm>

#include "lsystem/compile.h"
#include "lsystem/derivation_limits.h"
#include "lsystem/interpret.h"
#include "lsystem/stream.h"

namespace rinceau {

namespace {

struct ExceptionWatch {
    std::vector<bool> met;
    void command(const CompiledModule&, std::span<const double>) {}
    void leaf(const CompiledModule&, std::span<const double>, const StreamPlace&) {}
    void exception(int index) { met[static_cast<std::size_t>(index)] = true; }
};

/// By exception: does something stand at its address? `grammar` is ready for drawing.
std::vector<bool> exceptions_met(const Grammar& grammar, const DeriveOptions& options, const Progress& progress) {
    ExceptionWatch watch{std::vector<bool>(grammar.exceptions.size())};
    if (grammar.exceptions.empty()) return watch.met;
    const CompiledGrammar compiled = compile(grammar);
    stream_modules(compiled, options, progress, true, watch);
    return watch.met;
}

std::size_t elements_drawn(const Grammar& grammar, const DeriveOptions& options, const Progress& progress) {
    std::size_t count = 0;
    visit_placements(
        grammar, {.derive = options}, [&](const Placement&) { ++count; }, progress);
    return count;
}

std::string address_text(const std::vector<int>& address) {
    std::string text;
    for (const int number : address) text += (text.empty() ? "" : ".") + std::to_string(number);
    return text;
}

/// "2 exceptions dropped (1.11, 1.12): nothing stands there now".
std::string dropped_text(const std::vector<std::string>& addresses) {
    constexpr std::size_t most_named = 8;
    std::string text =
        std::to_string(addresses.size()) + (addresses.size() == 1 ? " exception" : " exceptions") + " dropped (";
    for (std::size_t i = 0; i < std::min(addresses.size(), most_named); ++i) text += (i > 0 ? ", " : "") + addresses[i];
    if (addresses.size() > most_named) text += ", ..";
    return text + "): nothing stands there now";
}

/// An exception of `before` is known again by its address.
void drop_exceptions(const Grammar& before, EditResult& edit, const CheckEditOptions& options, const Progress& progress) {
    if (edit.grammar.exceptions.empty()) return;
    const std::vector<bool> met = exceptions_met(options.for_drawing(edit.grammar), options.derive, progress);
    std::vector<bool> met_before;
    std::vector<std::string> dropped;
    std::vector<Exception> kept;
    for (std::size_t i = 0; i < edit.grammar.exceptions.size(); ++i) {
        const Exception& exception = edit.grammar.exceptions[i];
        bool lost = !met[i];
        if (lost) {
            if (met_before.empty()) met_before = exceptions_met(options.for_drawing(before), options.derive, progress);
            lost = false;
            for (std::size_t k = 0; k < before.exceptions.size(); ++k)
                lost = lost || (before.exceptions[k].address == exception.address && met_before[k]);
        }
        if (lost) {
            dropped.push_back(address_text(exception.address));
        } else {
            kept.push_back(exception);
        }
    }
    if (dropped.empty()) return;
    edit.grammar.exceptions = std::move(kept);
    edit.changes.push_back(dropped_text(dropped));
}

void expect_drawn(const Grammar& before, EditResult& edit, const CheckEditOptions& options, const Progress& progress) {
    const std::size_t elements = elements_drawn(options.for_drawing(edit.grammar), options.derive, progress);
    std::size_t elements_before = 0;
    try {
        elements_before = elements_drawn(options.for_drawing(before), options.derive, progress);
    } catch (const TooManyModules&) {
        return;  // it has become smaller
    } catch (const std::runtime_error&) {
        // what could not be drawn may be mended
    }
    if (elements == 0 && elements_before > 0)
        throw InputError({}, "expected an edit that leaves something to draw, found one after which nothing is drawn");
    if (elements != elements_before)
        edit.changes.push_back(std::to_string(elements_before) + " -> " + std::to_string(elements) + " elements");
}

}  // namespace

EditResult checked_edit(const Grammar& before, EditResult edit, const CheckEditOptions& given, const Progress& progress) {
    CheckEditOptions options = given;
    const bool bounded = options.unchecked_above > 0 && options.unchecked_above < options.derive.max_modules;
    if (bounded) options.derive.max_modules = options.unchecked_above;
    try {
        EditResult checked = edit;
        drop_exceptions(before, checked, options, progress);
        expect_drawn(before, checked, options, progress);
        return checked;
    } catch (const TooManyModules&) {
        if (!bounded) throw;
        return edit;
    }
}

}  // namespace rinceau
