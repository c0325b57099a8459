#pragma once
// What is typed, in order: nothing is lost between two frames.

#include <deque>
#include <functional>
#include <map>
#include <string>

#include "editor/model/key_chord.h"

struct GLFWwindow;

namespace rinceau {

/// A key that went down or is held, as a command may want it.
struct KeyPress {
    KeyChord chord;        ///< by the layout of the keyboard
    std::string position;  ///< what an American keyboard has there; empty = nothing else
    bool repeated = false;
};

/// Dear ImGui before 1.87 sees only which keys are down when a frame begins. This takes GLFW's events in its place and hands
/// them on so that each is seen: what one frame cannot tell apart waits for the next.
class Keyboard {
  public:
    /// Of a window that Dear ImGui's backend knows.
    explicit Keyboard(GLFWwindow* window) : window_(window) {}

    /// What GLFW tells of a key, and of a letter (Unicode).
    void on_key(int key, int scancode, int action, int mods) { events_.push_back({key, scancode, action, mods, 0}); }
    void on_letter(unsigned letter) { events_.push_back({0, 0, 0, 0, letter}); }

    /// Before a frame begins. `take` is asked about each key that is pressed; what it takes (true) is not typed.
    void feed(const std::function<bool(const KeyPress&)>& take);

    /// Is there more than the frame before could be told?
    bool is_waiting() const { return !events_.empty(); }

  private:
    struct Event {
        int key = 0;  ///< of GLFW; 0 for a letter
        int scancode = 0;
        int action = 0;
        int mods = 0;
        unsigned letter = 0;  ///< Unicode; 0 for a key
    };
    struct FedFrame;

    static bool fits(const Event& event, const FedFrame& frame);
    int key_for_imgui(const Event& event);
    void hand_on(const Event& event, FedFrame& frame);

    GLFWwindow* window_;
    std::deque<Event> events_;
    std::map<int, int> fed_as_;  ///< keys that are down for Dear ImGui by another name
    int frames_to_wait_ = 0;     ///< after a command, before more is typed
};

}  // namespace rinceau
