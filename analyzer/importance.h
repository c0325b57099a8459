#pragma once
// The four weights of the importance function (Stava et al. 2010, eq. 5).

namespace rinceau {

/// 0..4 each, 1 = neutral: they steer which structure is preferred, never whether a structure is worth a rule at all.
struct ImportanceWeights {
    double count = 1;       ///< w_n: structures that repeat often
    double nearness = 1;    ///< w_h: near elements first
    double similarity = 1;  ///< w_phi: small deviations first
    double length = 1;      ///< w_l: long sequences first
};

}  // namespace rinceau
