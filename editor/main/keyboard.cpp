#include "editor/main/keyboard.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <utility>

namespace rinceau {
namespace {

/// A window that a command opens takes two frames until its text field is typed in.
constexpr int frames_after_command = 2;
/// From this version on Dear ImGui has a queue of its own.
constexpr bool imgui_keeps_order = IMGUI_VERSION_NUM >= 18700;

constexpr std::array<std::pair<int, const char*>, 30> key_names{{
    {GLFW_KEY_ESCAPE, "Escape"},  {GLFW_KEY_ENTER, "Enter"},
    {GLFW_KEY_KP_ENTER, "Enter"}, {GLFW_KEY_TAB, "Tab"},
    {GLFW_KEY_SPACE, "Space"},    {GLFW_KEY_BACKSPACE, "Backspace"},
    {GLFW_KEY_INSERT, "Insert"},  {GLFW_KEY_DELETE, "Delete"},
    {GLFW_KEY_RIGHT, "Right"},    {GLFW_KEY_LEFT, "Left"},
    {GLFW_KEY_DOWN, "Down"},      {GLFW_KEY_UP, "Up"},
    {GLFW_KEY_PAGE_UP, "PageUp"}, {GLFW_KEY_PAGE_DOWN, "PageDown"},
    {GLFW_KEY_HOME, "Home"},      {GLFW_KEY_END, "End"},
    {GLFW_KEY_KP_ADD, "+"},       {GLFW_KEY_KP_SUBTRACT, "-"},
    {GLFW_KEY_KP_MULTIPLY, "*"},  {GLFW_KEY_KP_DIVIDE, "/"},
    {GLFW_KEY_KP_0, "0"},         {GLFW_KEY_KP_1, "1"},
    {GLFW_KEY_KP_2, "2"},         {GLFW_KEY_KP_3, "3"},
    {GLFW_KEY_KP_4, "4"},         {GLFW_KEY_KP_5, "5"},
    {GLFW_KEY_KP_6, "6"},         {GLFW_KEY_KP_7, "7"},
    {GLFW_KEY_KP_8, "8"},         {GLFW_KEY_KP_9, "9"},
}};

/// As the layout has it: on a German keyboard Z is where an American one has Y.
std::string name_of(int key, int scancode) {
    const auto known = std::ranges::find(key_names, key, &std::pair<int, const char*>::first);
    if (known != key_names.end()) return known->second;
    if (GLFW_KEY_F1 <= key && key <= GLFW_KEY_F25) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
    const char* printed = glfwGetKeyName(key, scancode);
    std::string name = printed != nullptr ? printed : "";
    for (char& letter : name) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    return name;
}

std::string position_of(int key) {
    if (GLFW_KEY_0 <= key && key <= GLFW_KEY_9) return std::to_string(key - GLFW_KEY_0);
    return {};
}

KeyPress press_of(int key, int scancode, int action, int mods) {
    const auto held = [&](int modifier) { return (mods & modifier) != 0; };
    const bool ctrl = held(GLFW_MOD_CONTROL) || held(GLFW_MOD_SUPER);  // the latter on a Mac
    return {
        {name_of(key, scancode), ctrl, held(GLFW_MOD_SHIFT), held(GLFW_MOD_ALT)}, position_of(key), action == GLFW_REPEAT};
}

bool is_in_menu() {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    if (context.NavWindow == nullptr || context.IO.WantTextInput) return false;
    return context.NavLayer == ImGuiNavLayer_Menu || (context.NavWindow->Flags & ImGuiWindowFlags_ChildMenu) != 0;
}

bool is_shift(int key) { return key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT; }

/// The key itself does nothing where its letter is typed, so that it may come and go within a frame.
bool only_writes(int key, int mods) {
    constexpr int last_printable = GLFW_KEY_WORLD_2;
    constexpr int other_meaning = GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;
    return GLFW_KEY_SPACE < key && key <= last_printable && (mods & other_meaning) == 0;
}

}  // namespace

/// What a frame has been told.
struct Keyboard::FedFrame {
    std::set<int> keys;  ///< that went down or up
    bool acts = false;   ///< among them one that does not merely write
    bool letters = false;
};

bool Keyboard::fits(const Event& event, const FedFrame& frame) {
    if (imgui_keeps_order) return true;
    if (event.letter != 0) return !frame.acts;
    if (only_writes(event.key, event.mods)) return true;
    if (is_shift(event.key)) return !(frame.acts && frame.keys.contains(event.key));
    return !frame.letters && !frame.keys.contains(event.key);
}

/// Dear ImGui's menus open by Alt alone, and Space gives their entries; F10 and Enter mean the same elsewhere.
int Keyboard::key_for_imgui(const Event& event) {
    if (event.action == GLFW_PRESS) {
        fed_as_.erase(event.key);
        if (event.key == GLFW_KEY_F10) fed_as_[event.key] = GLFW_KEY_LEFT_ALT;
        const bool enter = event.key == GLFW_KEY_ENTER || event.key == GLFW_KEY_KP_ENTER;
        if (enter && is_in_menu()) fed_as_[event.key] = GLFW_KEY_SPACE;
    }
    const auto other = fed_as_.find(event.key);
    return other == fed_as_.end() ? event.key : other->second;
}

void Keyboard::hand_on(const Event& event, FedFrame& frame) {
    if (event.letter != 0) {
        ImGui_ImplGlfw_CharCallback(window_, event.letter);
        frame.letters = true;
        return;
    }
    ImGui_ImplGlfw_KeyCallback(window_, key_for_imgui(event), event.scancode, event.action, event.mods);
    frame.keys.insert(event.key);
    frame.acts = frame.acts || (!only_writes(event.key, event.mods) && !is_shift(event.key));
}

void Keyboard::feed(const std::function<bool(const KeyPress&)>& take) {
    FedFrame frame;
    if (frames_to_wait_ > 0) --frames_to_wait_;
    while (!events_.empty()) {
        const Event event = events_.front();
        const bool pressed = event.letter == 0 && event.action != GLFW_RELEASE;
        if (pressed && take(press_of(event.key, event.scancode, event.action, event.mods))) {
            events_.pop_front();
            if (!events_.empty() && events_.front().letter != 0) events_.pop_front();  // what the key would have written
            frames_to_wait_ = frames_after_command;
            continue;
        }
        const bool released = event.letter == 0 && event.action == GLFW_RELEASE;
        if ((frames_to_wait_ > 0 && !released) || !fits(event, frame)) return;
        events_.pop_front();
        hand_on(event, frame);
    }
}

}  // namespace rinceau
