#include "editor/model/tool_view.h"

namespace rinceau {

std::uint64_t shown_seed(const EditorState& state) {
    const std::optional<std::uint64_t>& set = state.tools.settings.noise.seed;
    return set ? *set : shown_document(state).grammar->seed.value_or(1);
}

NoiseInGrammar shown_noise(const EditorState& state) {
    const RandomizeOptions& set = state.tools.settings.noise;
    NoiseInGrammar noise = noise_in(*shown_document(state).grammar);
    if (set.angle) noise.angle = {set.angle_distribution, *set.angle};
    if (set.distance) noise.distance = {set.distance_distribution, *set.distance};
    if (set.scale) noise.scale = {set.scale_distribution, *set.scale};
    return noise;
}

std::string symbol_to_replace(const EditorState& state) {
    const std::string& symbol = state.tools.settings.replace.symbol;
    const bool only_selected = state.tools.settings.replace.only_selected;
    if (!symbol.empty() && !only_selected) return symbol;
    if (state.canvas.selection && !selected_module(*state.canvas.selection).symbol.empty())
        return selected_module(*state.canvas.selection).symbol;
    const auto& terminals = state.document.resolved->terminals;
    return symbol.empty() && !terminals.empty() ? terminals.front().symbol : symbol;
}

std::vector<int> address_to_replace(const EditorState& state) {
    if (!state.canvas.selection) return {};
    return selected_module(*state.canvas.selection).address;
}

std::vector<TerminalUse> terminal_uses(const EditorState& state) {
    std::vector<TerminalUse> uses(shown_document(state).resolved->terminals.size());
    const DerivedPicture* picture = state.picture.get();
    if (picture == nullptr || picture->grammar != shown_document(state).resolved) return uses;
    for (std::size_t i = 0; i < picture->looks.size(); ++i) {
        TerminalUse& use = uses[static_cast<std::size_t>(picture->looks[i].terminal)];
        if (use.look < 0) use.look = static_cast<int>(i);
    }
    for (const PictureItem& item : picture->items) {
        const PictureLook& look = picture->looks[static_cast<std::size_t>(item.look)];
        TerminalUse& use = uses[static_cast<std::size_t>(look.terminal)];
        ++use.count;
        use.mirrored += item.pose.mirrored;
    }
    return uses;
}

}  // namespace rinceau
