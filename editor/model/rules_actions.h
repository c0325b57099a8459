#pragma once
// Rules: their numbers, their text, their order; undo. Every edit can be undone.

#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "editor/model/rule_text.h"
#include "lsystem/edit_productions.h"

namespace rinceau {

/// A number of lsystem/numbers.h gets a value. While it is dragged it is previewed, in the steps of its NumberFeel; the last
/// preview is recorded by CommitPreview.
struct SetNumber {
    std::string name;
    double value = 0;
    bool preview = false;
};
/// What is typed into a number's field: begins or goes on. "80*1.5", "+=2", "150%", "bay/2".
struct TypeNumber {
    std::string name;
    std::string text;
};
/// The typed text becomes the number; a mistake is told and the text stays.
struct EnterTyped {};
struct StopTyping {};
/// The number gets the value that it had when the grammar was opened or last analysed.
struct ResetNumber {
    std::string name;
};
/// Edits leave a locked number alone.
struct LockNumber {
    std::string name;
    bool locked = true;
};
/// Only numbers and rules whose names hold the text are listed.
struct FilterRules {
    std::string text;
};
/// Lists details, too: conditions, opacities that are 1, the canvas.
struct ShowRuleDetails {
    bool shown = true;
};
/// What is previewed becomes an edit, or is dropped. After a drop the drag that goes on previews nothing until it ends.
struct CommitPreview {};
struct DropPreview {};
struct UndoEdit {};
struct RedoEdit {};
/// So many edits back (below 0) or forth.
struct GoInHistory {
    int steps = 0;
};

/// How many steps are derived: all for -1.
struct SetDepth {
    int depth = -1;
    bool preview = false;
};
/// Of the grammar: what is random in it.
struct SetSeed {
    std::uint64_t seed = 1;
};
/// The deepest derivation of this grammar, as ready for drawing; -1 = it is not known.
struct DepthMeasured {
    std::shared_ptr<const Grammar> grammar;
    int depth = -1;
};

struct AddProduction {
    AddProductionOptions options;
};
/// If it is used elsewhere the user is asked whether its uses go, too; `uses` = they do.
struct RemoveProduction {
    int production = 0;
    bool uses = false;
};
struct KeepProduction {};  ///< the answer to that: no
struct MoveProduction {
    int production = 0;
    int to = 0;  ///< its index afterwards
};
struct RenameSymbol {
    std::string from;
    std::string to;
};
struct CommentProduction {
    int production = 0;
    std::string comment;
};

/// What is written into a card's field: begins or goes on.
enum class CardField : unsigned char { name, comment };
struct WriteCard {
    CardField field = CardField::name;
    int production = 0;
    std::string text;
};
struct EnterCard {};  ///< renames the symbol, or sets the comment; a mistake is told and the text stays
struct StopCard {};

enum class RulesView : unsigned char { rules, text };
struct ShowRules {
    RulesView view = RulesView::rules;
};
/// The text is another one. It is checked in the background.
struct WriteText {
    std::string text;
};
struct TextChecked {
    std::uint64_t revision = 0;
    TextFindings findings;
};
/// The text becomes the document's grammar, or its first mistake is told.
struct ApplyText {};
/// The text is that of the document's grammar again.
struct RevertText {};
/// The line is marked and the cursor goes there; then it is there.
struct ShowTextPlace {
    int line = 0;
    int column = 0;
};
struct TextPlaceShown {};

struct RulesAction : std::variant<SetNumber, TypeNumber, EnterTyped, StopTyping, ResetNumber, LockNumber, FilterRules,
                                  ShowRuleDetails, CommitPreview, DropPreview, UndoEdit, RedoEdit, GoInHistory, SetDepth,
                                  SetSeed, DepthMeasured, AddProduction, RemoveProduction, KeepProduction, MoveProduction,
                                  RenameSymbol, CommentProduction, WriteCard, EnterCard, StopCard, ShowRules, WriteText,
                                  TextChecked, ApplyText, RevertText, ShowTextPlace, TextPlaceShown> {
    using variant::variant;
    RulesAction(const RulesAction&);
    RulesAction(RulesAction&&) noexcept;
    RulesAction& operator=(const RulesAction&);
    RulesAction& operator=(RulesAction&&) noexcept;
    ~RulesAction();
};

}  // namespace rinceau
