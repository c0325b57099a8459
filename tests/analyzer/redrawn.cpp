#include "analyzer/redrawn.h"

#include <algorithm>

#include "geometry/cubic_bezier.h"
#include "closed_loop/shapes.h"

namespace rinceau::test {

namespace {

/// With the closing line, if it has a length, as a segment of its own.
Path with_closing_line(Path path) {
    if (path.closed && !path.segments.empty() && path.segments.back().to != path.start) path.segments.push_back(line_to(path.start));
    return path;
}

Path from_other_node(const Path& path, std::size_t shift) {
    if (!path.closed || path.segments.empty()) return path;
    Path result = with_closing_line(path);
    std::rotate(result.segments.begin(),
                result.segments.begin() + static_cast<std::ptrdiff_t>(shift % result.segments.size()),
                result.segments.end());
    result.start = result.segments.back().to;
    return result;
}

Path reversed(const Path& path) {
    Path result{path.segments.empty() ? path.start : path.segments.back().to, {}, path.closed};
    for (std::size_t i = path.segments.size(); i-- > 0;) {
        const Point to = i == 0 ? path.start : path.segments[i - 1].to;
        const Segment& s = path.segments[i];
        result.segments.push_back(s.straight ? line_to(to) : curve_to(s.control2, s.control1, to));
    }
    return result;
}

Path with_splits(const Path& path, Random& random) {
    Path result{path.start, {}, path.closed};
    Point at = path.start;
    for (const Segment& s : path.segments) {
        const double t = random.uniform(0.3, 0.7);
        if (random.below(3) != 0) {
            result.segments.push_back(s);
        } else if (s.straight) {
            result.segments.push_back(line_to(at + t * (s.to - at)));
            result.segments.push_back(s);
        } else {
            const auto [a, b] = split(CubicBezier{at, s.control1, s.control2, s.to}, t);
            result.segments.push_back(curve_to(a.control1, a.control2, a.to));
            result.segments.push_back(curve_to(b.control1, b.control2, b.to));
        }
        at = s.to;
    }
    return result;
}

std::vector<Path> stretched(const std::vector<Path>& paths, double along_y) { return transformed(paths, Affine{1, 0, 0, along_y, 0, 0}); }

std::vector<Path> joined(std::vector<Path> a, const std::vector<Path>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

std::vector<Path> open_blob(int nodes, Random& random) {
    std::vector<Path> paths = blob(nodes, random);
    paths[0].closed = false;
    paths[0].segments.pop_back();
    return paths;
}

}  // namespace

std::vector<Path> redrawn(std::vector<Path> paths, Random& random) {
    for (Path& path : paths) {
        path = from_other_node(path, random.below(64));
        if (random.below(2) == 0) path = reversed(with_closing_line(path));
        path = with_splits(path, random);
    }
    if (paths.size() > 1 && random.below(2) == 0) std::ranges::reverse(paths);
    return paths;
}

std::vector<Path> shaken(std::vector<Path> paths, double noise, Random& random) {
    const auto shake = [&](Point& p) { p += {random.uniform(-noise, noise), random.uniform(-noise, noise)}; };
    for (Path& path : paths) {
        const bool meets = !path.segments.empty() && path.segments.back().to == path.start;
        shake(path.start);
        for (Segment& s : path.segments) {
            shake(s.to);
            if (s.straight) {
                s.control1 = s.control2 = s.to;
            } else {
                shake(s.control1);
                shake(s.control2);
            }
        }
        if (meets) path.segments.back().to = path.start;
    }
    return paths;
}

std::vector<Path> ellipse(double ratio) { return stretched(circle(), ratio); }

std::vector<std::vector<Path>> different_outlines() {
    Random random(70);
    std::vector<std::vector<Path>> bank;
    for (int corners = 3; corners <= 8; ++corners) bank.push_back(regular_polygon(corners));
    bank.push_back(circle());
    for (const double ratio : {0.60, 0.57, 0.3}) bank.push_back(ellipse(ratio));
    for (const double ratio : {0.60, 0.55, 0.2}) bank.push_back(rectangle(2, 2 * ratio));
    for (int points = 4; points <= 8; ++points) bank.push_back(star(points));
    bank.push_back(star(5, 0.38));
    for (int corners = 3; corners <= 6; ++corners) bank.push_back(frame(corners));
    bank.push_back(joined(circle(), circle(0.5)));
    bank.push_back(leaf());
    bank.push_back(hook());
    bank.push_back(bar());
    while (bank.size() < 45) bank.push_back(blob(4 + static_cast<int>(random.below(5)), random));
    while (bank.size() < 60) bank.push_back(open_blob(5 + static_cast<int>(random.below(4)), random));
    for (std::size_t i = 0; i < 10; ++i) bank.push_back(shaken(bank[30 + 2 * i], 0.08, random));
    return bank;
}

Similarity random_similarity(Random& random, bool mirror) {
    return {polar(random.uniform(0.3, 3), random.uniform(-pi, pi)), {random.uniform(-500, 500), random.uniform(-500, 500)},
            mirror && random.below(2) == 0};
}

}  // namespace rinceau::test
