#include "editor/gl/screen_programs.h"

#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <string_view>

namespace rinceau {
namespace {

constexpr std::string_view whole_screen_shader = R"(#version 330 core
void main() {  // one triangle that covers all
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";

constexpr std::string_view copy_shader = R"(#version 330 core
uniform sampler2D source;
out vec4 result;
void main() { result = texelFetch(source, ivec2(gl_FragCoord.xy), 0); }
)";

/// After a line "#define compared .." that says whether anything but the picture is shown: software renderers pay for
/// what they skip, too.
constexpr std::string_view compose_shader = R"(
uniform sampler2D picture, lit, before, mask;
uniform float picture_weight, lit_weight, before_weight, mask_weight;  // 0 = there is none
uniform bool fades, difference;
uniform vec4 canvas;         // low and high corner, pixels
uniform vec3 ground, accent;
uniform float outside_fade;
out vec4 result;

const float lit_share = 0.85;        // of a frame in which something is lit
const float line_reach = 2.0;        // pixels that the line around reaches from what it surrounds
const float before_share = 0.35;
const vec3 before_tint = vec3(0.85, 0.2, 0.45);
const float seen_difference = 0.06;  // of the range: less is not seen
const float difference_ground = 0.25;

vec4 over(vec4 upper, vec4 lower) { return upper + (1.0 - upper.a) * lower; }
vec4 at(sampler2D source, float weight) { return weight * texelFetch(source, ivec2(gl_FragCoord.xy), 0); }

// The share of this pixel that the canvas covers.
float canvas_share() {
    vec2 low = max(canvas.xy, gl_FragCoord.xy - 0.5);
    vec2 high = min(canvas.zw, gl_FragCoord.xy + 0.5);
    vec2 size = max(high - low, 0.0);
    return size.x * size.y;
}

vec3 on_paper(vec4 color, float inside) {
    vec3 outside = (1.0 - outside_fade) * color.rgb + (1.0 - (1.0 - outside_fade) * color.a) * ground;
    return mix(outside, color.rgb + vec3(1.0 - color.a), inside);
}

#if compared
// How far the nearest masked pixel makes this one part of the line.
float line_share() {
    if (mask_weight == 0.0) return 0.0;
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(mask, 0) - 1;
    float most = 0.0;
    for (int y = -3; y <= 3; ++y) {
        for (int x = -3; x <= 3; ++x) {
            float near = clamp(line_reach + 0.5 - length(vec2(x, y)), 0.0, 1.0);
            if (near == 0.0) continue;
            most = max(most, near * texelFetch(mask, clamp(here + ivec2(x, y), ivec2(0), last), 0).a * mask_weight);
        }
    }
    return most * (1.0 - at(mask, mask_weight).a);
}

#endif

void main() {
    float inside = canvas_share();
    vec4 own = at(picture, picture_weight);
    vec3 color = on_paper(own, inside);
#if compared
    if (before_weight > 0.0) {
        vec4 other = at(before, before_weight);
        if (difference) {
            vec3 apart = abs(on_paper(own, inside) - on_paper(other, inside));
            float share = smoothstep(0.5 * seen_difference, seen_difference, max(apart.r, max(apart.g, apart.b)));
            color = mix(mix(on_paper(vec4(0.0), inside), color, difference_ground), accent, share);
        } else {
            // A trace is as dark as the other picture is inked.
            float ink = other.a - min(other.a, dot(other.rgb, vec3(0.299, 0.587, 0.114)));
            float trace = before_share * clamp(0.4 * other.a + ink, 0.0, 1.0);
            color = mix(color, before_tint, trace);
        }
    }
    if (fades) color = mix(color, on_paper(at(lit, lit_weight), inside), lit_share);
    color = mix(color, accent, line_share());
#endif
    result = vec4(color, 1.0);
}
)";

glm::vec3 as_vector(const Color& color) {
    constexpr float full = 255;
    return {static_cast<float>(color.red) / full, static_cast<float>(color.green) / full,
            static_cast<float>(color.blue) / full};
}

/// The canvas in pixels; for none, a box around everything.
glm::vec4 canvas_corners(const Box& canvas) {
    constexpr float everything = 1e6F;
    if (is_empty(canvas)) return {-everything, -everything, everything, everything};
    return {canvas.low.x, canvas.low.y, canvas.high.x, canvas.high.y};
}

void bind_source(const GlProgram& program, GLint unit, const char* sampler, const char* weight,
                 const WeightedTexture& source) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, source.name);
    glUniform1i(program.uniform(sampler), unit);
    glUniform1f(program.uniform(weight), source.name == 0 ? 0 : source.weight);
}

std::string composing_shader(bool compared) {
    std::string source = compared ? "#version 330 core\n#define compared 1" : "#version 330 core\n#define compared 0";
    source += compose_shader;
    return source;
}

}  // namespace

ScreenPrograms::ScreenPrograms()
    : copy_(whole_screen_shader, copy_shader),
      compose_plain_(whole_screen_shader, composing_shader(false)),
      compose_compared_(whole_screen_shader, composing_shader(true)) {}

void ScreenPrograms::add(const PixelTarget& target, GLuint texture, bool replace) const {
    target.bind();
    copy_.use();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture);
    glUniform1i(copy_.uniform("source"), 0);
    glBlendFunc(GL_ONE, GL_ONE);
    replace ? glDisable(GL_BLEND) : glEnable(GL_BLEND);
    glBindVertexArray(no_vertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
}

void ScreenPrograms::compose(const PixelTarget& target, const FrameParts& parts) const {
    target.bind();
    const bool compared = parts.fades || parts.before.name != 0 || parts.mask.name != 0;
    const GlProgram& program = compared ? compose_compared_ : compose_plain_;
    program.use();
    const std::array<const WeightedTexture*, 4> sources{&parts.picture, &parts.lit, &parts.before, &parts.mask};
    constexpr std::array samplers{"picture", "lit", "before", "mask"};
    constexpr std::array weights{"picture_weight", "lit_weight", "before_weight", "mask_weight"};
    for (std::size_t k = 0; k < sources.size(); ++k)
        bind_source(program, static_cast<GLint>(k), samplers[k], weights[k], *sources[k]);
    glActiveTexture(GL_TEXTURE0);
    glUniform1i(program.uniform("fades"), parts.fades ? 1 : 0);
    glUniform1i(program.uniform("difference"), parts.difference ? 1 : 0);
    glUniform4fv(program.uniform("canvas"), 1, glm::value_ptr(canvas_corners(parts.canvas)));
    glUniform3fv(program.uniform("ground"), 1, glm::value_ptr(as_vector(parts.ground)));
    glUniform3fv(program.uniform("accent"), 1, glm::value_ptr(as_vector(parts.accent)));
    glUniform1f(program.uniform("outside_fade"), parts.outside_fade);
    glBindVertexArray(no_vertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

}  // namespace rinceau
