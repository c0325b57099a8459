#include "editor/gl/fragment_store.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <string_view>

#include "geometry/parallel.h"

namespace rinceau {
namespace {

constexpr std::size_t most_pixels = 48'000'000;  // of all textures: 192 MB
constexpr std::uint64_t frames_kept = 30;
constexpr std::size_t most_at_once = 256;  // asked for in one frame

constexpr std::string_view quad_shader = R"(#version 330 core
uniform vec4 corners[2];   // two clip places each: lower left, lower right, upper left, upper right
uniform float depth;
out vec2 texture_place;
void main() {
    vec4 pair = corners[gl_VertexID / 2];
    gl_Position = vec4(gl_VertexID % 2 == 0 ? pair.xy : pair.zw, depth, 1.0);
    texture_place = vec2(gl_VertexID % 2, gl_VertexID / 2);
}
)";

constexpr std::string_view texture_shader = R"(#version 330 core
in vec2 texture_place;
uniform sampler2D pixels;
uniform bool mask;
out vec4 result;
void main() {
    vec4 color = texture(pixels, texture_place);
    result = mask ? vec4(color.a) : color;
}
)";

std::size_t pixel_count(const PixelRect& rect) {
    return static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height);
}

void upload_pixels(const GlTexture& texture, const TransparentPicture& picture) {
    glBindTexture(GL_TEXTURE_2D, texture.name());
    // At whole pixels this reads single texels; in between, while the view moves, it is smooth.
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture.width, picture.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 picture.rgba.data());
}

}  // namespace

FragmentStore::FragmentStore() : program_(quad_shader, texture_shader) {}

FragmentStore::Raster* FragmentStore::best(const FragmentPlace& place) {
    Raster* best = nullptr;
    const auto [first, last] = rasters_.equal_range(place.text.get());
    for (auto entry = first; entry != last; ++entry) {
        Raster* raster = entry->second.get();
        if (serves(raster->place, place)) return raster;
        // Otherwise the one that was used last, the largest of these.
        const auto rank = [](const Raster& one) { return std::pair(one.last_use, pixel_count(one.place.rect)); };
        if (raster->drawable && (best == nullptr || rank(*raster) > rank(*best))) best = raster;
    }
    return best;
}

void FragmentStore::add(FragmentPixels drawn) {
    auto raster = std::make_unique<Raster>();
    raster->place = std::move(drawn.place);
    raster->drawable = drawn.pixels.has_value();
    raster->last_use = now_;
    if (drawn.pixels) upload_pixels(raster->texture, *drawn.pixels);
    pixels_ += raster->drawable ? pixel_count(raster->place.rect) : 0;
    ++version_;
    const std::string* text = raster->place.text.get();
    rasters_.emplace(text, std::move(raster));
}

void FragmentStore::forget_unused() {
    const bool crowded = pixels_ > most_pixels / 2;
    for (auto entry = rasters_.begin(); entry != rasters_.end();) {
        const Raster& raster = *entry->second;
        const std::uint64_t unused = now_ - raster.last_use;
        if (unused == 0 || (unused < frames_kept && !crowded)) {
            ++entry;
            continue;
        }
        pixels_ -= raster.drawable ? pixel_count(raster.place.rect) : 0;
        entry = rasters_.erase(entry);
    }
}

void FragmentStore::prepare(const std::vector<FragmentPlace>& places, bool finish) {
    ++now_;
    left_out_ = 0;
    for (FragmentPixels& drawn : worker_.take()) add(std::move(drawn));
    std::vector<FragmentPlace> missing;
    std::size_t wanted_pixels = 0;
    for (const FragmentPlace& place : places) {
        Raster* raster = best(place);
        if (raster != nullptr) raster->last_use = now_;
        if (raster != nullptr && serves(raster->place, place)) {
            left_out_ += raster->drawable ? 0 : 1;
            wanted_pixels += pixel_count(place.rect);
        } else if (wanted_pixels + pixel_count(place.rect) > most_pixels) {
            ++left_out_;
        } else if (finish || missing.size() < most_at_once) {
            wanted_pixels += pixel_count(place.rect);
            missing.push_back(place);
        }
    }
    forget_unused();
    if (finish) {
        std::vector<FragmentPixels> made(missing.size());
        for_each_index(missing.size(), 0, [&](std::size_t k) { made[k] = {missing[k], fragment_pixels(missing[k])}; });
        for (FragmentPixels& drawn : made) add(std::move(drawn));
        missing.clear();
    }
    waiting_ = !missing.empty();
    worker_.want(std::move(missing));
}

void FragmentStore::draw(const FragmentPlace& place, int width, int height, std::uint32_t item, bool mask) {
    const Raster* raster = best(place);
    if (raster == nullptr || !raster->drawable) return;
    const PixelRect& rect = raster->place.rect;
    const Affine moved = place.to_pixels * inverse(raster->place.to_pixels);
    const auto clip_place = [&](int x, int y) {
        Point pixel = apply(moved, {static_cast<double>(x), static_cast<double>(y)});
        if (serves(raster->place, place)) pixel = {std::round(pixel.x), std::round(pixel.y)};
        return Point{2 * pixel.x / width - 1, 1 - 2 * pixel.y / height};
    };
    std::array<glm::vec4, 2> corners{};
    for (std::size_t row = 0; row < corners.size(); ++row) {
        const int y = rect.top + (row == 0 ? 0 : rect.height);
        const Point left = clip_place(rect.left, y);
        const Point right = clip_place(rect.left + rect.width, y);
        corners[row] = {left.x, left.y, right.x, right.y};
    }
    program_.use();
    glUniform4fv(program_.uniform("corners"), static_cast<GLsizei>(corners.size()), glm::value_ptr(corners.front()));
    constexpr double depth_step = 1.0 / (1U << 23U);  // as the shaders of outlines have it
    glUniform1f(program_.uniform("depth"), static_cast<float>(1 - (2.0 * item + 1) * depth_step));
    glUniform1i(program_.uniform("mask"), mask ? 1 : 0);
    glUniform1i(program_.uniform("pixels"), 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, raster->texture.name());
    glBindVertexArray(no_vertices_.name());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace rinceau
