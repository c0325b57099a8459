#pragma once
// Tools that change the whole grammar or what a symbol stands for. Every edit can be undone.

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "editor/model/tool_edit.h"
#include "editor/model/tools_state.h"

namespace rinceau {

/// Opens the tool in its panel.
struct OpenTool {
    ToolSection section = ToolSection::none;
};
/// What is set in the tools; nothing is edited.
struct SetTools {
    ToolSettings settings;
};
/// Other noise is set, and shown as a preview if there is any.
struct SetNoise {
    RandomizeOptions noise;  ///< ToolSettings::noise
};
/// The same with the next seed.
struct NewSeed {};
/// The edit is made: recorded, or shown as a preview. Both may take a while; the newest that was asked for counts.
struct UseTool {
    std::shared_ptr<const ToolEdit> edit;
    bool preview = false;
};
/// Replaces what ToolSettings::replace says, after it was read.
struct UseReplace {
    bool preview = false;
};
/// The preview of a tool becomes an edit.
struct KeepTool {};

// Answers.

struct ToolDone {
    std::uint64_t job = 0;
    ToolResult result;
};
struct ToolFailed {
    std::uint64_t job = 0;
    std::string message;
};
struct ReplacementRead {
    std::string with;
    std::shared_ptr<const Replacement> replacement;
    std::vector<std::string> warnings;
};
struct ReplacementFailed {
    std::string with;
    std::string message;
};

struct ToolsAction : std::variant<OpenTool, SetTools, SetNoise, NewSeed, UseTool, UseReplace, KeepTool, ToolDone, ToolFailed,
                                  ReplacementRead, ReplacementFailed> {
    using variant::variant;
    ToolsAction(const ToolsAction&);
    ToolsAction(ToolsAction&&) noexcept;
    ToolsAction& operator=(const ToolsAction&);
    ToolsAction& operator=(ToolsAction&&) noexcept;
    ~ToolsAction();
};

}  // namespace rinceau
