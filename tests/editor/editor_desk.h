#pragma once
// The editor without a window: state, requests and the real effects, in folders of its own.

#include <catch2/catch.hpp>

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>

#include "editor/effects/effects.h"
#include "editor/model/update.h"
#include "files/files.h"

namespace rinceau {

/// A folder that goes with the test.
class TestFolder {
  public:
    TestFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "rinceau-test-XXXXXX").string();
        REQUIRE(::mkdtemp(name.data()) != nullptr);
        path_ = name;
    }
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;
    ~TestFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    std::string name() const { return path_.string(); }

  private:
    std::filesystem::path path_;
};

class EditorDesk {
  public:
    explicit EditorDesk(const KeptFolders& folders = {}) : answers_([this] { wake(); }), effects_(answers_, folders) {}

    const EditorState& state() const { return state_; }
    EditorState& changeable() { return state_; }
    Effects& effects() { return effects_; }

    void act(const Action& action) {
        Update next = update(std::move(state_), action);
        state_ = std::move(next.state);
        for (const Request& request : next.requests) effects_.fulfil(request);
    }
    /// Answers are taken until `done`; the test fails if that takes too long.
    void until(const std::function<bool()>& done) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (true) {
            for (const Action& answer : answers_.drain()) act(answer);
            if (done()) return;
            std::unique_lock lock(mutex_);
            const bool in_time = changed_.wait_until(lock, end, [this] { return awake_; });
            awake_ = false;
            if (!in_time) FAIL("nothing came back");
        }
    }
    void open(const std::string& path) {
        act(FileAction{OpenFile{path}});
        until([&] { return !is_busy(state_); });
    }
    bool was_told(const std::string& part) const {
        for (const EditorMessage& message : state_.messages)
            if (message.text.find(part) != std::string::npos) return true;
        return false;
    }
    /// Something is different from the file.
    void edit() {
        Grammar grammar = *state_.document.grammar;
        grammar.title += "*";
        state_.document = with_grammar(state_.document, std::move(grammar));
    }

  private:
    void wake() {
        {
            const std::lock_guard lock(mutex_);
            awake_ = true;
        }
        changed_.notify_one();
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    bool awake_ = false;
    EditorState state_ = initial_state();
    ActionQueue answers_;
    Effects effects_;
};

inline std::string sample_path(const std::string& name) { return RINCEAU_SOURCE_DIR "/samples/" + name; }

}  // namespace rinceau
