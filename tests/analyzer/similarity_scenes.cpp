#include "analyzer/similarity_scenes.h"

#include <algorithm>
#include <limits>
#include <map>

#include "closed_loop/shapes.h"

namespace rinceau::test {

namespace {

double difference(const Similarity& a, const Similarity& b) {
    if (a.mirrored != b.mirrored) return std::numeric_limits<double>::infinity();
    return std::max(abs(a.linear - b.linear), abs(a.translation - b.translation));
}

/// Of `step` from the nearest symmetry of the look.
double distance_from_symmetry(const Similarity& step, const SymmetryGroup& symmetry) {
    if (symmetry.continuous) return std::max(std::abs(scale_of(step) - 1), abs(step.translation));
    double nearest = std::numeric_limits<double>::infinity();
    for (const Similarity& s : symmetry.elements) nearest = std::min(nearest, difference(step, s));
    return nearest;
}

double pairs(double n) { return n * (n - 1) / 2; }

}  // namespace

CopiedScene copied_scene(const std::vector<std::vector<Path>>& outlines, int count, double noise, std::uint64_t seed) {
    Random random(seed);
    CopiedScene result;
    result.scene.viewport = {{-500, -500}, {500, 500}};
    for (int i = 0; i < count; ++i) {
        const int shape = i % static_cast<int>(outlines.size());
        const Similarity pose = random_similarity(random);
        std::vector<Path> paths = redrawn(outlines[static_cast<std::size_t>(shape)], random);
        paths = transformed(shaken(std::move(paths), noise, random), pose);
        result.scene.elements.push_back(element(std::move(paths), stroked({}, scale_of(pose) / 50)));
        result.shape.push_back(shape);
        result.pose.push_back(pose);
    }
    return result;
}

PairScore pair_score(const CopiedScene& truth, const Instancing& found) {
    std::map<std::pair<int, int>, double> both;
    std::map<int, double> of_shape;
    std::map<int, double> of_look;
    for (std::size_t i = 0; i < truth.shape.size(); ++i) {
        ++both[{truth.shape[i], found.instances[i].look}];
        ++of_shape[truth.shape[i]];
        ++of_look[found.instances[i].look];
    }
    const auto sum = [](const auto& counts) {
        double total = 0;
        for (const auto& [key, n] : counts) total += pairs(n);
        return total;
    };
    return {sum(both) / sum(of_look), sum(both) / sum(of_shape)};
}

double pose_error(const CopiedScene& truth, const Instancing& found) {
    std::map<int, Similarity> reference;  // of each look: unit frame -> outline, from its first copy
    double largest = 0;
    for (std::size_t i = 0; i < truth.pose.size(); ++i) {
        const Instance& instance = found.instances[i];
        const Similarity own = inverse(truth.pose[i]) * instance.pose;
        const auto [entry, is_first] = reference.try_emplace(instance.look, own);
        if (is_first) continue;
        const SymmetryGroup& symmetry = found.looks[static_cast<std::size_t>(instance.look)].symmetry;
        largest = std::max(largest, distance_from_symmetry(inverse(entry->second) * own, symmetry));
    }
    return largest;
}

}  // namespace rinceau::test
