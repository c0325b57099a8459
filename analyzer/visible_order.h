#pragma once
// Can it be seen which of two elements is painted first? (docs/analysis.md, 8)

#include <cstddef>

#include "analyzer/painted_samples.h"
#include "scene/element.h"

namespace rinceau {

/// Both elements are painted alone, in one order and in the other, and the two pictures compared in squares one pixel wide.
/// A square differs if in a channel, on white or on black ground, it is further than `channel_difference` from every square
/// of the other picture that is moved by less than `blur` pixels: an edge that stands a little elsewhere is not seen, a hair
/// that is gone is. The order is visible if squares differ on more than a speck: on as much as two thirds of a pixel in
/// black and white make differ. Where both have the same colour or only one paints, nothing differs; the ground plays no
/// part.
struct VisibleOrderOptions {
    double channel_difference = 16.0 / 255;
    /// Points looked at before the order is taken as visible; a bound on the time for two long outlines side by side.
    std::size_t max_samples = 400'000;
};

struct VisibleOrder {
    bool visible = false;
    std::size_t samples = 0;  ///< points looked at
};

/// Do elements with these painted boxes overlap by so little that no pixel changes enough, whatever their colours?
bool too_thin_to_see(const Box& a, const Box& b, double pixel, const VisibleOrderOptions& options = {});

/// The deviation of polylines that is fine enough for pictures with this pixel.
double sampling_deviation(double pixel);

/// `pixel` > 0 is a scene length. Dashes: visible if it is so with a solid stroke or without.
VisibleOrder visible_order(const PaintedElement& a, const PaintedElement& b, double pixel,
                           const VisibleOrderOptions& options = {});

/// The same for elements as they are: one that paints nothing hides nothing, a verbatim one always counts as visible.
bool order_can_be_seen(const Element& a, const Element& b, double pixel, const VisibleOrderOptions& options = {});

}  // namespace rinceau
