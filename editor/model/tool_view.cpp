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
    const auto& terminals = state.document.resolved->terminals;
    return symbol.empty() && !terminals.empty() ? terminals.front().symbol : symbol;
}

}  // namespace rinceau
