#include "lsystem/derivation_path.h"

#include <algorithm>
#include <utility>

#include "lsystem/expression_functions.h"
#include "lsystem/stream.h"

namespace rinceau {

namespace {

constexpr int none = -1;

/// Thrown inside this file only: all that was asked for is known.
struct PathKnown {};

/// What the turtle does to its pose; true if the command was one of these.
bool move_turtle(Similarity& pose, const CompiledModule& module, double argument) {
    const auto turn = [&](double degrees) {
        const Complex by = module.constant ? module.turn : Complex{cosine_of_degrees(degrees), sine_of_degrees(degrees)};
        pose.linear = pose.linear * flipped_if(pose.mirrored, by);
    };
    switch (static_cast<TurtleCommand>(module.symbol)) {
        case TurtleCommand::left:
            turn(argument);
            return true;
        case TurtleCommand::right:
            turn(-argument);
            return true;
        case TurtleCommand::forward:
            pose.translation += pose.linear * flipped_if(pose.mirrored, {0, argument});
            return true;
        case TurtleCommand::scale:
            pose.linear = argument * pose.linear;
            return true;
        case TurtleCommand::mirror:
            pose = pose * mirror_about_heading();
            return true;
        default:
            return false;
    }
}

/// Walks the derivation and keeps what is open; when the element comes, what is open is the way to it.
class PathFinder {
  public:
    PathFinder(const CompiledGrammar& grammar, const ElementQuery& element, bool way_only)
        : grammar_(grammar),
          element_(element),
          way_only_(way_only),
          own_modules_(grammar.symbols.size()),
          counts_(grammar.symbols.size()) {
        for (const CompiledProduction& production : grammar.productions) {
            const auto own = [&](const CompiledModule& module) { return module.symbol == production.symbol; };
            auto& most = own_modules_[index(production.symbol)];
            most = std::max(most, std::ranges::count_if(production.successor, own));
        }
        open_.push_back({});
    }

    void command(const CompiledModule& module, std::span<const double> arguments) {
        if (module.symbol == static_cast<Symbol>(TurtleCommand::push)) {
            stack_.push_back(pose_);
        } else if (module.symbol == static_cast<Symbol>(TurtleCommand::pop)) {
            if (stack_.empty()) throw InputError(module.source->place, "expected '[' before this ']', found none");
            pose_ = stack_.back();
            stack_.pop_back();
        } else {
            move_turtle(pose_, module, arguments.empty() ? 0 : arguments.front());
        }
    }

    void exception(int number) { exception_ = number; }

    void opened(const CompiledModule& module, std::span<const double> arguments, int production, const StreamPlace& place) {
        const OpenModule& above = open_.back();
        const int exception = std::exchange(exception_, none);
        const bool own = above.production >= 0 && above.symbol == module.symbol;
        const auto own_modules = own_modules_[index(module.symbol)];
        OpenModule next{.module = &module,
                        .symbol = module.symbol,
                        .production = production,
                        .exception = exception,
                        .values = values_.size(),
                        .front = place.address_front.size(),
                        .number = place.number,
                        .own = own,
                        .pose = pose_,
                        .first = order_};
        next.joined = own && exception == none && own_modules == 1;
        next.root = next.joined ? above.root : open_.size();
        values_.insert(values_.end(), arguments.begin(), arguments.end());
        if (exception == none && !own) ++counts_[index(module.symbol)];
        open_.push_back(std::move(next));
        if (exception == none && own_modules == 1) {
            std::vector<SequencePart>& parts = open_[open_.back().root].parts;
            open_.back().part = static_cast<int>(parts.size());
            parts.push_back({pose_, order_, order_});
        }
    }

    void closed() {
        OpenModule done = std::move(open_.back());
        open_.pop_back();
        values_.resize(done.values);
        if (open_.size() < captured_) {
            captured_ = open_.size();
            if (!done.joined) finish(way_[done.on_way], done);
        }
        if (!done.joined && order_ > done.first) note_drawn(done.pose, done.first);
    }

    void leaf(const CompiledModule& module, std::span<const double> arguments, const StreamPlace& place) {
        if (grammar_.terminal_of[index(module.symbol)] < 0) return;
        ++counts_[index(module.symbol)];
        const int first = order_++;
        if (way_.empty() && is_wanted(place, first)) capture(module, arguments, place);
        note_drawn(pose_, first);
    }

    /// When all has been passed.
    std::vector<PathModule> path() && {
        if (way_.empty()) return {};
        way_.front().last = order_;
        way_.front().after = pose_;
        for (std::size_t i = 1; i < way_.size(); ++i) way_[i].count = counts_[index(symbols_[i])];
        return std::move(way_);
    }
    std::vector<PathModule> way() && { return std::move(way_); }

  private:
    struct OpenModule {
        const CompiledModule* module = nullptr;  ///< null = the axiom
        Symbol symbol = none;
        int production = none;
        int exception = none;
        std::size_t values = 0;  ///< where its arguments begin
        std::size_t front = 0;   ///< size of its address but the last number ..
        int number = 0;          ///< .. which is this; 0 = it has none
        bool own = false;        ///< its symbol is that of the production it stands in
        Similarity pose;
        int first = 0;
        bool joined = false;   ///< it continues the sequence that open_[root] begins
        std::size_t root = 0;  ///< itself, if it is not joined
        int part = none;       ///< which part of that sequence it is
        std::size_t on_way = 0;
        std::vector<SequencePart> parts;
    };

    const CompiledGrammar& grammar_;
    const ElementQuery& element_;
    bool way_only_;
    std::vector<std::ptrdiff_t> own_modules_;  ///< by symbol: how often it stands in its own production
    std::vector<int> counts_;                  ///< by symbol
    std::vector<OpenModule> open_;
    std::vector<double> values_;
    std::vector<Similarity> stack_;
    Similarity pose_;
    int order_ = 0;
    int exception_ = none;
    std::vector<PathModule> way_;
    std::vector<Symbol> symbols_;  ///< of way_
    std::size_t captured_ = 0;     ///< so many of open_ lead to the element and are not closed yet

    static std::size_t index(Symbol symbol) { return static_cast<std::size_t>(symbol); }

    bool is_wanted(const StreamPlace& place, int order) const {
        if (element_.order >= 0) return order == element_.order;
        const std::vector<int>& wanted = element_.address;
        const std::vector<int>& front = place.address_front;
        if (wanted.empty() || wanted.size() > front.size() + 1) return false;
        const auto known = std::min(wanted.size(), front.size());
        if (!std::equal(wanted.begin(), wanted.begin() + static_cast<std::ptrdiff_t>(known), front.begin())) return false;
        return known == wanted.size() || wanted.back() == place.number;
    }

    /// Something was drawn directly in the module that is open last.
    void note_drawn(const Similarity& pose, int first) {
        const OpenModule& last = open_.back();
        if (last.part == none) return;
        SequencePart& part = open_[last.root].parts[static_cast<std::size_t>(last.part)];
        if (part.first == part.last) {
            part.pose = pose;
            part.first = first;
        }
        part.last = order_;
    }

    void finish(PathModule& module, OpenModule& done) const {
        module.after = pose_;
        module.last = order_;
        module.parts = std::move(done.parts);
    }

    void capture(const CompiledModule& leaf, std::span<const double> arguments, const StreamPlace& place) {
        open_.push_back({.module = &leaf,
                         .symbol = leaf.symbol,
                         .values = values_.size(),
                         .front = place.address_front.size(),
                         .number = place.number,
                         .pose = pose_,
                         .first = order_ - 1});
        values_.insert(values_.end(), arguments.begin(), arguments.end());
        for (std::size_t i = 0; i < open_.size(); ++i) {
            if (open_[i].joined) continue;
            open_[i].on_way = way_.size();
            way_.push_back(described(i, place.address_front));
            symbols_.push_back(open_[i].symbol);
        }
        finish(way_.back(), open_.back());
        values_.resize(open_.back().values);
        open_.pop_back();
        captured_ = open_.size();
        if (way_only_) throw PathKnown{};
    }

    PathModule described(std::size_t i, const std::vector<int>& front) const {
        const OpenModule& open = open_[i];
        PathModule module;
        module.production = open.production;
        module.exception = open.exception;
        module.pose = open.pose;
        module.first = open.first;
        if (open.module == nullptr) return module;
        const OpenModule& above = open_[i - 1];
        if (above.exception != none) {
            module.string = {StringPlace::In::exception, above.exception};
        } else if (above.module != nullptr) {
            module.string = {StringPlace::In::production, above.production};
        }
        module.symbol = open.module->source->symbol;
        module.position = open.module->position;
        const auto value = [&](std::size_t at) { return values_.begin() + static_cast<std::ptrdiff_t>(at); };
        const std::size_t values_end = i + 1 < open_.size() ? open_[i + 1].values : values_.size();
        module.arguments.assign(value(open.values), value(values_end));
        module.branches = open.own && open.exception == none;
        module.part = above.part;
        if (open.number > 0) {
            module.address.assign(front.begin(), front.begin() + static_cast<std::ptrdiff_t>(open.front));
            module.address.push_back(open.number);
        }
        return module;
    }
};

PathFinder passed(const CompiledGrammar& compiled, const ElementQuery& element, bool way_only, const DeriveOptions& options,
                  const Progress& progress) {
    PathFinder finder(compiled, element, way_only);
    try {
        stream_modules(compiled, options, progress, !way_only, finder);
    } catch (const PathKnown&) {
    }
    return finder;
}

}  // namespace

std::vector<PathModule> derivation_path(const Grammar& grammar, const ElementQuery& element, const DeriveOptions& options,
                                        const Progress& progress) {
    const CompiledGrammar compiled = compile(grammar, options.seed);
    return passed(compiled, element, false, options, progress).path();
}

std::optional<Similarity> pose_on_path(const Grammar& grammar, int order, std::size_t module, const DeriveOptions& options) {
    const CompiledGrammar compiled = compile(grammar, options.seed);
    const ElementQuery element{order, {}};
    const std::vector<PathModule> way = passed(compiled, element, true, options, {}).way();
    if (module >= way.size()) return std::nullopt;
    return way[module].pose;
}

}  // namespace rinceau
