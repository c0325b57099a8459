#include "editor/gl/thumbnails.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "editor/gl/look_paint.h"
#include "editor/gl/picture_renderer.h"
#include "editor/gl/pixel_target.h"
#include "editor/gl/screen_programs.h"
#include "editor/gl/shape_store.h"
#include "scene/element.h"

namespace rinceau {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto time_a_frame = std::chrono::milliseconds(8);
constexpr std::size_t most_kept = 2048;
constexpr double filled_share = 0.86;  // of the square
constexpr double nearly_white = 0.85;
constexpr Color white{255, 255, 255};
constexpr Color grey{96, 96, 96};

/// What makes a thumbnail look as it does. Shape and text are shared by content.
struct ThumbnailKey {
    std::shared_ptr<const Shape> shape;
    std::shared_ptr<const std::string> verbatim;
    std::vector<double> paint;
    int pixels = 0;
    friend auto operator<=>(const ThumbnailKey&, const ThumbnailKey&) = default;
};

void add_color(std::vector<double>& numbers, const Color& color, double opacity) {
    for (const std::uint8_t channel : {color.red, color.green, color.blue}) numbers.push_back(channel);
    numbers.push_back(opacity);
}

void add_gradient(std::vector<double>& numbers, const Gradient& gradient) {
    const Affine& map = gradient.map;
    numbers.insert(numbers.end(), {static_cast<double>(gradient.kind), static_cast<double>(gradient.spread), map.a, map.b,
                                   map.c, map.d, map.e, map.f, gradient.focus.x, gradient.focus.y, gradient.focal_radius});
    for (const GradientStop& stop : gradient.stops) {
        numbers.push_back(stop.offset);
        add_color(numbers, stop.color, stop.opacity);
    }
}

std::vector<double> paint_numbers(const LookPaint& paint) {
    std::vector<double> numbers{paint.opacity, static_cast<double>(paint.upper), paint.crisp ? 1.0 : 0.0};
    for (const PartPaint& part : paint.parts) {
        add_color(numbers, part.color, part.painted ? part.opacity : 0);
        if (part.painted && part.gradient) add_gradient(numbers, *part.gradient);
    }
    return numbers;
}

double lightness(const Color& color) {
    constexpr double full = 255;
    return (0.299 * color.red + 0.587 * color.green + 0.114 * color.blue) / full;
}

/// Is all that it paints so light that white hides it?
bool is_nearly_white(const LookPaint& paint) {
    return std::ranges::none_of(paint.parts, [](const PartPaint& part) {
        if (!part.painted) return false;
        if (!part.gradient) return lightness(part.color) < nearly_white;
        return std::ranges::any_of(part.gradient->stops,
                                   [](const GradientStop& stop) { return lightness(stop.color) < nearly_white; });
    });
}

/// The look alone, at the origin, turned as in the picture, on a canvas that is out of sight.
std::shared_ptr<const DerivedPicture> single_picture(const Terminal& terminal, const Style& style, const Similarity& pose) {
    Grammar grammar;
    constexpr double out_of_sight = 1e12;
    grammar.canvas = {{out_of_sight, out_of_sight}, {out_of_sight + 1, out_of_sight + 1}};
    grammar.styles.push_back({.number = 1, .style = style});
    grammar.terminals.push_back(terminal);
    auto picture = std::make_shared<DerivedPicture>();
    picture->grammar = std::make_shared<const Grammar>(std::move(grammar));
    picture->looks.push_back({0, 1});
    picture->items.push_back({pose, 0, 0, {}});
    return picture;
}

Box drawn_box(const Terminal& terminal, const Style& style, const Similarity& pose) {
    Element element;
    element.paths = transformed(terminal.paths, pose);
    element.style = transformed(style, pose);
    if (terminal.verbatim.empty()) return painted_box(element);
    Box box;
    const Box& own = terminal.verbatim_box;
    if (is_empty(own)) return box;
    for (const Point corner : {own.low, own.high, Point{own.low.x, own.high.y}, Point{own.high.x, own.low.y}})
        box = including(box, apply(pose, corner));
    return box;
}

ViewTransform fitted_square(const Box& box, int pixels) {
    constexpr double unknown_size = 100;
    const double longest = std::max(width(box), height(box));
    ViewTransform view;
    view.size = {static_cast<double>(pixels), static_cast<double>(pixels)};
    view.center = is_empty(box) ? Point{} : center(box);
    view.zoom = filled_share * pixels / (longest > 0 ? longest : unknown_size);
    return view;
}

}  // namespace

struct ThumbnailRenderer::Parts {
    PictureRenderer renderer;
    ShapeStore shapes;
    ScreenPrograms screen;
    std::map<ThumbnailKey, PixelTarget> textures;
    Clock::time_point deadline = Clock::now() + time_a_frame;
    bool waiting = false;

    // Of the picture that was asked for last.
    std::shared_ptr<const DerivedPicture> picture;
    std::vector<Similarity> first_poses;  ///< by look
    std::map<std::pair<int, int>, unsigned> of_look;

    void know(const std::shared_ptr<const DerivedPicture>& wanted) {
        if (picture == wanted) return;
        picture = wanted;
        of_look.clear();
        first_poses.assign(picture->looks.size(), {});
        std::vector<char> known(picture->looks.size(), 0);
        std::size_t missing = known.size();
        for (auto item = picture->items.begin(); item != picture->items.end() && missing > 0; ++item) {
            const auto look = static_cast<std::size_t>(item->look);
            if (known[look] != 0) continue;
            known[look] = 1;
            --missing;
            first_poses[look] = item->pose;
        }
    }

    ThumbnailKey key(const Terminal& terminal, const Style& style, int pixels) {
        ThumbnailKey key{.shape = nullptr, .verbatim = nullptr, .paint = {}, .pixels = pixels};
        if (!terminal.verbatim.empty()) {
            key.verbatim = shapes.text(terminal.verbatim);
            return key;
        }
        const LookPaint paint = look_paint(style);
        key.shape = shapes.shape(terminal.paths, style, paint);
        key.paint = paint_numbers(paint);
        return key;
    }

    PixelTarget drawn(const Terminal& terminal, const Style& style, Similarity pose, int pixels) {
        pose.translation = {};
        const bool light = terminal.verbatim.empty() && is_nearly_white(look_paint(style));
        const PictureSurround surround{.ground = light ? grey : white, .accent = {}, .outside_fade = 0};
        const unsigned frame =
            renderer.draw(single_picture(terminal, style, pose), fitted_square(drawn_box(terminal, style, pose), pixels), {},
                          {.surround = surround, .finish = true});
        PixelTarget copy(PixelFormat::bytes, false);
        copy.resize(pixels, pixels);
        screen.add(copy, frame, true);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        return copy;
    }
};

ThumbnailRenderer::ThumbnailRenderer() : parts_(std::make_unique<Parts>()) {}
ThumbnailRenderer::~ThumbnailRenderer() = default;
bool ThumbnailRenderer::waiting() const { return parts_->waiting; }

void ThumbnailRenderer::begin_frame() {
    parts_->deadline = Clock::now() + time_a_frame;
    parts_->waiting = false;
}

std::optional<unsigned> ThumbnailRenderer::thumbnail(const std::shared_ptr<const DerivedPicture>& picture, int look,
                                                     int pixels) {
    Parts& parts = *parts_;
    parts.know(picture);
    const auto known = parts.of_look.find({look, pixels});
    if (known != parts.of_look.end()) return known->second;
    const PictureLook& shown = picture->looks[static_cast<std::size_t>(look)];
    const Terminal& terminal = picture->grammar->terminals[static_cast<std::size_t>(shown.terminal)];
    const Style style = picture_style(*picture, shown);
    const ThumbnailKey key = parts.key(terminal, style, pixels);
    auto texture = parts.textures.find(key);
    if (texture == parts.textures.end()) {
        if (Clock::now() > parts.deadline) {
            parts.waiting = true;
            return {};
        }
        if (parts.textures.size() >= most_kept) {
            parts.textures.clear();
            parts.of_look.clear();
        }
        const Similarity& pose = parts.first_poses[static_cast<std::size_t>(look)];
        texture = parts.textures.emplace(key, parts.drawn(terminal, style, pose, pixels)).first;
    }
    parts.of_look[{look, pixels}] = texture->second.texture();
    return texture->second.texture();
}

}  // namespace rinceau
