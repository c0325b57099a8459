// The mean value normalisation of a polygon (Floater 2003; Hormann & Floater 2006 show that it is positive inside any
// polygon) is the integral of 1 / rho over all directions, rho being the distance to the outline; 2 over it is a distance of
// first order at the outline (Belyaev, Fayolle, Pasko 2013, "Signed Lp-distance fields").

#include "growth/aggregate/smooth_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/polygon.h"

namespace rinceau {

Region oriented(Region region) {
    for (std::size_t i = 0; i < region.size(); ++i) {
        if (region[i].empty()) continue;
        int around = 0;
        for (std::size_t j = 0; j < region.size(); ++j)
            if (j != i && inside_evenodd(region[j], region[i].front())) ++around;
        const bool is_hole = around % 2 == 1;
        if ((signed_area(region[i]) < 0) != is_hole) std::ranges::reverse(region[i]);
    }
    return region;
}

double smooth_inside_distance(const Region& region, Point p) {
    double sum = 0;
    for (const std::vector<Point>& ring : region) {
        Point a = ring.back() - p;
        double length_a = abs(a);
        for (const Point corner : ring) {
            const Point b = corner - p;
            const double length_b = abs(b), cosine_part = length_a * length_b + dot(a, b);
            if (length_a == 0 || cosine_part <= 0) return 0;  // on the outline
            // tan of half the angle that the edge is seen under
            sum += (1 / length_a + 1 / length_b) * cross(a, b) / cosine_part;
            a = b;
            length_a = length_b;
        }
    }
    return sum > 0 ? 2 / sum : 0;
}

double outline_distance_at(const Region& region, Point p) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::vector<Point>& ring : region)
        for (std::size_t i = 0; i < ring.size(); ++i)
            least = std::min(least, distance_to_segment(p, ring[i], ring[(i + 1) % ring.size()]));
    return least;
}

}  // namespace rinceau
