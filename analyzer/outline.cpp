#include "analyzer/outline.h"

namespace rinceau {

namespace {

void add_piece(Outline& outline, Point from, const Segment& segment) {
    const Point origin = outline.origin;
    OutlinePiece piece;
    piece.straight = segment.straight;
    piece.curve = segment.straight ? CubicBezier{from - origin, from - origin, segment.to - origin, segment.to - origin}
                                   : CubicBezier{from - origin, segment.control1 - origin, segment.control2 - origin,
                                                 segment.to - origin};
    const bool has_length = piece.curve.from != piece.curve.to || piece.curve.control1 != piece.curve.from ||
                            piece.curve.control2 != piece.curve.from;
    if (has_length) outline.pieces.push_back(piece);
}

}  // namespace

Outline outline_of(const std::vector<Path>& paths, const Style& style) {
    const bool fill_closes = !paints_stroke(style);
    Outline outline;
    if (paths.empty()) return outline;
    outline.origin = paths.front().start;
    for (const Path& path : paths) {
        Point at = path.start;
        for (const Segment& segment : path.segments) {
            add_piece(outline, at, segment);
            at = segment.to;
        }
        if (path.closed || fill_closes) add_piece(outline, at, line_to(path.start));
    }
    return outline;
}

OutlinePiece in_frame(const OutlinePiece& piece, Point center, double unit) {
    const double k = 1 / unit;
    const CubicBezier& c = piece.curve;
    return {{k * (c.from - center), k * (c.control1 - center), k * (c.control2 - center), k * (c.to - center)},
            piece.straight};
}

}  // namespace rinceau
