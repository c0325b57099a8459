// A run in which near-zero shapes came between ordinary ones took 158 s before the levels were bounded: a query walks all
// cells of the smallest level that it reaches over. Bounding them by the first shape alone does not help if that is the tiny
// one; here the bound follows the median, chosen anew whenever the number of balls has doubled.

#include "growth/surface/sphere_grid.h"

#include <algorithm>

namespace rinceau {
namespace {

constexpr int levels_below_median = 3;

int level_of(double radius) {
    constexpr double smallest = 1e-290;  // keeps the cell a normal number
    return static_cast<int>(std::ceil(std::log2(std::max(2 * radius, smallest))));
}

}  // namespace

void SphereGrid::hook(int ball) {
    Ball& b = balls_[static_cast<std::size_t>(ball)];
    const int number = std::max(b.natural_level, floor_);
    auto level = std::lower_bound(levels_.begin(), levels_.end(), number,
                                  [](const Level& l, int wanted) { return l.number < wanted; });
    if (level == levels_.end() || level->number != number) {
        const auto index = static_cast<int>(level - levels_.begin());
        for (int i = 0; i < ball; ++i)
            if (balls_[static_cast<std::size_t>(i)].level >= index) ++balls_[static_cast<std::size_t>(i)].level;
        level = levels_.insert(level, {number, std::ldexp(1.0, number)});
    }
    b.level = static_cast<int>(level - levels_.begin());
    b.before_in_level = level->last;
    level->last = ball;
    ++level->count;
    b.slot = slots_.find_or_insert(key_of(cell_of(b.centre, level->cell), number), static_cast<int>(last_in_slot_.size()));
    if (b.slot == static_cast<int>(last_in_slot_.size())) last_in_slot_.push_back(-1);
    b.before_in_slot = last_in_slot_[static_cast<std::size_t>(b.slot)];
    last_in_slot_[static_cast<std::size_t>(b.slot)] = ball;
}

void SphereGrid::choose_floor() {
    std::vector<int> natural;
    natural.reserve(balls_.size());
    for (const Ball& ball : balls_) natural.push_back(ball.natural_level);
    const auto middle = natural.begin() + static_cast<std::ptrdiff_t>(natural.size() / 2);
    std::nth_element(natural.begin(), middle, natural.end());
    next_choice_ = 2 * size();
    const int floor = *middle - levels_below_median;
    if (floor == floor_) return;
    floor_ = floor;
    levels_.clear();
    slots_.clear();
    last_in_slot_.clear();
    for (int i = 0; i < size(); ++i) hook(i);
}

int SphereGrid::add(SpacePoint centre, double radius) {
    const int ball = size();
    balls_.push_back({.centre = centre, .radius = radius, .natural_level = level_of(radius)});
    if (ball == 0) {
        floor_ = balls_.front().natural_level - levels_below_median;
        next_choice_ = 1;
    }
    hook(ball);
    if (size() >= next_choice_) choose_floor();
    return ball;
}

void SphereGrid::remove_from(int first) {
    while (size() > std::max(first, 0)) {
        const Ball& last = balls_.back();
        last_in_slot_[static_cast<std::size_t>(last.slot)] = last.before_in_slot;
        Level& level = levels_[static_cast<std::size_t>(last.level)];
        level.last = last.before_in_level;
        --level.count;
        balls_.pop_back();
    }
}

}  // namespace rinceau
