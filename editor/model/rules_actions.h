#pragma once
// Rules: their numbers, their text, their order; undo. Every edit can be undone.

#include <string>
#include <variant>

namespace rinceau {

/// A number of lsystem/numbers.h gets a value. While it is dragged it is previewed; the last one is recorded.
struct SetNumber {
    std::string name;
    double value = 0;
    bool preview = false;
};
/// What is previewed becomes an edit of that name, or is dropped.
struct CommitPreview {};
struct DropPreview {};
struct UndoEdit {};
struct RedoEdit {};

using RulesAction = std::variant<SetNumber, CommitPreview, DropPreview, UndoEdit, RedoEdit>;

}  // namespace rinceau
