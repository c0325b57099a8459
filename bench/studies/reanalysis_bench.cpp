// How far the picture is behind a slider of the analysis: from the action to the derived picture of what was found, by the
// editor's own update and threads. A nested drawing of 1,200 elements. Usage: reanalysis_bench [repetitions, default 12]

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "closed_loop/scenes.h"
#include "editor/effects/effects.h"
#include "editor/model/update.h"

using namespace rinceau;

namespace {

using Clock = std::chrono::steady_clock;

/// An editor without a window: acts, and waits for what comes back.
class Editor {
  public:
    explicit Editor(Document document) : answers_([this] { wake(); }), effects_(answers_) {
        state_.document = std::move(document);
        act(AnalysisAction{StartAnalysis{}});
        settle();
    }

    const EditorState& state() const { return state_; }

    void act(const Action& action) {
        Update next = update(std::move(state_), action);
        state_ = std::move(next.state);
        for (const Request& request : next.requests) effects_.fulfil(request);
    }
    /// Until no analysis runs and what it found has its picture.
    void settle() {
        while (state_.analysis.running || state_.picture_revision != state_.revision) {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [&] { return std::exchange(woken_, false); });
            lock.unlock();
            for (const Action& answer : answers_.drain()) act(answer);
        }
    }

  private:
    void wake() {
        const std::lock_guard lock(mutex_);
        woken_ = true;
        changed_.notify_all();
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    bool woken_ = false;
    EditorState state_ = initial_state();
    ActionQueue answers_;
    Effects effects_;
};

Document drawing_document(Scene scene) {
    Document document = empty_document();
    auto grammar = std::make_shared<Grammar>();
    grammar->canvas = scene.viewport;
    document.grammar = document.resolved = std::move(grammar);
    document.drawing = std::make_shared<const Scene>(std::move(scene));
    return document;
}

double seconds_behind(Editor& editor, const AnalyzeOptions& options) {
    const auto start = Clock::now();
    editor.act(AnalysisAction{TryAnalysis{options}});
    editor.settle();
    return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

int main(int argc, char** argv) {
    const int repetitions = argc > 1 ? std::max(1, std::atoi(argv[1])) : 12;
    Editor editor(drawing_document(test::nested_scene(1, 1).scene));
    std::vector<double> behind;
    for (int k = 0; k < repetitions; ++k) {
        AnalyzeOptions options;
        options.weights.nearness = 1 + 0.1 * (k + 1);
        behind.push_back(seconds_behind(editor, options));
    }
    std::ranges::sort(behind);
    std::printf("%zu elements: a weight is seen after %.0f ms (median), %.0f ms (best), %.0f ms (worst)\n",
                editor.state().document.drawing->elements.size(), 1e3 * behind[behind.size() / 2], 1e3 * behind.front(),
                1e3 * behind.back());
}
