#include "analyzer/importance.h"

#include <algorithm>

namespace rinceau {

double importance(const ImportanceTerms& terms, const ImportanceTerms& largest, const ImportanceWeights& weights) {
    return weights.count * terms.elements / std::max(1.0, largest.elements) + weights.nearness * terms.nearness +
           weights.similarity * terms.similarity + weights.length * terms.length / std::max(1.0, largest.length);
}

double greatest_importance(const ImportanceWeights& weights) {
    return weights.count + weights.nearness + weights.similarity + weights.length;
}

}  // namespace rinceau
