#include "editor/effects/worker.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <mutex>
#include <thread>

#include "editor/effects/progress_posts.h"

using namespace rinceau;

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// Keeps the messages of failed files, which stand for any answer.
class Answers {
  public:
    Worker::Post post() {
        return [this](const Action& action) {
            const std::lock_guard lock(mutex_);
            messages_.push_back(std::get<FileFailed>(std::get<FileAction>(action)).message);
        };
    }
    std::vector<std::string> messages() const {
        const std::lock_guard lock(mutex_);
        return messages_;
    }

  private:
    mutable std::mutex mutex_;
    std::vector<std::string> messages_;
};

Action answer(const std::string& text) { return FileAction{FileFailed{{}, text}}; }

}  // namespace

TEST_CASE("stopping returns at once though the job does not look, and the job then answers nothing") {
    Answers answers;
    std::atomic<bool> begun = false, may_end = false;
    Worker worker(answers.post());
    worker.start([&](const Progress&, const Worker::Post& post) {
        begun = true;
        while (!may_end) std::this_thread::sleep_for(milliseconds(1));
        post(answer("late"));
    });
    while (!begun) std::this_thread::yield();
    const auto start = Clock::now();
    worker.stop();
    worker.start([](const Progress&, const Worker::Post& post) { post(answer("next")); });
    CHECK(Clock::now() - start < milliseconds(200));
    CHECK_FALSE(worker.idle_within(0.01));
    may_end = true;
    CHECK(worker.idle_within(10));
    CHECK(answers.messages() == std::vector<std::string>{"next"});
}

TEST_CASE("of jobs that wait only the newest is run, and its progress ends the one before") {
    Answers answers;
    std::atomic<bool> begun = false;
    Worker worker(answers.post());
    worker.start([&](const Progress& progress, const Worker::Post& post) {
        post(answer("first"));
        begun = true;
        while (true) progress("for ever", 0);
    });
    while (!begun) std::this_thread::yield();
    for (const char* name : {"second", "third", "fourth"})
        worker.start([name](const Progress& progress, const Worker::Post& post) {
            progress("at once", 0);
            post(answer(name));
        });
    CHECK(worker.idle_within(10));
    const std::vector<std::string> messages = answers.messages();
    REQUIRE(!messages.empty());
    CHECK(messages.front() == "first");
    CHECK(messages.back() == "fourth");
}

TEST_CASE("nothing of a job is left when its worker is gone") {
    Answers answers;
    std::atomic<bool> begun = false, ended = false;
    {
        Worker worker(answers.post());
        worker.start([&](const Progress& progress, const Worker::Post&) {
            struct AtEnd {
                std::atomic<bool>& ended;
                ~AtEnd() { ended = true; }
            } const at_end{ended};
            begun = true;
            while (true) progress("for ever", 0);
        });
        while (!begun) std::this_thread::yield();
    }
    CHECK(ended);
}

TEST_CASE("progress is posted when a stage begins and then twenty times a second") {
    ProgressPosts posts;
    const Clock::time_point start{};
    int posted = 0;
    for (int ms = 0; ms < 1000; ++ms) posted += posts.worth("rules", start + milliseconds(ms));
    CHECK(posted == 20);
    CHECK(posts.worth("check", start + milliseconds(1000)));
    CHECK_FALSE(posts.worth("check", start + milliseconds(1001)));
}
