#include "editor/gl/plan_drawer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "editor/gl/picture_shaders.h"

namespace rinceau {
namespace {

constexpr std::size_t slice_triangles = 50'000;  // a few milliseconds in software
constexpr GLint ramp_unit = 0;
constexpr GLint table_unit = 1;

template <class Value>
void fill_buffer(GLenum target, const GlBuffer& buffer, const std::vector<Value>& values) {
    glBindBuffer(target, buffer.name());
    // A new store each time: the card may still be reading the old one.
    glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(Value)), values.data(), GL_STREAM_DRAW);
}

const void* byte_offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

void describe_stream(const UploadedPlan& uploaded) {
    glBindBuffer(GL_ARRAY_BUFFER, uploaded.stream.name());
    constexpr auto stride = static_cast<GLsizei>(sizeof(StreamVertex));
    glEnableVertexAttribArray(attribute_slot::point);
    glVertexAttribPointer(attribute_slot::point, 2, GL_FLOAT, GL_FALSE, stride, nullptr);
    glEnableVertexAttribArray(attribute_slot::rank);
    glVertexAttribIPointer(attribute_slot::rank, 1, GL_UNSIGNED_INT, stride, byte_offset(offsetof(StreamVertex, rank)));
    glEnableVertexAttribArray(attribute_slot::color);
    glVertexAttribPointer(attribute_slot::color, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride,
                          byte_offset(offsetof(StreamVertex, color)));
    const bool gradients = !uploaded.plan.stream_gradients.empty();
    for (const unsigned slot : {attribute_slot::unit, attribute_slot::gradient})
        gradients ? glEnableVertexAttribArray(slot) : glDisableVertexAttribArray(slot);
    if (!gradients) return;
    glBindBuffer(GL_ARRAY_BUFFER, uploaded.stream_gradients.name());
    constexpr auto gradient_stride = static_cast<GLsizei>(sizeof(StreamGradient));
    glVertexAttribPointer(attribute_slot::unit, 2, GL_FLOAT, GL_FALSE, gradient_stride, nullptr);
    glVertexAttribIPointer(attribute_slot::gradient, 1, GL_UNSIGNED_INT, gradient_stride,
                           byte_offset(offsetof(StreamGradient, number)));
}

/// Points the attributes of the bound array to the instances from `first` on.
void describe_instances(const GlBuffer& instances, std::uint32_t first) {
    glBindBuffer(GL_ARRAY_BUFFER, instances.name());
    constexpr auto stride = static_cast<GLsizei>(sizeof(PlanInstance));
    const std::size_t start = first * sizeof(PlanInstance);
    glVertexAttribPointer(attribute_slot::pose, 4, GL_FLOAT, GL_FALSE, stride, byte_offset(start));
    glVertexAttribIPointer(attribute_slot::place, 1, GL_UNSIGNED_INT, stride,
                           byte_offset(start + offsetof(PlanInstance, place)));
    glVertexAttribPointer(attribute_slot::fill, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride,
                          byte_offset(start + offsetof(PlanInstance, fill)));
    glVertexAttribPointer(attribute_slot::stroke, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride,
                          byte_offset(start + offsetof(PlanInstance, stroke)));
}

glm::vec3 map_row(double along_x, double along_y, double shift) { return glm::vec3(along_x, along_y, shift); }

}  // namespace

void upload_plan(UploadedPlan& target, DrawPlan plan) {
    target.plan = std::move(plan);
    fill_buffer(GL_ARRAY_BUFFER, target.instances, target.plan.instances);
    fill_buffer(GL_ARRAY_BUFFER, target.stream, target.plan.stream);
    fill_buffer(GL_ARRAY_BUFFER, target.stream_gradients, target.plan.stream_gradients);
    glBindVertexArray(target.stream_array.name());
    fill_buffer(GL_ELEMENT_ARRAY_BUFFER, target.indices, target.plan.indices);
    describe_stream(target);
    glBindVertexArray(0);
}

void upload_gradients(UploadedGradients& target, const GradientTable& gradients) {
    target.any = !gradients.entries().empty();
    if (!target.any) return;
    glBindTexture(GL_TEXTURE_2D, target.ramps.name());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, ramp_texels, static_cast<GLsizei>(gradients.ramps().size()), 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, gradients.ramps().data());
    std::vector<glm::vec4> table;
    for (const GradientEntry& entry : gradients.entries()) {
        table.emplace_back(entry.kind == GradientKind::radial ? 1 : 0, static_cast<int>(entry.spread), entry.ramp, 0);
        table.emplace_back(entry.focus.x, entry.focus.y, entry.focal_radius, 0);
    }
    fill_buffer(GL_TEXTURE_BUFFER, target.table_buffer, table);
    glBindTexture(GL_TEXTURE_BUFFER, target.table.name());
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, target.table_buffer.name());
    glBindTexture(GL_TEXTURE_BUFFER, 0);
}

PlanDrawer::Program::Program(std::string_view vertex, std::string_view fragment)
    : program(vertex, fragment),
      view_scale(program.uniform("view_scale")),
      view_shift(program.uniform("view_shift")),
      one_color(program.uniform("one_color")),
      upper_part(program.uniform("upper_part")),
      to_unit(program.uniform("to_unit")),
      gradients(program.uniform("gradients")),
      gradient_table(program.uniform("gradient_table")),
      ramps(program.uniform("ramps")) {}

PlanDrawer::PlanDrawer()
    : instance_solid_(instance_vertex_shader(), solid_fragment_shader),
      instance_gradient_(instance_gradient_vertex_shader(), gradient_fragment_shader),
      stream_solid_(stream_vertex_shader(), solid_fragment_shader),
      stream_gradient_(stream_gradient_vertex_shader(), gradient_fragment_shader) {}

const PlanDrawer::Program& PlanDrawer::begin(const PlanStep& step, const UploadedPlan& uploaded,
                                             const PlanPass& pass) const {
    const bool instances = step.kind == PlanStepKind::instances;
    const Program& program = instances ? (step.gradients ? instance_gradient_ : instance_solid_)
                                       : (step.gradients ? stream_gradient_ : stream_solid_);
    program.program.use();
    const ViewTransform& view = pass.view;
    const Point clip_per_pixel{2 / view.size.x, 2 / view.size.y};
    const Point jitter = step.crisp ? Point{} : pass.jitter;
    const Point shift = view.zoom * (uploaded.plan.origin - view.center) + jitter;
    const glm::vec2 scale(clip_per_pixel.x * view.zoom, clip_per_pixel.y * view.zoom);
    const glm::vec2 clip_shift(clip_per_pixel.x * shift.x, clip_per_pixel.y * shift.y);
    glUniform2fv(program.view_scale, 1, glm::value_ptr(scale));
    glUniform2fv(program.view_shift, 1, glm::value_ptr(clip_shift));
    const glm::vec4 color(pass.one_color ? 1 : 0);
    glUniform4fv(program.one_color, 1, glm::value_ptr(color));
    if (step.gradients) {
        glUniform1i(program.ramps, ramp_unit);
        glUniform1i(program.gradient_table, table_unit);
        glActiveTexture(GL_TEXTURE0 + table_unit);
        glBindTexture(GL_TEXTURE_BUFFER, pass.gradients.table.name());
        glActiveTexture(GL_TEXTURE0 + ramp_unit);
        glBindTexture(GL_TEXTURE_2D, pass.gradients.ramps.name());
    }
    return program;
}

void PlanDrawer::draw_instances(const PlanStep& step, UploadedPlan& uploaded, const PlanPass& pass, std::uint32_t first,
                                std::uint32_t count) {
    const Program& program = begin(step, uploaded, pass);
    const LookEntry& look = pass.looks.looks[static_cast<std::size_t>(step.look)];
    glUniform1f(program.upper_part, static_cast<float>(look.paint.upper));
    if (step.gradients) {
        std::array<glm::vec3, 4> rows{};
        for (std::size_t part = 0; part < look.to_unit.size(); ++part) {
            const Affine& map = look.to_unit[part];
            rows[2 * part] = map_row(map.a, map.c, map.e);
            rows[2 * part + 1] = map_row(map.b, map.d, map.f);
        }
        glUniform3fv(program.to_unit, static_cast<GLsizei>(rows.size()), glm::value_ptr(rows.front()));
        glUniform1uiv(program.gradients, static_cast<GLsizei>(look.gradients.size()), look.gradients.data());
    }
    glBindVertexArray(meshes_.of(step.mesh).array.name());
    describe_instances(uploaded.instances, step.first + first);
    glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(step.mesh->indices.size()), GL_UNSIGNED_INT, nullptr,
                            static_cast<GLsizei>(count));
}

void PlanDrawer::draw_stream(const PlanStep& step, UploadedPlan& uploaded, const PlanPass& pass, std::uint32_t first,
                             std::uint32_t count) const {
    begin(step, uploaded, pass);
    glBindVertexArray(uploaded.stream_array.name());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                   byte_offset((step.first + first) * sizeof(std::uint32_t)));
}

namespace {

constexpr std::uint32_t corners = 3;  // of a triangle

/// Depth and blending as the step needs them.
void set_state(const PlanStep& step, bool opaque) {
    opaque ? glDisable(GL_BLEND) : glEnable(GL_BLEND);
    glDepthFunc(step.stage == PlanStage::marked ? GL_EQUAL : GL_LESS);
    const GLboolean colors = step.stage == PlanStage::mark ? GL_FALSE : GL_TRUE;
    glColorMask(colors, colors, colors, colors);
}

std::size_t triangles_each(const PlanStep& step) {
    return step.kind == PlanStepKind::instances ? std::max<std::size_t>(1, step.mesh->indices.size() / corners) : 1;
}

/// Instances or indices of the step that are drawn in one call, from the cursor on.
std::uint32_t slice_count(const PlanStep& step, const PlanCursor& cursor) {
    const auto room = static_cast<std::uint32_t>(std::max<std::size_t>(1, slice_triangles / triangles_each(step)));
    const std::uint32_t most = step.kind == PlanStepKind::instances ? room : corners * room;
    return std::min(step.count - cursor.drawn, most);
}

}  // namespace

std::size_t PlanDrawer::draw_slice(const PlanStep& step, UploadedPlan& uploaded, const PlanPass& pass, PlanCursor& cursor) {
    const bool instances = step.kind == PlanStepKind::instances;
    const std::uint32_t count = slice_count(step, cursor);
    if (step.kind == PlanStepKind::fragment) {
        pass.fragment(step.first);
    } else if (count > 0) {
        instances ? draw_instances(step, uploaded, pass, cursor.drawn, count)
                  : draw_stream(step, uploaded, pass, cursor.drawn, count);
    }
    cursor.drawn += count;
    if (cursor.drawn >= step.count) cursor = {.step = cursor.step + 1, .drawn = 0};
    return instances ? triangles_each(step) * count : count / corners;
}

bool PlanDrawer::draw(UploadedPlan& uploaded, const PlanPass& pass, PlanCursor& cursor,
                      std::chrono::steady_clock::time_point deadline) {
    const DrawPlan& plan = uploaded.plan;
    const std::size_t steps = plan.opaque.size() + plan.translucent.size();
    glEnable(GL_DEPTH_TEST);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    std::size_t triangles = 0;
    while (cursor.step < steps) {
        if (triangles >= slice_triangles) {
            glFinish();
            triangles = 0;
            if (std::chrono::steady_clock::now() > deadline) break;
        }
        const bool opaque = cursor.step < plan.opaque.size();
        const PlanStep& step = opaque ? plan.opaque[cursor.step] : plan.translucent[cursor.step - plan.opaque.size()];
        set_state(step, opaque);
        triangles += draw_slice(step, uploaded, pass, cursor);
    }
    set_state({}, true);
    glBindVertexArray(0);
    glDisable(GL_DEPTH_TEST);
    return cursor.step >= steps;
}

}  // namespace rinceau
