#pragma once
// The tools.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/model/tool_edit.h"

namespace rinceau {

enum class ToolSection : unsigned char { none, randomize, symmetrize, replace };

struct ReplaceSettings {
    std::string symbol;  ///< empty = the first terminal
    std::string with;    ///< as files/replacement_text.h
    ReplaceFit fit = ReplaceFit::inside;
    double turn = 0;  ///< degrees counter-clockwise
    bool restyle = false;
};

/// What is set in the tools before they are used.
struct ToolSettings {
    RandomizeOptions noise;  ///< what was touched; the rest is as the grammar has it
    SymmetrizeOptions symmetrize;
    ReplaceSettings replace;
};

/// An edit that is asked for.
struct ToolRun {
    std::shared_ptr<const ToolEdit> edit;
    bool preview = false;
};

struct ToolsState {
    ToolSection open = ToolSection::none;  ///< is to be brought to the eye
    ToolSettings settings;

    std::uint64_t job = 0;                ///< number of the last one that was started
    std::optional<ToolRun> running;       ///< its edit
    bool dropped = false;                 ///< what runs is not wanted any more
    std::optional<ToolRun> waiting;       ///< asked for meanwhile
    std::shared_ptr<const Grammar> base;  ///< that is edited
    std::uint64_t revision = 0;           ///< of what was shown when it was started

    std::shared_ptr<const Grammar> previewed;  ///< the result of a tool that was shown last
    std::shared_ptr<const ToolEdit> edit;      ///< which made it
    std::vector<std::string> changes;          ///< what is different in it
    std::string mistake;                       ///< why there is no preview; empty = nothing is wrong

    std::optional<bool> reading;              ///< a replacement is read, to be previewed (true) or recorded
    std::shared_ptr<const Replacement> read;  ///< the last one that was read
    std::string read_with;                    ///< what it was called
};

}  // namespace rinceau
