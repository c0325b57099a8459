#pragma once
// One picture, or a part of it, drawn again and again with edges shifted within a pixel: the average has smooth edges.

#include <chrono>
#include <memory>
#include <unordered_map>

#include "editor/gl/fragment_store.h"
#include "editor/gl/picture_emphasis.h"
#include "editor/gl/pixel_target.h"
#include "editor/gl/plan_drawer.h"
#include "editor/gl/screen_programs.h"
#include "editor/model/view_transform.h"

namespace rinceau {

/// A picture's looks, here and on the graphics card, and where its fragments fall on the frame.
struct PreparedPicture {
    LookTable looks;
    UploadedGradients gradients;
    std::unordered_map<std::uint32_t, FragmentPlace> fragments;  ///< by item
};

struct LayerContent {
    std::shared_ptr<PreparedPicture> picture;  ///< null = nothing
    ItemFlags only;                            ///< the items drawn; null = all
    bool mask = false;                         ///< in one colour
    friend bool operator==(const LayerContent& a, const LayerContent& b) {
        return a.picture == b.picture && a.mask == b.mask && same_flags(a.only, b.only);
    }
};

/// What layers share.
struct LayerTools {
    PlanDrawer& drawer;
    ShapeStore& shapes;
    const ScreenPrograms& screen;
    FragmentStore& fragments;
};

class PictureLayer {
  public:
    PictureLayer();

    /// What it shall show; starts anew if that is something else.
    void show(const LayerContent& content, const ViewTransform& view);

    /// Draws on until the deadline. The first pass is drawn whole. With `finish`, all passes are.
    void refine(const LayerTools& tools, std::chrono::steady_clock::time_point deadline, bool finish);

    bool finished() const;
    /// Of the passes that are drawn; nothing if there is no picture.
    WeightedTexture result() const;
    std::size_t left_out() const { return content_.picture ? uploaded_.plan.left_out : 0; }

  private:
    bool plan_fits() const;
    void plan(const LayerTools& tools, bool finish);
    bool draw_pass(const LayerTools& tools, std::chrono::steady_clock::time_point deadline);
    void start_anew();

    LayerContent content_;
    ViewTransform view_;
    bool planned_ = false;
    Box planned_region_;
    double planned_zoom_ = 0;
    UploadedPlan uploaded_;
    PixelTarget pass_, sum_;
    PlanCursor cursor_;
    bool in_pass_ = false;
    int passes_ = 0;
    std::uint64_t fragments_version_ = 0;
};

}  // namespace rinceau
