#include "scene/path.h"

#include "geometry/cubic_bezier.h"

namespace rinceau {

namespace {

CubicBezier curve_of(Point from, const Segment& segment) { return {from, segment.control1, segment.control2, segment.to}; }

Box including_path(Box box, const Path& path) {
    box = including(box, path.start);
    Point from = path.start;
    for (const Segment& segment : path.segments) {
        box = segment.straight ? including(box, segment.to) : including(box, bounds(curve_of(from, segment)));
        from = segment.to;
    }
    return box;
}

double path_length(const Path& path) {
    double sum = 0;
    Point from = path.start;
    for (const Segment& segment : path.segments) {
        sum += segment.straight ? abs(segment.to - from) : arc_length(curve_of(from, segment));
        from = segment.to;
    }
    return path.closed ? sum + abs(path.start - from) : sum;
}

}  // namespace

Path transformed(const Path& path, const Affine& map) {
    Path image{apply(map, path.start), {}, path.closed};
    image.segments.reserve(path.segments.size());
    for (const Segment& segment : path.segments) {
        const Point to = apply(map, segment.to);
        image.segments.push_back(
            segment.straight ? line_to(to) : curve_to(apply(map, segment.control1), apply(map, segment.control2), to));
    }
    return image;
}

std::vector<Path> transformed(const std::vector<Path>& paths, const Affine& map) {
    std::vector<Path> images;
    images.reserve(paths.size());
    for (const Path& path : paths) images.push_back(transformed(path, map));
    return images;
}

std::vector<Path> transformed(const std::vector<Path>& paths, const Similarity& map) {
    return transformed(paths, to_affine(map));
}

Box bounds(const std::vector<Path>& paths) {
    Box box;
    for (const Path& path : paths) box = including_path(box, path);
    return box;
}

double length(const std::vector<Path>& paths) {
    double sum = 0;
    for (const Path& path : paths) sum += path_length(path);
    return sum;
}

std::vector<Point> flattened(const Path& path, double deviation) {
    std::vector<Point> points{path.start};
    for (const Segment& segment : path.segments) {
        if (segment.straight) {
            points.push_back(segment.to);
            continue;
        }
        const std::vector<Point> part = flattened(curve_of(points.back(), segment), deviation);
        points.insert(points.end(), part.begin(), part.end());
    }
    if (path.closed && points.size() > 1 && points.back() == path.start) points.pop_back();
    return points;
}

}  // namespace rinceau
