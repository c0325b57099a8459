#include "editor/gl/picture_layer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rinceau {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int smooth_passes = 16;
constexpr int mask_passes = 4;
constexpr double zoom_ahead = 1.19;   // a plan is fine enough for a zoom larger by a quarter octave,
constexpr double zoom_behind = 0.45;  // and not too fine for one smaller by this
constexpr double region_ahead = 0.2;  // of the view's size, on each side: what a plan holds beyond the view
constexpr auto planning_time = std::chrono::milliseconds(40);

/// The bits of k behind the binary point, in reverse (van der Corput).
double radical_inverse(unsigned k) {
    double value = 0;
    for (double place = 0.5; k != 0; k >>= 1U, place /= 2) value += (k & 1U) != 0 ? place : 0;
    return value;
}

/// The second coordinate of Sobol's sequence: with the first one, any 2^n points in a row are evenly spread.
double sobol(unsigned k) {
    std::uint32_t value = 0;
    for (std::uint32_t direction = 1U << 31U; k != 0; k >>= 1U, direction ^= direction >> 1U)
        if ((k & 1U) != 0) value ^= direction;
    return std::ldexp(static_cast<double>(value), -32);
}

/// In a square of one pixel about the middle; the first is near the middle, so that it alone looks right.
Point jitter(int pass) {
    const auto k = static_cast<unsigned>(pass);
    const double half_cell = 0.5 / smooth_passes;
    const auto about_middle = [&](double x) { return std::fmod(x + 0.5, 1.0) - 0.5 + half_cell; };
    return {about_middle(radical_inverse(k)), about_middle(sobol(k))};
}

Box view_box(const ViewTransform& view) {
    const Point half = (0.5 / view.zoom) * view.size;
    return {view.center - half, view.center + half};
}

}  // namespace

PictureLayer::PictureLayer() : pass_(PixelFormat::bytes, true), sum_(PixelFormat::halves, false) {}

void PictureLayer::start_anew() {
    passes_ = 0;
    in_pass_ = false;
    cursor_ = {};
}

void PictureLayer::show(const LayerContent& content, const ViewTransform& view) {
    if (content == content_ && view == view_) return;
    if (content != content_) planned_ = false;
    content_ = content;
    view_ = view;
    start_anew();
}

bool PictureLayer::plan_fits() const {
    return planned_ && contains(planned_region_, view_box(view_)) && view_.zoom <= planned_zoom_ &&
           view_.zoom >= zoom_behind * planned_zoom_;
}

void PictureLayer::plan(const LayerTools& tools, bool finish) {
    const Box seen = view_box(view_);
    planned_region_ = grown(seen, region_ahead * std::max(width(seen), height(seen)));
    planned_zoom_ = zoom_ahead * view_.zoom;
    const PlanRequest request{.region = planned_region_,
                              .zoom = planned_zoom_,
                              .only = content_.only.get(),
                              .deadline = finish ? Clock::time_point::max() : Clock::now() + planning_time};
    upload_plan(uploaded_, draw_plan(content_.picture->looks, request, tools.shapes));
    planned_ = true;
    start_anew();
}

bool PictureLayer::draw_pass(const LayerTools& tools, Clock::time_point deadline) {
    pass_.bind();
    if (!in_pass_) {
        glClearColor(0, 0, 0, 0);
        glClearDepth(1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        in_pass_ = true;
        cursor_ = {};
    }
    const PlanPass pass{.looks = content_.picture->looks,
                        .gradients = content_.picture->gradients,
                        .view = view_,
                        .jitter = jitter(passes_),
                        .one_color = content_.mask,
                        .fragment = [&](std::uint32_t item) {
                            const auto place = content_.picture->fragments.find(item);
                            if (place == content_.picture->fragments.end()) return;
                            tools.fragments.draw(place->second, pass_.width(), pass_.height(), item, content_.mask);
                        }};
    if (!tools.drawer.draw(uploaded_, pass, cursor_, deadline)) return false;
    in_pass_ = false;
    return true;
}

void PictureLayer::refine(const LayerTools& tools, Clock::time_point deadline, bool finish) {
    if (!content_.picture) return;
    const int width = std::max(1, static_cast<int>(view_.size.x));
    const int height = std::max(1, static_cast<int>(view_.size.y));
    pass_.resize(width, height);
    const bool has_fragments = !content_.picture->fragments.empty();
    if (has_fragments && fragments_version_ != tools.fragments.version()) start_anew();
    fragments_version_ = tools.fragments.version();
    if (!plan_fits() || !uploaded_.plan.complete) plan(tools, finish);
    while (!finished()) {
        const bool first = passes_ == 0;
        if (passes_ == 1 && !in_pass_) {
            sum_.resize(width, height);
            tools.screen.add(sum_, pass_.texture(), true);
        }
        if (!draw_pass(tools, first || finish ? Clock::time_point::max() : deadline)) return;
        if (!first) tools.screen.add(sum_, pass_.texture(), false);
        ++passes_;
        if (finish) continue;
        if (first) return;  // while the view moves nothing is added: a frame is one pass
        glFinish();
        if (Clock::now() > deadline) return;
    }
}

bool PictureLayer::finished() const {
    if (!content_.picture) return true;
    return planned_ && uploaded_.plan.complete && passes_ == (content_.mask ? mask_passes : smooth_passes);
}

WeightedTexture PictureLayer::result() const {
    if (!content_.picture || passes_ == 0) return {};
    if (passes_ == 1 && !in_pass_) return {pass_.texture(), 1};
    return {sum_.texture(), 1 / static_cast<float>(passes_)};
}

}  // namespace rinceau
