#pragma once
// The geometric check behind every match: are two outlines within a distance of each other, everywhere and both ways?

#include <optional>
#include <vector>

#include "analyzer/outline.h"
#include "geometry/similarity.h"

namespace rinceau {

/// A short straight part of a piece, ends on the curve.
struct OutlineEdge {
    Point from, to;
    int piece = 0;
    double t_from = 0, t_to = 1;  ///< parameters of the ends on the piece
    bool last_of_line = false;    ///< the next edge does not start where this one ends
};

/// An outline cut into short edges in its unit frame (centroid at the origin, rms radius 1).
struct FineOutline {
    std::vector<OutlinePiece> pieces;
    std::vector<OutlineEdge> edges;  ///< no longer than 0.15, within 1e-3 of the curves
};

/// `center` is relative to the outline's origin; unit > 0.
FineOutline fine_outline(const Outline& outline, Point center, double unit);

/// Does every point of `a` under `map` lie within `distance` of `b`, and every point of `b` within `distance` of the image
/// of `a`? Tested at the ends of all edges, which are no further apart than 0.15 units, against the true curves.
/// |map.linear| must be near 1.
bool within_distance(const FineOutline& a, const Similarity& map, const FineOutline& b, double distance);

/// `map` improved by least squares of the distances from the image of `a` to the curves of `b` (two Gauss-Newton steps;
/// distances along the curve count little). For exact copies it stays what it is.
Similarity refined(const FineOutline& a, const Similarity& map, const FineOutline& b);

}  // namespace rinceau
