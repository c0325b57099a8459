#include "growth/surface/placed_points.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace rinceau {

namespace {

constexpr std::size_t leaf_size = 16;

double beyond(double value, double low, double high) { return std::max({low - value, value - high, 0.0}); }

/// Squared; 0 inside.
double distance_to_box(SpacePoint p, SpacePoint low, SpacePoint high) {
    const double x = beyond(p.x, low.x, high.x), y = beyond(p.y, low.y, high.y), z = beyond(p.z, low.z, high.z);
    return x * x + y * y + z * z;
}

double squared(SpacePoint a) { return dot(a, a); }

}  // namespace

std::size_t PlacedPoints::child_of(const Node& node, SpacePoint p) const {
    return static_cast<std::size_t>(node.children) + (p.x < node.middle.x ? 0U : 1U) + (p.y < node.middle.y ? 0U : 2U) +
           (p.z < node.middle.z ? 0U : 4U);
}

void PlacedPoints::split(std::size_t node) {
    nodes_[node].middle = 0.5 * (nodes_[node].low + nodes_[node].high);
    nodes_[node].children = static_cast<int>(nodes_.size());
    nodes_.resize(nodes_.size() + 8);
    for (const int index : std::exchange(nodes_[node].points, {})) {
        const SpacePoint p = points_[static_cast<std::size_t>(index)];
        Node& child = nodes_[child_of(nodes_[node], p)];
        if (child.points.empty()) child.low = child.high = p;
        child.low = {std::min(child.low.x, p.x), std::min(child.low.y, p.y), std::min(child.low.z, p.z)};
        child.high = {std::max(child.high.x, p.x), std::max(child.high.y, p.y), std::max(child.high.z, p.z)};
        child.points.push_back(index);
    }
}

void PlacedPoints::add(SpacePoint p) {
    const int index = size();
    points_.push_back(p);
    if (nodes_.empty()) nodes_.push_back({p, p, p, -1, {}});
    for (std::size_t node = 0;; node = child_of(nodes_[node], p)) {
        Node& at = nodes_[node];
        if (at.children < 0 && at.points.empty()) at.low = at.high = p;
        at.low = {std::min(at.low.x, p.x), std::min(at.low.y, p.y), std::min(at.low.z, p.z)};
        at.high = {std::max(at.high.x, p.x), std::max(at.high.y, p.y), std::max(at.high.z, p.z)};
        if (at.children >= 0) continue;
        at.points.push_back(index);
        // equal points would never come apart
        if (at.points.size() > leaf_size && at.low != at.high) split(node);
        return;
    }
}

void PlacedPoints::remove_last() {
    std::size_t node = 0;
    while (nodes_[node].children >= 0) node = child_of(nodes_[node], points_.back());
    nodes_[node].points.pop_back();
    points_.pop_back();
}

std::optional<PlacedPoints::Nearest> PlacedPoints::nearest(SpacePoint p, int except) const {
    double best = std::numeric_limits<double>::infinity();
    int found = -1;
    std::vector<std::size_t> waiting;
    if (!points_.empty()) waiting.push_back(0);
    while (!waiting.empty()) {
        const Node& node = nodes_[waiting.back()];
        waiting.pop_back();
        if (distance_to_box(p, node.low, node.high) > best) continue;
        for (const int index : node.points) {
            const double distance = squared(points_[static_cast<std::size_t>(index)] - p);
            if (index == except || distance > best || (distance == best && index >= found)) continue;
            best = distance;
            found = index;
        }
        if (node.children < 0) continue;
        // the one that holds p comes off the pile first
        const std::size_t own = child_of(node, p), first = static_cast<std::size_t>(node.children);
        for (std::size_t child = first; child < first + 8; ++child)
            if (child != own) waiting.push_back(child);
        waiting.push_back(own);
    }
    if (found < 0) return std::nullopt;
    return Nearest{found, abs(points_[static_cast<std::size_t>(found)] - p)};
}

std::vector<int> PlacedPoints::within(SpacePoint p, double radius) const {
    std::vector<int> found;
    if (points_.empty() || radius < 0) return found;
    const double most = radius * radius;
    std::vector<std::size_t> waiting{0};
    while (!waiting.empty()) {
        const Node& node = nodes_[waiting.back()];
        waiting.pop_back();
        if (distance_to_box(p, node.low, node.high) > most) continue;
        for (const int index : node.points)
            if (squared(points_[static_cast<std::size_t>(index)] - p) <= most) found.push_back(index);
        if (node.children < 0) continue;
        for (std::size_t child = 0; child < 8; ++child) waiting.push_back(static_cast<std::size_t>(node.children) + child);
    }
    std::ranges::sort(found);
    return found;
}

}  // namespace rinceau
