#include "lsystem/approach.h"

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
    struct Bracket {
        std::size_t pending;
        std::size_t way;
    };
    const std::vector<ModuleTemplate>& string_;
    const std::string& own_;
    std::vector<Approach> result_;
    std::vector<int> pending_;
    std::vector<int> way_;
    std::vector<Bracket> open_;

    void pass(int position) {
        const std::string& symbol = string_[static_cast<std::size_t>(position)].symbol;
        if (symbol == "[") {
            open_.push_back({pending_.size(), way_.size()});
        } else if (symbol == "]") {
            if (open_.empty()) return;
            flush(open_.back().pending);
            way_.resize(open_.back().way);
            open_.pop_back();
        } else if (find_turtle_command(symbol) != nullptr) {
            pending_.push_back(position);
            way_.push_back(position);
        } else {
            result_.push_back({position, symbol == own_, 1, 1, pending_, way_});
            pending_.clear();
            for (Bracket& bracket : open_) bracket.pending = 0;
            way_.push_back(position);
        }
    }

    /// Commands that lead to nothing.
    void flush(std::size_t from) {
        if (from >= pending_.size()) return;
        const auto first = pending_.begin() + static_cast<std::ptrdiff_t>(from);
        result_.push_back({-1, true, 1, 1, {first, pending_.end()}, way_});
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

int turn_sign(const ModuleTemplate& module) {
    if (module.symbol == "+") return 1;
    return module.symbol == "-" ? -1 : 0;
}

}  // namespace rinceau
