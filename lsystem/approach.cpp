#include "lsystem/approach.h"

#include <algorithm>
#include <map>

#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

class Cutter {
  public:
    Cutter(const std::vector<ModuleTemplate>& string, const std::string& own_symbol) : string_(string), own_(own_symbol) {}

    std::vector<Approach> cut() {
        for (std::size_t i = 0; i < string_.size(); ++i) pass(static_cast<int>(i));
        flush(0);
        count();
        return std::move(result_);
    }

  private:
    const std::vector<ModuleTemplate>& string_;
    const std::string& own_;
    std::vector<Approach> result_;
    std::vector<int> pending_;
    std::vector<std::size_t> open_;  ///< how much was pending when the bracket was opened

    void pass(int position) {
        const std::string& symbol = string_[static_cast<std::size_t>(position)].symbol;
        if (symbol == "[") {
            open_.push_back(pending_.size());
        } else if (symbol == "]") {
            if (open_.empty()) return;
            flush(open_.back());
            open_.pop_back();
        } else if (find_turtle_command(symbol) != nullptr) {
            pending_.push_back(position);
        } else {
            result_.push_back({position, symbol == own_, 1, 1, pending_});
            pending_.clear();
            std::ranges::fill(open_, std::size_t{0});
        }
    }

    /// Commands that lead to nothing.
    void flush(std::size_t from) {
        if (from >= pending_.size()) return;
        const auto first = pending_.begin() + static_cast<std::ptrdiff_t>(from);
        result_.push_back({-1, true, 1, 1, {first, pending_.end()}});
        pending_.erase(first, pending_.end());
    }

    std::string key(const Approach& approach) const {
        return approach.own ? "" : string_[static_cast<std::size_t>(approach.symbol)].symbol;
    }
    void count() {
        std::map<std::string, int> counts;
        for (Approach& approach : result_) approach.ordinal = ++counts[key(approach)];
        for (Approach& approach : result_) approach.of = counts[key(approach)];
    }
};

}  // namespace

std::vector<Approach> approaches_of(const std::vector<ModuleTemplate>& string, const std::string& own_symbol) {
    return Cutter(string, own_symbol).cut();
}

std::vector<int> way_to(const std::vector<ModuleTemplate>& string, int position) {
    std::vector<int> way;
    std::vector<std::size_t> open;
    for (int i = 0; i < position; ++i) {
        const std::string& symbol = string[static_cast<std::size_t>(i)].symbol;
        if (symbol == "[") {
            open.push_back(way.size());
        } else if (symbol != "]") {
            way.push_back(i);
        } else if (!open.empty()) {
            way.resize(open.back());
            open.pop_back();
        }
    }
    return way;
}

int turn_sign(const ModuleTemplate& module) {
    if (module.arguments.size() != 1) return 0;  // a mistake, which compiling reports
    if (module.symbol == "+") return 1;
    return module.symbol == "-" ? -1 : 0;
}

}  // namespace rinceau
