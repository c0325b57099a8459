#include "scene/picture.h"

#include <algorithm>
#include <cstdlib>

namespace rinceau {

namespace {

constexpr int paper = 250;   // a pixel with all channels at least this is no ink
constexpr int visible = 32;  // levels

const std::uint8_t* pixel_at(const Picture& picture, int x, int y) {
    return picture.rgb.data() + 3 * (static_cast<std::ptrdiff_t>(y) * picture.width + x);
}

bool is_ink(const std::uint8_t* pixel) { return std::min({pixel[0], pixel[1], pixel[2]}) < paper; }

bool alike(const std::uint8_t* p, const std::uint8_t* q) {
    for (int c = 0; c < 3; ++c) {
        if (std::abs(int{p[c]} - int{q[c]}) > visible) return false;
    }
    return true;
}

/// Is there a pixel of `other` like this one, here or beside?
bool has_like(const std::uint8_t* pixel, const Picture& other, int x, int y) {
    if (alike(pixel, pixel_at(other, x, y))) return true;
    for (int v = std::max(0, y - 1); v <= std::min(other.height - 1, y + 1); ++v) {
        for (int u = std::max(0, x - 1); u <= std::min(other.width - 1, x + 1); ++u) {
            if (alike(pixel, pixel_at(other, u, v))) return true;
        }
    }
    return false;
}

}  // namespace

double picture_difference(const Picture& a, const Picture& b) {
    if (a.width != b.width || a.height != b.height) return 1;
    double ink = 0, different = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const std::uint8_t *p = pixel_at(a, x, y), *q = pixel_at(b, x, y);
            ink += is_ink(p) || is_ink(q) ? 1 : 0;
            different += has_like(p, b, x, y) && has_like(q, a, x, y) ? 0 : 1;
        }
    }
    return different / std::max(1.0, ink);
}

}  // namespace rinceau
