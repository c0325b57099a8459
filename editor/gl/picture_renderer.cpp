#include "editor/gl/picture_renderer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>

#include "editor/gl/picture_layer.h"
#include "editor/gl/plan_drawer.h"
#include "editor/gl/screen_programs.h"
#include "editor/gl/shape_store.h"

namespace rinceau {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto frame_time = std::chrono::milliseconds(20);         // for refining, so that with the panels a frame takes 30
constexpr auto fragment_patience = std::chrono::milliseconds(10);  // better than drawing the same again
constexpr int needed_version = 33;

int checked_version() {
    if (epoxy_gl_version() < needed_version) throw std::runtime_error("OpenGL 3.3 is needed");
    return epoxy_gl_version();
}

/// What a frame depends on, besides how far its layers are.
struct FrameKey {
    std::shared_ptr<const DerivedPicture> picture;
    ViewTransform view;
    PictureEmphasis emphasis;
    PictureSurround surround;
};

bool same_frame(const FrameKey& a, const FrameKey& b) {
    return a.picture == b.picture && a.view == b.view && a.surround == b.surround &&
           same_flags(a.emphasis.lit, b.emphasis.lit) && same_flags(a.emphasis.outlined, b.emphasis.outlined) &&
           a.emphasis.before == b.emphasis.before && a.emphasis.comparison == b.emphasis.comparison;
}

std::unordered_map<std::uint32_t, FragmentPlace> fragment_places(const LookTable& table, const ViewTransform& view) {
    std::unordered_map<std::uint32_t, FragmentPlace> places;
    if (!table.has_verbatim) return places;
    for (std::size_t i = 0; i < table.picture->items.size(); ++i) {
        const PictureItem& item = table.picture->items[i];
        const LookEntry& look = table.looks[static_cast<std::size_t>(item.look)];
        if (!look.verbatim) continue;
        const PictureLook& drawn = table.picture->looks[static_cast<std::size_t>(item.look)];
        const Box& box = table.picture->grammar->terminals[static_cast<std::size_t>(drawn.terminal)].verbatim_box;
        auto place = fragment_place(look.verbatim, box, item.pose, view);
        if (place) places.emplace(static_cast<std::uint32_t>(i), std::move(*place));
    }
    return places;
}

/// The canvas in pixels of the frame, from its lower left corner; empty = all of it.
Box canvas_pixels(const DerivedPicture* picture, const ViewTransform& view) {
    if (picture == nullptr) return {view.size, view.size};  // nothing is canvas
    const Box& canvas = picture->grammar->canvas;
    if (is_empty(canvas) || width(canvas) <= 0 || height(canvas) <= 0) return {};
    const auto pixel = [&](Point p) { return 0.5 * view.size + view.zoom * (p - view.center); };
    return {pixel(canvas.low), pixel(canvas.high)};
}

}  // namespace

struct PictureRenderer::Parts {
    int version = checked_version();  // before anything else is made
    ScreenPrograms screen;
    PlanDrawer drawer;
    ShapeStore shapes;
    FragmentStore fragments;
    PixelTarget frame{PixelFormat::bytes, false};
    std::shared_ptr<PreparedPicture> shown, compared;
    PictureLayer picture, lit, before, mask;
    std::string shortcoming;
    std::optional<FrameKey> drawn;  ///< what the frame shows
    bool refining = false;

    std::shared_ptr<PreparedPicture> prepared(const std::shared_ptr<const DerivedPicture>& wanted,
                                              const std::shared_ptr<PreparedPicture>& old) {
        if (!wanted) return nullptr;
        for (const auto& known : {old, shown, compared})
            if (known && known->looks.picture == wanted) return known;
        auto made = std::make_shared<PreparedPicture>();
        made->looks = look_table(wanted, shapes);
        upload_gradients(made->gradients, made->looks.gradients);
        return made;
    }

    /// Where the fragments of both pictures fall, and their pixels as far as they are there.
    void prepare_fragments(const ViewTransform& view, bool finish) {
        std::vector<FragmentPlace> all;
        for (const auto& one : {shown, compared}) {
            if (!one) continue;
            one->fragments = fragment_places(one->looks, view);
            for (const auto& [item, place] : one->fragments) all.push_back(place);
        }
        if (!finish && fragments.waiting()) fragments.wait(fragment_patience);
        fragments.prepare(all, finish);
        refining = refining || fragments.waiting();
    }

    void refine(const ViewTransform& view, const PictureEmphasis& emphasis, bool finish) {
        const auto deadline = Clock::now() + frame_time;
        const LayerTools tools{drawer, shapes, screen, fragments};
        const auto turn = [&](PictureLayer& layer, const LayerContent& content) {
            layer.show(content, view);
            layer.refine(tools, deadline, finish);
            refining = refining || !layer.finished();
        };
        refining = false;
        prepare_fragments(view, finish);
        const bool compares = emphasis.before && emphasis.comparison != PictureComparison::none;
        turn(lit, emphasis.lit ? LayerContent{shown, emphasis.lit, false} : LayerContent{});
        turn(mask, emphasis.outlined ? LayerContent{shown, emphasis.outlined, true} : LayerContent{});
        turn(picture, {shown, nullptr, false});
        turn(before, compares ? LayerContent{compared, nullptr, false} : LayerContent{});
    }

    FrameParts frame_parts(const ViewTransform& view, const PictureEmphasis& emphasis,
                           const PictureSurround& surround) const {
        return {.picture = picture.result(),
                .lit = lit.result(),
                .fades = emphasis.lit != nullptr,
                .before = before.result(),
                .difference = emphasis.comparison == PictureComparison::difference,
                .mask = mask.result(),
                .canvas = canvas_pixels(shown ? shown->looks.picture.get() : nullptr, view),
                .ground = surround.ground,
                .accent = surround.accent,
                .outside_fade = static_cast<float>(surround.outside_fade)};
    }
};

PictureRenderer::PictureRenderer() : parts_(std::make_unique<Parts>()) {}
PictureRenderer::~PictureRenderer() = default;
bool PictureRenderer::refining() const { return parts_->refining; }
const std::string& PictureRenderer::shortcoming() const { return parts_->shortcoming; }

unsigned PictureRenderer::draw(const std::shared_ptr<const DerivedPicture>& picture, const ViewTransform& view,
                               const PictureEmphasis& emphasis, const PictureDrawOptions& options) {
    Parts& parts = *parts_;
    const FrameKey wanted{picture, view, emphasis, options.surround};
    if (parts.drawn && !parts.refining && same_frame(*parts.drawn, wanted)) return parts.frame.texture();
    parts.drawn = wanted;
    parts.shown = parts.prepared(picture, parts.shown);
    parts.compared = parts.prepared(emphasis.before, parts.compared);
    parts.refine(view, emphasis, options.finish);
    parts.frame.resize(std::max(1, static_cast<int>(view.size.x)), std::max(1, static_cast<int>(view.size.y)));
    parts.screen.compose(parts.frame, parts.frame_parts(view, emphasis, options.surround));
    parts.drawer.forget_unused_meshes();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return parts.frame.texture();
}

}  // namespace rinceau
