#include "editor/gl/surface_renderer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "editor/gl/gl_handle.h"
#include "editor/gl/pixel_target.h"
#include "editor/gl/shader.h"
#include "editor/gl/surface_shaders.h"
#include "geometry/angle.h"

namespace rinceau {
namespace {

constexpr double crease = 40 * pi / 180;  // as pictures of meshes have it
constexpr int samples = 4;                // a pixel, for smooth edges
constexpr float line_nearer = 2e-3F;      // lines before the triangles that they lie on, share of the depth
constexpr float wire_nearer = 1e-3F;

struct Vertex {
    std::array<float, 3> place, normal;
};
struct InstancePose {
    std::array<float, 3> move, scale;
    std::array<float, 4> rotation;
};

std::array<float, 3> floats(SpacePoint p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

/// Instances of one mesh.
struct Batch {
    GlVertexArray array;
    GlBuffer vertices, poses;
    GLsizei vertex_count = 0, instance_count = 0;
    Color color;
};

/// Three vertices a triangle, so that creases stay sharp.
std::vector<Vertex> vertices_of(const TriangleMesh& mesh) {
    const auto normals = corner_normals(mesh, crease);
    std::vector<Vertex> all;
    all.reserve(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const SpacePoint p = mesh.positions[static_cast<std::size_t>(mesh.triangles[t][k])];
            all.push_back({floats(p), floats(normals[t][k])});
        }
    return all;
}

InstancePose pose_of(const MeshPose& pose) {
    InstancePose packed{floats(pose.translation), floats(pose.scale), {}};
    for (std::size_t i = 0; i < 4; ++i) packed.rotation[i] = static_cast<float>(pose.rotation[i]);
    return packed;
}

template <class T>
void fill(GLenum target, const GlBuffer& buffer, const std::vector<T>& data) {
    glBindBuffer(target, buffer.name());
    glBufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), GL_STATIC_DRAW);
}

void point_at(unsigned slot, GLint count, std::size_t stride, std::size_t offset, unsigned divisor) {
    glEnableVertexAttribArray(slot);
    glVertexAttribPointer(slot, count, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(slot, divisor);
}

Batch uploaded(const std::vector<Vertex>& vertices, const std::vector<InstancePose>& poses, Color color) {
    Batch batch;
    batch.color = color;
    batch.vertex_count = static_cast<GLsizei>(vertices.size());
    batch.instance_count = static_cast<GLsizei>(poses.size());
    glBindVertexArray(batch.array.name());
    fill(GL_ARRAY_BUFFER, batch.vertices, vertices);
    point_at(surface_slot::place, 3, sizeof(Vertex), offsetof(Vertex, place), 0);
    point_at(surface_slot::normal, 3, sizeof(Vertex), offsetof(Vertex, normal), 0);
    fill(GL_ARRAY_BUFFER, batch.poses, poses);
    point_at(surface_slot::move, 3, sizeof(InstancePose), offsetof(InstancePose, move), 1);
    point_at(surface_slot::scale, 3, sizeof(InstancePose), offsetof(InstancePose, scale), 1);
    point_at(surface_slot::rotation, 4, sizeof(InstancePose), offsetof(InstancePose, rotation), 1);
    glBindVertexArray(0);
    return batch;
}

std::vector<Batch> uploaded(const MeshAssembly& assembly) {
    std::vector<std::vector<InstancePose>> poses(assembly.meshes.size());
    for (const MeshInstance& instance : assembly.instances)
        poses[static_cast<std::size_t>(instance.mesh)].push_back(pose_of(instance.pose));
    std::vector<Batch> batches;
    for (std::size_t i = 0; i < assembly.meshes.size(); ++i)
        if (!poses[i].empty())
            batches.push_back(uploaded(vertices_of(assembly.meshes[i].mesh), poses[i], assembly.meshes[i].color));
    return batches;
}

/// Two ends for each piece of each line.
Batch uploaded_lines(const std::vector<std::vector<SpacePoint>>& lines, Color color) {
    std::vector<Vertex> ends;
    for (const auto& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i) {
            ends.push_back({floats(line[i - 1]), {0, 0, 1}});
            ends.push_back({floats(line[i]), {0, 0, 1}});
        }
    return uploaded(ends, {pose_of(MeshPose{})}, color);
}

/// A picture with several samples a pixel, which becomes one with a single sample.
class SampledTarget {
  public:
    SampledTarget() {
        glGenRenderbuffers(1, &color_);
        glGenRenderbuffers(1, &depth_);
    }
    ~SampledTarget() {
        glDeleteRenderbuffers(1, &color_);
        glDeleteRenderbuffers(1, &depth_);
    }
    SampledTarget(const SampledTarget&) = delete;
    SampledTarget& operator=(const SampledTarget&) = delete;

    void bind(int width, int height) {
        if (width != width_ || height != height_) resize(width, height);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
        glViewport(0, 0, width, height);
    }
    /// The target has its size and becomes bound.
    void resolve_to(PixelTarget& target) const {
        target.resize(width_, height_);
        target.bind();
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
        glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }

  private:
    void resize(int width, int height) {
        width_ = width;
        height_ = height;
        GLint most = 0;
        glGetIntegerv(GL_MAX_SAMPLES, &most);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
        const auto attach = [&](GLuint buffer, GLenum format, GLenum where) {
            glBindRenderbuffer(GL_RENDERBUFFER, buffer);
            glRenderbufferStorageMultisample(GL_RENDERBUFFER, std::min(samples, most), format, width, height);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, where, GL_RENDERBUFFER, buffer);
        };
        attach(color_, GL_RGBA8, GL_COLOR_ATTACHMENT0);
        attach(depth_, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
    }

    int width_ = 0, height_ = 0;
    GLuint color_ = 0, depth_ = 0;
    GlFramebuffer framebuffer_;
};

/// Half the depth that has to be seen: everything, wherever the view is.
double depth_of(const SurfacePicture& picture, const OrbitView& view) {
    double reach = 0;
    for (const MeshAssembly* assembly : {picture.ground.get(), picture.pattern.get()}) {
        if (assembly == nullptr) continue;
        std::vector<double> radii;
        for (const NamedMesh& named : assembly->meshes) {
            double radius = 0;
            for (const SpacePoint p : named.mesh.positions) radius = std::max(radius, abs(p));
            radii.push_back(radius);
        }
        for (const MeshInstance& instance : assembly->instances) {
            const SpacePoint s = instance.pose.scale;
            const double scale = std::max({std::abs(s.x), std::abs(s.y), std::abs(s.z)});
            const double far = abs(instance.pose.translation - view.centre);
            reach = std::max(reach, far + scale * radii[static_cast<std::size_t>(instance.mesh)]);
        }
    }
    return std::max(reach, 1e-9);
}

bool same(const SurfacePicture& a, const SurfacePicture& b) {
    return a.ground == b.ground && a.pattern == b.pattern && a.lines == b.lines && a.wireframe == b.wireframe &&
           a.behind == b.behind && a.line == b.line;
}

}  // namespace

struct SurfaceRenderer::Parts {
    GlProgram program{surface_vertex, surface_fragment};
    SampledTarget sampled;
    PixelTarget frame{PixelFormat::bytes, false};
    std::vector<Batch> ground, pattern;
    std::optional<Batch> lines;
    SurfacePicture shown;  ///< what is uploaded
    OrbitView view;
    double depth = 1;
    bool drawn = false;

    void upload(const SurfacePicture& picture) {
        if (picture.ground != shown.ground) ground = picture.ground ? uploaded(*picture.ground) : std::vector<Batch>{};
        if (picture.pattern != shown.pattern) pattern = picture.pattern ? uploaded(*picture.pattern) : std::vector<Batch>{};
        if (picture.lines != shown.lines) {
            lines.reset();
            if (picture.lines) lines.emplace(uploaded_lines(*picture.lines, picture.line));
        }
        shown = picture;
    }

    void set_eye() const {
        const OrbitFrame eye = orbit_frame(view);
        const std::array rows{eye.right, eye.up, eye.towards};
        std::array<float, 9> matrix{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto row = floats(rows[i]);
            std::copy(row.begin(), row.end(), matrix.begin() + static_cast<std::ptrdiff_t>(3 * i));
        }
        program.use();
        glUniformMatrix3fv(program.uniform("eye"), 1, GL_TRUE, matrix.data());
        const auto centre = floats(view.centre);
        glUniform3fv(program.uniform("centre"), 1, centre.data());
        const auto across = [&](double pixels) { return static_cast<float>(2 * view.zoom / std::max(1.0, pixels)); };
        glUniform3f(program.uniform("shrink"), across(view.size.x), across(view.size.y), static_cast<float>(1 / depth));
    }

    void draw_batch(const Batch& batch, GLenum mode, bool lit, Color color, float nearer) const {
        constexpr float full = 255;
        glUniform3f(program.uniform("color"), static_cast<float>(color.red) / full, static_cast<float>(color.green) / full,
                    static_cast<float>(color.blue) / full);
        glUniform1i(program.uniform("lit"), lit ? 1 : 0);
        glUniform1f(program.uniform("nearer"), nearer);
        glBindVertexArray(batch.array.name());
        glDrawArraysInstanced(mode, 0, batch.vertex_count, batch.instance_count);
    }

    void draw_all() const {
        glEnable(GL_DEPTH_TEST);
        constexpr float full = 255;
        const Color behind = shown.behind;
        glClearColor(static_cast<float>(behind.red) / full, static_cast<float>(behind.green) / full,
                     static_cast<float>(behind.blue) / full, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        set_eye();
        for (const Batch& batch : ground) draw_batch(batch, GL_TRIANGLES, true, batch.color, 0);
        for (const Batch& batch : pattern) draw_batch(batch, GL_TRIANGLES, true, batch.color, 0);
        if (shown.wireframe) {
            constexpr Color wire{110, 110, 110};
            glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
            for (const Batch& batch : ground) draw_batch(batch, GL_TRIANGLES, false, wire, wire_nearer);
            glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        }
        if (lines) draw_batch(*lines, GL_LINES, false, shown.line, line_nearer);
        glBindVertexArray(0);
        glDisable(GL_DEPTH_TEST);
    }
};

SurfaceRenderer::SurfaceRenderer() : parts_(std::make_unique<Parts>()) {}
SurfaceRenderer::~SurfaceRenderer() = default;

unsigned SurfaceRenderer::draw(const SurfacePicture& picture, const OrbitView& view) {
    Parts& parts = *parts_;
    if (parts.drawn && same(parts.shown, picture) && parts.view == view) return parts.frame.texture();
    parts.upload(picture);
    parts.view = view;
    parts.depth = depth_of(picture, view);
    parts.drawn = true;
    parts.sampled.bind(std::max(1, static_cast<int>(view.size.x)), std::max(1, static_cast<int>(view.size.y)));
    parts.draw_all();
    parts.sampled.resolve_to(parts.frame);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return parts.frame.texture();
}

}  // namespace rinceau
