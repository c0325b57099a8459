#include "editor/model/history.h"

#include <utility>

namespace rinceau {
namespace {

constexpr std::size_t most_steps = 1000;

HistoryMove moved(const Document& current, std::vector<HistoryStep>& from, std::vector<HistoryStep>& to) {
    HistoryMove move;
    move.document = current;
    if (from.empty()) return move;
    HistoryStep step = std::move(from.back());
    from.pop_back();
    to.push_back({step.label, current});
    move.document = std::move(step.document);
    move.label = std::move(step.label);
    return move;
}

}  // namespace

History recorded(History history, const Document& before, std::string label) {
    if (history.past.size() >= most_steps) history.past.erase(history.past.begin());
    history.past.push_back({std::move(label), before});
    history.future.clear();
    return history;
}

HistoryMove undone(const Document& current, History history) {
    HistoryMove move = moved(current, history.past, history.future);
    move.history = std::move(history);
    return move;
}

HistoryMove redone(const Document& current, History history) {
    HistoryMove move = moved(current, history.future, history.past);
    move.history = std::move(history);
    return move;
}

}  // namespace rinceau
