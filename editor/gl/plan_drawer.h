#pragma once
// Draws plans with the graphics card, whole or slice by slice.

#include <chrono>
#include <cstdint>
#include <functional>
#include <vector>

#include "editor/gl/draw_plan.h"
#include "editor/gl/gl_handle.h"
#include "editor/gl/gradient_table.h"
#include "editor/gl/mesh_buffers.h"
#include "editor/gl/shader.h"
#include "editor/model/view_transform.h"

namespace rinceau {

/// A plan with its buffers. Buffers are kept when a plan takes the place of another.
struct UploadedPlan {
    DrawPlan plan;
    GlBuffer instances, stream, stream_gradients, indices;
    GlVertexArray stream_array;
};
void upload_plan(UploadedPlan& target, DrawPlan plan);

/// Gradients of a picture on the graphics card.
struct UploadedGradients {
    GlTexture ramps, table;
    GlBuffer table_buffer;
    bool any = false;
};
void upload_gradients(UploadedGradients& target, const GradientTable& gradients);

/// How far a drawing has come.
struct PlanCursor {
    std::size_t step = 0;     ///< of the opaque ones, then of the translucent ones
    std::uint32_t drawn = 0;  ///< instances or indices of that step
};

struct PlanPass {
    const LookTable& looks;
    const UploadedGradients& gradients;
    ViewTransform view;
    Point jitter;                                      ///< pixels; edges that are crisp do not follow it
    bool one_color = false;                            ///< all in opaque white, as a mask
    std::function<void(std::uint32_t item)> fragment;  ///< draws a verbatim item; may change program and textures
};

class PlanDrawer {
  public:
    PlanDrawer();

    /// Draws into the bound framebuffer from the cursor on, until the deadline at about, but some of it in any case. True
    /// when all is drawn. Needs a depth buffer, cleared before the first slice.
    bool draw(UploadedPlan& uploaded, const PlanPass& pass, PlanCursor& cursor,
              std::chrono::steady_clock::time_point deadline);

    void forget_unused_meshes() { meshes_.forget_unused(); }

  private:
    struct Program {
        Program(std::string_view vertex, std::string_view fragment);
        GlProgram program;
        GLint view_scale, view_shift, one_color, upper_part, to_unit, gradients, gradient_table, ramps;
    };
    const Program& begin(const PlanStep& step, const UploadedPlan& uploaded, const PlanPass& pass) const;
    /// Draws some of the step and moves the cursor; the number of triangles.
    std::size_t draw_slice(const PlanStep& step, UploadedPlan& uploaded, const PlanPass& pass, PlanCursor& cursor);
    void draw_instances(const PlanStep& step, UploadedPlan& uploaded, const PlanPass& pass, std::uint32_t first,
                        std::uint32_t count);
    void draw_stream(const PlanStep& step, UploadedPlan& uploaded, const PlanPass& pass, std::uint32_t first,
                     std::uint32_t count) const;

    MeshBuffers meshes_;
    Program instance_solid_, instance_gradient_, stream_solid_, stream_gradient_;
};

}  // namespace rinceau
