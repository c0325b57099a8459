#include "exports/repeated_parts.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>

namespace rinceau {

namespace {

using Tokens = std::vector<int>;

/// A token: an atom, a bracket, or a pair of tokens that come together.
struct Token {
    std::string text;   ///< of an atom
    int sequence = -1;  ///< of a bracket or a pair: what is in it
    bool in_brackets = false;
    char name = 0;            ///< 0 = written out where it stands
    bool was_lonely = false;  ///< had a name and was used once
};

class Naming {
  public:
    Naming(const BracketedString& string, std::string names) : names_(std::move(names)) {
        for (const std::string& atom : string.atoms) tokens_.push_back({atom});
        for (const Tokens& group : string.groups) tokens_.push_back({{}, add_sequence(group), true});
        whole_ = static_cast<int>(tokens_.size());
        tokens_.push_back({{}, add_sequence(string.whole), false, names_.back()});
        names_.pop_back();
    }

    std::vector<NamedPart> name_all() {
        while (!names_.empty()) {
            const Choice choice = best_choice();
            if (choice.saving <= 0) break;
            apply(choice);
            inline_lonely();
        }
        return parts();
    }

  private:
    struct Choice {
        std::int64_t saving = 0;
        int token = -1;  ///< to be named; or a pair
        std::pair<int, int> pair{-1, -1};
    };

    std::string names_;
    std::vector<Token> tokens_;
    std::vector<Tokens> sequences_;
    int whole_ = 0;

    int add_sequence(Tokens tokens) {
        sequences_.push_back(std::move(tokens));
        return static_cast<int>(sequences_.size()) - 1;
    }
    const Tokens& sequence_of(int token) const { return sequences_[static_cast<std::size_t>(at(token).sequence)]; }
    const Token& at(int token) const { return tokens_[static_cast<std::size_t>(token)]; }

    /// Tokens, each after those that it is made of.
    std::vector<int> bottom_up() const {
        std::vector<int> order;
        std::vector<char> seen(tokens_.size(), 0);
        std::vector<std::pair<int, std::size_t>> stack{{whole_, 0}};
        while (!stack.empty()) {
            auto& [token, next] = stack.back();
            const bool composed = at(token).sequence >= 0;
            if (composed && next < sequence_of(token).size()) {
                const int part = sequence_of(token)[next++];
                if (seen[static_cast<std::size_t>(part)] == 0) {
                    seen[static_cast<std::size_t>(part)] = 1;
                    stack.emplace_back(part, 0);
                }
            } else {
                order.push_back(token);
                stack.pop_back();
            }
        }
        return order;
    }

    /// Characters of every token when it is written out.
    std::vector<std::int64_t> lengths(const std::vector<int>& order) const {
        std::vector<std::int64_t> lengths(tokens_.size(), 0);
        for (const int token : order) {
            std::int64_t length = static_cast<std::int64_t>(at(token).text.size()) + (at(token).in_brackets ? 2 : 0);
            if (at(token).sequence >= 0) {
                for (const int part : sequence_of(token))
                    length += at(part).name != 0 ? 1 : lengths[static_cast<std::size_t>(part)];
            }
            lengths[static_cast<std::size_t>(token)] = length;
        }
        return lengths;
    }

    /// How often the text of every token's sequence is written.
    std::vector<std::int64_t> times_written(const std::vector<int>& order) const {
        std::vector<std::int64_t> times(tokens_.size(), 0);
        std::vector<std::int64_t> used(tokens_.size(), 0);
        used[static_cast<std::size_t>(whole_)] = 1;
        for (auto token = order.rbegin(); token != order.rend(); ++token) {
            const auto index = static_cast<std::size_t>(*token);
            times[index] = at(*token).name != 0 ? 1 : used[index];
            if (at(*token).sequence < 0) continue;
            for (const int part : sequence_of(*token)) used[static_cast<std::size_t>(part)] += times[index];
        }
        return times;
    }

    static std::int64_t saving(std::int64_t uses, std::int64_t length) {
        constexpr std::int64_t of_a_rule = 3;  // name, sign, line end
        return (uses - 1) * length - uses - of_a_rule;
    }

    Choice best_choice() const {
        const std::vector<int> order = bottom_up();
        const std::vector<std::int64_t> length = lengths(order);
        const std::vector<std::int64_t> times = times_written(order);
        Choice best;
        for (const int token : order) {
            const auto index = static_cast<std::size_t>(token);
            if (at(token).name != 0 || at(token).was_lonely || times[index] < 2) continue;
            const std::int64_t saved = saving(times[index], length[index]);
            if (saved > best.saving) best = {saved, token, {-1, -1}};
        }
        std::map<std::pair<int, int>, std::int64_t> pairs;
        for (const int token : order) {
            if (at(token).sequence < 0) continue;
            const Tokens& parts = sequence_of(token);
            for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
                pairs[{parts[i], parts[i + 1]}] += times[static_cast<std::size_t>(token)];
                const bool run = i + 2 < parts.size() && parts[i] == parts[i + 1] && parts[i] == parts[i + 2];
                if (run) ++i;  // x x x holds one pair only
            }
        }
        for (const auto& [pair, count] : pairs) {
            const auto written = [&](int token) {
                return at(token).name != 0 ? std::int64_t{1} : length[static_cast<std::size_t>(token)];
            };
            const std::int64_t saved = saving(count, written(pair.first) + written(pair.second));
            if (saved > best.saving) best = {saved, -1, pair};
        }
        return best;
    }

    char take_name() {
        const char name = names_.front();
        names_.erase(0, 1);
        return name;
    }

    void apply(const Choice& choice) {
        if (choice.token >= 0) {
            tokens_[static_cast<std::size_t>(choice.token)].name = take_name();
            return;
        }
        const int token = static_cast<int>(tokens_.size());
        for (Tokens& sequence : sequences_) replace_pair(sequence, choice.pair, token);
        tokens_.push_back({{}, add_sequence({choice.pair.first, choice.pair.second}), false, take_name()});
    }

    static void replace_pair(Tokens& sequence, std::pair<int, int> pair, int token) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < sequence.size(); ++i) {
            const bool found = i + 1 < sequence.size() && sequence[i] == pair.first && sequence[i + 1] == pair.second;
            sequence[kept++] = found ? token : sequence[i];
            if (found) ++i;
        }
        sequence.resize(kept);
    }

    /// A name that is used once is written out again; brackets and atoms stay tokens.
    void inline_lonely() {
        std::vector<int> uses(tokens_.size(), 0);
        for (const int token : bottom_up()) {
            if (at(token).sequence < 0) continue;
            for (const int part : sequence_of(token)) ++uses[static_cast<std::size_t>(part)];
        }
        for (std::size_t token = 0; token < tokens_.size(); ++token) {
            if (static_cast<int>(token) == whole_ || tokens_[token].name == 0 || uses[token] != 1) continue;
            names_.insert(names_.begin(), tokens_[token].name);
            tokens_[token].name = 0;
            tokens_[token].was_lonely = true;
        }
    }

    void append_pieces(int token, std::vector<std::string>& pieces) const {
        if (at(token).sequence < 0) {
            pieces.push_back(at(token).text);
            return;
        }
        if (at(token).in_brackets) pieces.emplace_back("[");
        for (const int part : sequence_of(token)) {
            if (at(part).name != 0) {
                pieces.emplace_back(1, at(part).name);
            } else {
                append_pieces(part, pieces);
            }
        }
        if (at(token).in_brackets) pieces.emplace_back("]");
    }

    std::vector<NamedPart> parts() const {
        std::vector<NamedPart> parts;
        std::vector<int> depth(tokens_.size(), 0);
        for (const int token : bottom_up()) {
            int& own = depth[static_cast<std::size_t>(token)];
            if (at(token).sequence >= 0) {
                for (const int part : sequence_of(token)) own = std::max(own, depth[static_cast<std::size_t>(part)]);
            }
            if (at(token).name == 0) continue;
            NamedPart named{at(token).name, {}, {}, ++own};
            append_pieces(token, named.pieces);
            for (const std::string& piece : named.pieces) named.text += piece;
            parts.push_back(std::move(named));
        }
        return parts;
    }
};

}  // namespace

std::vector<NamedPart> named_parts(const BracketedString& string, const std::string& names) {
    return Naming(string, names).name_all();
}

}  // namespace rinceau
