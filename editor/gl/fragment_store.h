#pragma once
// Verbatim fragments as textures, drawn as they fall on the frame; while the view moves, by the pixels that there are.

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "editor/gl/fragment_raster.h"
#include "editor/gl/fragment_worker.h"
#include "editor/gl/gl_handle.h"
#include "editor/gl/shader.h"

namespace rinceau {

class FragmentStore {
  public:
    FragmentStore();

    /// To be called before each frame with all that it shows. With `finish`, all of it is there afterwards.
    void prepare(const std::vector<FragmentPlace>& places, bool finish);

    /// Grows when something looks different from before.
    std::uint64_t version() const { return version_; }
    /// Is something of the last frame still being drawn?
    bool waiting() const { return waiting_; }
    /// Returns when more of it has been drawn, or after so long.
    void wait(std::chrono::milliseconds longest) { worker_.wait(longest); }
    /// Fragments of the last frame that cannot be drawn, or that the bound on memory leaves out.
    std::size_t left_out() const { return left_out_; }

    /// Draws a fragment into the bound framebuffer of so many pixels, at the depth of an item's place in paint order.
    void draw(const FragmentPlace& place, int width, int height, std::uint32_t item, bool mask);

  private:
    struct Raster {
        FragmentPlace place;
        GlTexture texture;
        bool drawable = false;
        std::uint64_t last_use = 0;
    };
    /// That shows the place as it is, or else as well as there is one; null = none.
    Raster* best(const FragmentPlace& place);
    void add(FragmentPixels pixels);
    void forget_unused();

    std::unordered_multimap<const std::string*, std::unique_ptr<Raster>> rasters_;
    std::uint64_t version_ = 0;
    std::uint64_t now_ = 0;
    std::size_t pixels_ = 0;
    std::size_t left_out_ = 0;
    bool waiting_ = false;
    GlVertexArray no_vertices_;
    GlProgram program_;
    FragmentWorker worker_;
};

}  // namespace rinceau
