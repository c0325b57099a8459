#include "editor/model/update.h"

#include <catch2/catch.hpp>

#include "editor/effects/read_document.h"
#include "lsystem/numbers.h"

using namespace rinceau;

namespace {

EditorState opened(const std::string& sample) {
    const std::string path = std::string(RINCEAU_SOURCE_DIR "/samples/") + sample;
    EditorState state = update(initial_state(), FileAction{OpenFile{path}}).state;
    return update(state, FileAction{read_document(path)}).state;
}

double value_of(const EditorState& state, const std::string& name) {
    for (const GrammarNumber& number : grammar_numbers(*shown_document(state).grammar))
        if (number.name == name) return number.value;
    FAIL("there is no number " << name);
    return 0;
}

std::string first_count(const EditorState& state) {
    for (const GrammarNumber& number : grammar_numbers(*state.document.grammar))
        if (number.kind == NumberKind::count) return number.name;
    return {};
}

}  // namespace

TEST_CASE("setting a number is undone and redone to identical documents") {
    const EditorState before = opened("facade.lsys");
    const std::string name = first_count(before);
    const EditorState after = update(before, RulesAction{SetNumber{name, value_of(before, name) + 2}}).state;
    CHECK(value_of(after, name) == value_of(before, name) + 2);
    const EditorState back = update(after, RulesAction{UndoEdit{}}).state;
    CHECK(same_document(back.document, before.document));
    const EditorState again = update(back, RulesAction{RedoEdit{}}).state;
    CHECK(same_document(again.document, after.document));
}
