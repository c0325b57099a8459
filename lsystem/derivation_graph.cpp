#include "lsystem/derivation_graph.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "lsystem/drawn_style.h"
#include "lsystem/expression_functions.h"
#include "lsystem/interpret.h"
#include "lsystem/stream.h"

namespace rinceau {

namespace {

/// Thrown inside this file only.
struct UnbalancedBrackets {};

struct TurtleState {
    Similarity pose;  ///< in the frame of the part
    GraphLook look;        ///< but for the terminal
    int layer = 0;    ///< above the part's
};

class GraphBuilder {
  public:
    explicit GraphBuilder(const CompiledGrammar& grammar) : grammar_(grammar), branches_(grammar.symbols.size()) {
        for (const CompiledProduction& production : grammar.productions) {
            const auto own = [&](const CompiledModule& module) { return module.symbol == production.symbol; };
            if (std::ranges::count_if(production.successor, own) > 1) branches_[symbol_index(production.symbol)] = true;
        }
        parts_.emplace_back();
    }

    void command(const CompiledModule& module, std::span<const double> arguments) {
        const double argument = arguments.empty() ? 0 : arguments.front();
        TurtleState& state = parts_.back().state;
        Similarity& pose = state.pose;
        switch (static_cast<TurtleCommand>(module.symbol)) {
            case TurtleCommand::left:
                turn(pose, argument);
                break;
            case TurtleCommand::right:
                turn(pose, -argument);
                break;
            case TurtleCommand::forward:
                pose.translation += pose.linear * flipped_if(pose.mirrored, {0, argument});
                break;
            case TurtleCommand::scale:
                pose.linear = argument * pose.linear;
                break;
            case TurtleCommand::mirror:
                pose = pose * mirror_about_heading();
                break;
            case TurtleCommand::push:
                parts_.back().stack.push_back(state);
                break;
            case TurtleCommand::pop:
                pop();
                break;
            case TurtleCommand::style:
                state.look.style = static_cast<int>(argument);
                break;
            case TurtleCommand::layer:
                state.layer += static_cast<int>(argument);
                break;
            case TurtleCommand::fill:
                state.look.fill = packed_color(arguments);
                break;
            case TurtleCommand::stroke:
                state.look.stroke = packed_color(arguments);
                break;
        }
    }

    void leaf(const CompiledModule& module, std::span<const double>, const StreamPlace&) {
        GraphLook look = parts_.back().state.look;
        look.terminal = grammar_.terminal_of[symbol_index(module.symbol)];
        if (look.terminal < 0) return;
        const auto [place, added] = look_numbers_.try_emplace(look, static_cast<int>(graph_.looks.size()));
        if (added) graph_.looks.push_back(look);
        const TurtleState& state = parts_.back().state;
        parts_.back().items.push_back({true, place->second, state.pose, state.layer});
        ++parts_.back().placements;
    }

    void exception(int) { continues_ = true; }

    void opened(const CompiledModule& module, std::span<const double>, int) {
        const bool own = module.symbol == parts_.back().symbol && !branches_[symbol_index(module.symbol)];
        joined_.push_back(own || continues_);
        continues_ = false;
        if (joined_.back()) return;
        OpenPart part{.symbol = module.symbol};
        part.state.look = parts_.back().state.look;
        parts_.push_back(std::move(part));
    }

    void closed() {
        const bool joined = joined_.back();
        joined_.pop_back();
        if (joined) return;
        if (!parts_.back().stack.empty()) throw UnbalancedBrackets();
        OpenPart part = std::move(parts_.back());
        parts_.pop_back();
        TurtleState& outside = parts_.back().state;
        if (!part.items.empty()) {
            const std::uint64_t placements = part.placements;
            parts_.back().items.push_back({false, number_of(part), outside.pose, outside.layer});
            parts_.back().placements += placements;
        }
        outside.pose = outside.pose * part.state.pose;
        outside.layer += part.state.layer;
        outside.look = part.state.look;
    }

    DerivationGraph graph() && {
        number_of(parts_.front());
        return std::move(graph_);
    }

  private:
    static constexpr Symbol axiom = -1;

    struct OpenPart {
        Symbol symbol = axiom;
        TurtleState state;
        std::vector<TurtleState> stack;
        std::vector<PartItem> items;
        std::uint64_t placements = 0;
    };

    const CompiledGrammar& grammar_;
    std::vector<bool> branches_;  ///< symbol -> a production of it has the symbol twice
    std::vector<OpenPart> parts_;
    std::vector<bool> joined_;  ///< of each open expansion: it goes on with the part around it
    bool continues_ = false;    ///< an exception is opened next
    DerivationGraph graph_;
    std::map<GraphLook, int> look_numbers_;
    std::unordered_map<std::string, int> part_numbers_;

    static std::size_t symbol_index(Symbol symbol) { return static_cast<std::size_t>(symbol); }

    static int packed_color(std::span<const double> channels) {
        if (channels.empty()) return -1;
        int packed = 0;
        constexpr int base = 256;
        for (const double channel : channels)
            packed = packed * base + static_cast<int>(std::lround(std::clamp(channel, 0.0, base - 1.0)));
        return packed;
    }

    static void turn(Similarity& pose, double degrees) {
        pose.linear = pose.linear * flipped_if(pose.mirrored, {cosine_of_degrees(degrees), sine_of_degrees(degrees)});
    }

    void pop() {
        OpenPart& part = parts_.back();
        if (part.stack.empty()) throw UnbalancedBrackets();
        part.state = part.stack.back();
        part.stack.pop_back();
    }

    /// What tells parts apart, as bytes.
    static std::string key_of(const OpenPart& part) {
        std::string key;
        const auto append = [&](const auto& value) { key.append(reinterpret_cast<const char*>(&value), sizeof value); };
        append(part.symbol);
        for (const PartItem& item : part.items) {
            append(item.is_look);
            append(item.index);
            append(item.layer);
            append(item.pose.mirrored);
            const double zero = 0;  // added to a negative zero it gives zero
            for (const double number :
                 {item.pose.linear.x, item.pose.linear.y, item.pose.translation.x, item.pose.translation.y})
                append(number + zero);
        }
        return key;
    }

    int number_of(OpenPart& part) {
        const auto [place, added] = part_numbers_.try_emplace(key_of(part), static_cast<int>(graph_.parts.size()));
        if (added) {
            const std::string symbol = part.symbol == axiom ? std::string() : grammar_.symbols[symbol_index(part.symbol)];
            graph_.parts.push_back({symbol, std::move(part.items), part.placements});
        }
        return place->second;
    }
};

}  // namespace

namespace {

std::optional<Color> unpacked_color(int packed) {
    if (packed < 0) return std::nullopt;
    const auto channel = [&](int shift) { return static_cast<std::uint8_t>(packed >> shift); };
    return Color{channel(16), channel(8), channel(0)};
}

}  // namespace

Style look_style(const Grammar& grammar, const GraphLook& look) {
    const int own = grammar.terminals[static_cast<std::size_t>(look.terminal)].style;
    const Style style = StyleTable(grammar).style(look.style != 0 ? look.style : own);
    return repainted(style, {unpacked_color(look.fill), unpacked_color(look.stroke)});
}

std::optional<DerivationGraph> derivation_graph(const Grammar& grammar, const DeriveOptions& options) {
    visit_placements(grammar, {.derive = options}, [](const Placement&) {});  // finds every mistake
    const CompiledGrammar compiled = compile(grammar);
    GraphBuilder builder(compiled);
    try {
        stream_modules(compiled, options, {}, true, builder);
    } catch (const UnbalancedBrackets&) {
        return std::nullopt;
    }
    return std::move(builder).graph();
}

}  // namespace rinceau
