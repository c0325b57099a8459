#pragma once
// The four weights of the importance function (Stava et al. 2010, eq. 5).

namespace rinceau {

/// 0..4 each, 1 = neutral: they steer which structure is preferred. Whatever they are, a rule must save bits at neutral
/// weights to be accepted at all; with low weights rules that would save bits may stay away.
struct ImportanceWeights {
    double count = 1;       ///< w_n: structures that repeat often
    double nearness = 1;    ///< w_h: near elements first
    double similarity = 1;  ///< w_phi: small deviations first
    double length = 1;      ///< w_l: long sequences first
};

}  // namespace rinceau
