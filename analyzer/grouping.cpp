#include "analyzer/grouping.h"

#include <algorithm>
#include <map>
#include <utility>

namespace rinceau {

namespace {

/// The elements of a wish that can be grouped.
std::vector<std::size_t> groupable(const GroupingWish& wish, const Instancing& instancing) {
    std::vector<std::size_t> elements;
    for (const int element : wish.elements) {
        const auto e = static_cast<std::size_t>(element);
        if (element < 0 || e >= instancing.instances.size()) continue;
        if (instancing.looks[static_cast<std::size_t>(instancing.instances[e].look)].verbatim.empty()) elements.push_back(e);
    }
    return elements;
}

void merge(Scene& scene, Instancing& instancing, const std::vector<std::size_t>& elements) {
    if (elements.empty()) return;
    const Element representative = scene.elements[elements.front()];
    const Instance as_drawn = instancing.instances[elements.front()];
    for (const std::size_t e : elements) {
        Instance& instance = instancing.instances[e];
        if (instance.look == as_drawn.look) continue;
        const Similarity moved = instance.pose * inverse(as_drawn.pose);
        scene.elements[e].paths = transformed(representative.paths, moved);
        scene.elements[e].style = transformed(representative.style, moved);
        instance.look = as_drawn.look;
    }
}

void split(Instancing& instancing, const std::vector<std::size_t>& elements) {
    std::vector<int> times(instancing.looks.size(), 0);
    for (const Instance& instance : instancing.instances) ++times[static_cast<std::size_t>(instance.look)];
    std::map<int, std::vector<std::size_t>> by_look;
    for (const std::size_t e : elements) by_look[instancing.instances[e].look].push_back(e);
    for (const auto& [look, members] : by_look) {
        if (members.size() == static_cast<std::size_t>(times[static_cast<std::size_t>(look)])) continue;  // they are apart
        Look own = instancing.looks[static_cast<std::size_t>(look)];
        own.shape = instancing.shapes++;
        for (const std::size_t e : members) instancing.instances[e].look = static_cast<int>(instancing.looks.size());
        instancing.looks.push_back(std::move(own));
    }
}

/// Looks in order of first appearance.
void renumber_looks(Instancing& instancing) {
    std::vector<int> number(instancing.looks.size(), -1);
    std::vector<Look> ordered;
    for (Instance& instance : instancing.instances) {
        int& n = number[static_cast<std::size_t>(instance.look)];
        if (n < 0) {
            n = static_cast<int>(ordered.size());
            ordered.push_back(instancing.looks[static_cast<std::size_t>(instance.look)]);
        }
        instance.look = n;
    }
    instancing.looks = std::move(ordered);
}

/// The look that stands for nothing but this element. An element's pose stays; nothing is known of its symmetry.
Look look_of(const Element& element, const Similarity& pose) {
    Look own;
    const Similarity back = inverse(pose);
    own.paths = transformed(element.paths, back);
    own.unit_style = transformed(element.style, back);
    own.verbatim = element.verbatim;
    return own;
}

}  // namespace

std::vector<GroupingWish> effective_wishes(std::span<const GroupingWish> wishes) {
    std::vector<GroupingWish> effective;
    for (const GroupingWish& wish : wishes) {
        GroupingWish sorted = wish;
        std::ranges::sort(sorted.elements);
        for (GroupingWish& earlier : effective)
            if (earlier.kind != wish.kind)
                std::erase_if(earlier.elements, [&](int e) { return std::ranges::binary_search(sorted.elements, e); });
        effective.push_back(wish);
    }
    std::erase_if(effective, [](const GroupingWish& wish) { return wish.elements.empty(); });
    return effective;
}

Scene with_merged_elements(Scene scene, Instancing instancing, std::span<const GroupingWish> wishes) {
    for (const GroupingWish& wish : wishes)
        if (wish.kind == GroupingKind::together) merge(scene, instancing, groupable(wish, instancing));
    return scene;
}

Instancing with_split_looks(Instancing instancing, std::span<const GroupingWish> wishes) {
    for (const GroupingWish& wish : wishes)
        if (wish.kind == GroupingKind::apart) split(instancing, groupable(wish, instancing));
    renumber_looks(instancing);
    return instancing;
}

Instancing with_lone_elements(Instancing instancing, const Scene& scene, std::span<const int> elements) {
    for (const int element : elements) {
        const auto e = static_cast<std::size_t>(element);
        Instance& instance = instancing.instances[e];
        Look own = look_of(scene.elements[e], instance.pose);
        own.shape = instancing.shapes++;
        own.style = instancing.styles++;
        instance = {static_cast<int>(instancing.looks.size()), instance.pose, 0};
        instancing.looks.push_back(std::move(own));
    }
    renumber_looks(instancing);
    return instancing;
}

}  // namespace rinceau
