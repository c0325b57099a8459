// Seconds for grouping 1e3, 1e4 and 1e5 copies of 70 shapes (docs/analysis.md, 1): random similarities and mirror images,
// random start nodes, reversals and splits; without noise and with noise of 1e-4 and 1e-3 of the size.
#include <chrono>
#include <cstdio>

#include "analyzer/similarity_scenes.h"

using namespace rinceau;
using namespace rinceau::test;

int main() {
    std::printf("elements   noise   looks  purity  recall  pose error  seconds\n");
    for (const double noise : {0.0, 1e-4, 1e-3})
        for (const int count : {1000, 10'000, 100'000}) {
            const CopiedScene truth = copied_scene(different_outlines(), count, noise, 1);
            const auto start = std::chrono::steady_clock::now();
            const Instancing found = group_similar_elements(truth.scene);
            const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
            const PairScore score = pair_score(truth, found);
            std::printf("%8d  %6.0e  %6zu  %6.3f  %6.3f  %10.1e  %7.3f\n", count, noise, found.looks.size(), score.purity,
                        score.recall, pose_error(truth, found), seconds.count());
        }
}
