#include "growth/aggregate/pack_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "scene/input_error.h"

namespace rinceau {
namespace {

template <class... Parts>
[[noreturn]] void refuse(const std::string& label, const Parts&... parts) {
    std::ostringstream message;
    (message << ... << parts);
    throw InputError({label}, message.str());
}

void check_domain(const PackDomain& domain, const std::string& label) {
    const bool finite = std::isfinite(diagonal(domain.box));
    if (!finite || !(width(domain.box) > 0) || !(height(domain.box) > 0))
        refuse(label, "the place to be filled has no area: give it a width and a height above 0");
    if (domain.region && !(area(*domain.region) > 0))
        refuse(label, "the region to be filled has no area: draw a closed outline");
    if (domain.region && domain.tiled)
        refuse(label, "a tile is filled from side to side: leave out either the region or the tile");
}

void check_options(const AggregateOptions& options, std::size_t shapes, const std::string& label) {
    if (!(options.min_scale > 0) || !(options.max_scale >= options.min_scale) || !std::isfinite(options.max_scale))
        refuse(label, "scales go from a smallest above 0 to a largest that is not below it, not from ", options.min_scale,
               " to ", options.max_scale);
    const auto no_angle = [](double angle) { return !std::isfinite(angle); };
    if (std::ranges::any_of(options.angles.only, no_angle) || no_angle(options.angles.low) ||
        no_angle(options.angles.high) || options.angles.low > options.angles.high)
        refuse(label, "angles go from a lower one to a higher one, and all are finite");
    if (!options.shares.empty() && options.shares.size() != shapes)
        refuse(label, "there are ", shapes, " shapes and ", options.shares.size(), " shares: give one share for each shape");
    const auto no_share = [](double share) { return !(share >= 0) || !std::isfinite(share); };
    if (std::ranges::any_of(options.shares, no_share) ||
        (!options.shares.empty() && std::accumulate(options.shares.begin(), options.shares.end(), 0.0) <= 0))
        refuse(label, "shares are not below 0, and not all of them are 0");
    if (!(options.share_tolerance >= 0)) refuse(label, "the tolerance of shares is not below 0");
}

std::vector<double> angles_to_try(const PackAngles& angles) {
    if (angles.flow) return angles_to_try({});
    if (!angles.only.empty()) return angles.only;
    constexpr int steps = 360;  // over a full turn, a degree
    std::vector<double> result;
    for (int i = 0; i <= steps; ++i) result.push_back(std::lerp(angles.low, angles.high, i / double{steps}));
    return result;
}

/// Is there an angle at which the shape's box fits into the domain's?
bool fits(const ExclusiveRegion& region, const PackDomain& domain, const std::vector<double>& angles, double scale) {
    const double domain_area = domain.region ? area(*domain.region) : width(domain.box) * height(domain.box);
    if (region.area * scale * scale > domain_area) return false;
    const Box room = domain.region ? bounds(*domain.region) : domain.box;
    constexpr double rounding = 1 + 1e-9;
    return std::ranges::any_of(angles, [&](double angle) {
        Box box;
        for (const Point p : region.rings.front()) box = including(box, polar(scale, angle) * p);
        return width(box) <= rounding * width(room) && height(box) <= rounding * height(room);
    });
}

}  // namespace

std::vector<double> checked_shares(const std::vector<ExclusiveRegion>& regions, const PackDomain& domain,
                                   const AggregateOptions& options, const std::string& label) {
    check_domain(domain, label);
    check_options(options, regions.size(), label);
    std::vector<double> shares = options.shares.empty() ? std::vector<double>(regions.size(), 1) : options.shares;
    const std::vector<double> angles = angles_to_try(options.angles);
    for (std::size_t i = 0; i < regions.size(); ++i) {
        const double reach = 4 * regions[i].radius * options.max_scale;
        if (domain.tiled && reach > std::min(width(domain.box), height(domain.box)))
            refuse(label, "a tile is at least two diameters of every shape wide and high, here ", reach,
                   ": make it larger or the shapes smaller");
        if (!fits(regions[i], domain, angles, options.min_scale)) shares[i] = 0;
    }
    if (std::ranges::all_of(shares, [](double share) { return share <= 0; }))
        refuse(label, "no shape fits into the place to be filled: make it larger or the shapes smaller");
    return shares;
}

}  // namespace rinceau
