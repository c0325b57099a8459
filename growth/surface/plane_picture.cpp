// The way along a picture's edges is that of its structure tensor (Bigun & Granlund 1987): differences by the 3 x 3 operator
// of Scharr after a slight blur, J = (gx^2 - gy^2, 2 gx gy) blurred; -J is along the edges. Where the picture is flat J
// vanishes; there a hundredth of the same picture at half the size speaks, there again of a quarter, so that every pixel has
// the way of the nearest edges.

#include "growth/surface/plane_picture.h"

#include <algorithm>
#include <cmath>

#include "geometry/index.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

constexpr double widest_blur = 200;                            ///< pixels
constexpr std::array<double, 3> luma{0.2126, 0.7152, 0.0722};  ///< shares of red, green, blue (Rec. 709)

/// Values by pixel, rows from the top.
template <class Value>
struct Raster {
    int width = 0, height = 0;
    std::vector<Value> values;
    const Value& at(int x, int y) const {
        const int cx = std::clamp(x, 0, width - 1), cy = std::clamp(y, 0, height - 1);
        return values[static_cast<std::size_t>(cy) * static_cast<std::size_t>(width) + static_cast<std::size_t>(cx)];
    }
};

template <class Value>
Raster<Value> blurred(const Raster<Value>& raster, double sigma) {
    if (!(sigma > 0)) return raster;
    constexpr double reach = 3;  // standard deviations
    const int radius = static_cast<int>(std::ceil(reach * sigma));
    std::vector<double> weights;
    double sum = 0;
    for (int i = -radius; i <= radius; ++i) {
        weights.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
        sum += weights.back();
    }
    const auto pass = [&](const Raster<Value>& from, int dx, int dy) {
        Raster<Value> to{from.width, from.height, {}};
        to.values.reserve(from.values.size());
        for (int y = 0; y < from.height; ++y)
            for (int x = 0; x < from.width; ++x) {
                Value value{};
                for (int i = -radius; i <= radius; ++i)
                    value += weights[at(i + radius)] / sum * from.at(x + i * dx, y + i * dy);
                to.values.push_back(value);
            }
        return to;
    };
    return pass(pass(raster, 1, 0), 0, 1);
}

Raster<double> brightness_of(const Picture& picture) {
    Raster<double> grey{picture.width, picture.height, {}};
    const std::size_t count = picture.rgb.size() / 3;
    grey.values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        double sum = 0;
        for (std::size_t c = 0; c < 3; ++c) sum += luma[c] * picture.rgb[3 * i + c] / 255;
        grey.values.push_back(sum);
    }
    return grey;
}

/// -J of every pixel, y up.
Raster<Complex> tensors_of(const Raster<double>& grey) {
    constexpr double middle = 10.0 / 32, side = 3.0 / 32;  // of Scharr's operator
    Raster<Complex> tensors{grey.width, grey.height, {}};
    tensors.values.reserve(grey.values.size());
    for (int y = 0; y < grey.height; ++y)
        for (int x = 0; x < grey.width; ++x) {
            const auto difference = [&](int dx, int dy) {
                const auto step = [&](int across) {
                    return grey.at(x + dx + across * dy, y + dy + across * dx) -
                           grey.at(x - dx + across * dy, y - dy + across * dx);
                };
                return middle * step(0) + side * (step(1) + step(-1));
            };
            const Complex slope{difference(1, 0), -difference(0, 1)};
            tensors.values.push_back(-(slope * slope));
        }
    return tensors;
}

Raster<Complex> halved(const Raster<Complex>& fine) {
    Raster<Complex> coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
    for (int y = 0; y < coarse.height; ++y)
        for (int x = 0; x < coarse.width; ++x)
            coarse.values.push_back((fine.at(2 * x, 2 * y) + fine.at(2 * x + 1, 2 * y) + fine.at(2 * x, 2 * y + 1) +
                                     fine.at(2 * x + 1, 2 * y + 1)) /
                                    4);
    return coarse;
}

/// x, y in pixels from the middle of the first.
template <class Value>
Value between(const Raster<Value>& raster, double x, double y) {
    x = std::clamp(x, 0.0, raster.width - 1.0);
    y = std::clamp(y, 0.0, raster.height - 1.0);
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const double u = x - i, v = y - j;
    return (1 - v) * ((1 - u) * raster.at(i, j) + u * raster.at(i + 1, j)) +
           v * ((1 - u) * raster.at(i, j + 1) + u * raster.at(i + 1, j + 1));
}

Raster<Complex> with_coarser(Raster<Complex> fine) {
    constexpr double share = 0.01;
    if (fine.width <= 1 && fine.height <= 1) return fine;
    const Raster<Complex> coarse = with_coarser(halved(fine));
    for (int y = 0; y < fine.height; ++y)
        for (int x = 0; x < fine.width; ++x)
            fine.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(fine.width) + static_cast<std::size_t>(x)] +=
                share * between(coarse, (x - 0.5) / 2, (y - 0.5) / 2);
    return fine;
}

/// In pixels from the middle of the first, rows downwards.
Point in_pixels(const PlanePicture& picture, Point place) {
    const double side = pixel_side(picture);
    return {(place.x - picture.box.low.x) / side - 0.5, (picture.box.high.y - place.y) / side - 0.5};
}

/// The four pixels about a place and their weights.
struct PixelShares {
    std::array<std::size_t, 4> pixel;
    std::array<double, 4> weight;
};

PixelShares shares_at(const PlanePicture& picture, Point place) {
    const Point p = in_pixels(picture, place);
    const double x = std::clamp(p.x, 0.0, picture.pixels.width - 1.0), y = std::clamp(p.y, 0.0, picture.pixels.height - 1.0);
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const int right = std::min(i + 1, picture.pixels.width - 1), below = std::min(j + 1, picture.pixels.height - 1);
    const auto id = [&](int column, int row) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.pixels.width) +
               static_cast<std::size_t>(column);
    };
    const double u = x - i, v = y - j;
    return {{id(i, j), id(right, j), id(i, below), id(right, below)}, {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v}};
}

}  // namespace

Complex edges_along(const PlanePicture& picture, Point place) {
    const PixelShares shares = shares_at(picture, place);
    Complex sum;
    for (std::size_t k = 0; k < 4; ++k) sum += shares.weight[k] * picture.along[shares.pixel[k]];
    return sum;
}

std::array<double, 3> colour_at(const PlanePicture& picture, Point place) {
    const PixelShares shares = shares_at(picture, place);
    std::array<double, 3> colour{};
    for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t c = 0; c < 3; ++c) colour[c] += shares.weight[k] * picture.pixels.rgb[3 * shares.pixel[k] + c];
    return colour;
}

double brightness_at(const PlanePicture& picture, Point place) {
    const auto [red, green, blue] = colour_at(picture, place);
    return (luma[0] * red + luma[1] * green + luma[2] * blue) / 255;
}

double pixel_side(const PlanePicture& picture) { return width(picture.box) / picture.pixels.width; }

PlanePicture plane_picture(Picture picture, const Box& box, const PictureEdges& edges, const std::string& label) {
    if (picture.width < 1 || picture.height < 1) throw InputError({label}, "the picture has no pixels");
    for (const double sigma : {edges.blur, edges.sigma})
        if (!(sigma >= 0 && sigma <= widest_blur))
            throw InputError({label}, "a blur of the picture is out of range; expected 0 to 200 pixels");
    Raster<Complex> tensors = with_coarser(blurred(tensors_of(blurred(brightness_of(picture), edges.blur)), edges.sigma));
    const double side = std::min(width(box) / picture.width, height(box) / picture.height);
    const Point half = side / 2 * Point{1.0 * picture.width, 1.0 * picture.height};
    PlanePicture placed{std::move(picture), std::move(tensors.values), {center(box) - half, center(box) + half}};
    double strongest = 0;
    for (const Complex z : placed.along) strongest = std::max(strongest, abs(z));
    if (strongest > 0)
        for (Complex& z : placed.along) z = z / strongest;
    return placed;
}

}  // namespace rinceau
