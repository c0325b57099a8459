#pragma once
// What the parts of the panel of growth share. Internal to the folder.

#include <string>
#include <vector>

#include "editor/panels/panel.h"

namespace rinceau {

/// The settings as widgets leave them. Places: "growth/NAME".
class GrowthForm {
  public:
    GrowthForm(const EditorState& state, const PanelTools& tools)
        : settings(state.growth.settings), surface(state.surface.settings), state_(state), tools_(tools) {}

    GrowthSettings settings;
    SurfaceSettings surface;
    Actions actions;

    const EditorState& state() const { return state_; }
    const PanelTools& tools() const { return tools_; }

    /// Each shows the value and changes it; `help` is its tooltip.
    void number(const char* label, double& value, double low, double high, float step, const char* format, const char* help);
    void whole(const char* label, int& value, int low, int high, const char* help);
    void count(const char* label, std::size_t& value, std::size_t low, std::size_t high, const char* help);
    void seed(std::uint64_t& value);
    void check(const char* label, bool& value, const char* help);
    void text(const char* label, std::string& value, const char* help);
    /// A file's name with a button; true when that, or Enter, is pressed.
    bool file(const char* label, std::string& value, const char* button, const char* help);
    /// `value` is an index into the labels.
    void choice(const char* label, int& value, const std::vector<const char*>& labels, const char* help);
    /// A command of the table as a button.
    void command(const char* name);
    /// What was changed otherwise.
    void change() { changed_ = true; }

    /// The actions, and the settings if they were changed.
    Actions done();

  private:
    void look(const char* label, bool changed, const char* help);

    const EditorState& state_;
    const PanelTools& tools_;
    bool changed_ = false;
};

// The tabs, each in the file of its name.
void growth_arrangement(GrowthForm& form);
void growth_aggregate(GrowthForm& form);
void growth_surface(GrowthForm& form);

}  // namespace rinceau
