#include "editor/gl/picture_shaders.h"

namespace rinceau {
namespace {

// Pieces of the vertex shaders.
constexpr std::string_view view_functions = R"(#version 330 core
uniform vec2 view_scale;   // clip units a scene unit
uniform vec2 view_shift;   // clip units, jitter included
uniform vec4 one_color;    // takes the place of all colours if its opacity is not 0

// Ranks become depths that floats keep apart exactly: multiples of 2^-23.
vec4 clip_place(vec2 place, uint rank) {
    return vec4(place * view_scale + view_shift, 1.0 - float(rank + 1u) * (1.0 / 8388608.0), 1.0);
}
vec4 premultiplied(vec4 color) {
    vec4 drawn = one_color.a > 0.0 ? one_color : color;
    return vec4(drawn.rgb * drawn.a, drawn.a);
}
)";

constexpr std::string_view instance_inputs = R"(
layout(location = 0) in vec2 point;
layout(location = 1) in float part;   // 0 fill, 1 stroke
layout(location = 2) in vec4 pose;    // linear part, translation
layout(location = 3) in uint place;   // 2 i, + 1 if mirrored
layout(location = 4) in vec4 fill;
layout(location = 5) in vec4 stroke;
uniform float upper_part;

vec4 instance_place() {
    vec2 p = (place & 1u) != 0u ? vec2(point.x, -point.y) : point;
    vec2 turned = vec2(pose.x * p.x - pose.y * p.y, pose.y * p.x + pose.x * p.y);
    uint rank = (place & ~1u) + (part == upper_part ? 1u : 0u);
    return clip_place(turned + pose.zw, rank);
}
)";

constexpr std::string_view stream_inputs = R"(
layout(location = 0) in vec2 point;
layout(location = 1) in uint rank;
layout(location = 2) in vec4 color;
)";

constexpr std::string_view instance_main = R"(
flat out vec4 drawn_color;
void main() {
    gl_Position = instance_place();
    drawn_color = premultiplied(part == 0.0 ? fill : stroke);
}
)";

constexpr std::string_view instance_gradient_main = R"(
uniform vec3 to_unit[4];       // rows x and y for the fill, then for the stroke
uniform uint gradients[2];     // 0 = solid
flat out vec4 drawn_color;
flat out uint drawn_gradient;
out vec2 unit_place;
void main() {
    gl_Position = instance_place();
    int first = part == 0.0 ? 0 : 2;
    drawn_color = part == 0.0 ? fill : stroke;
    drawn_gradient = gradients[part == 0.0 ? 0 : 1];
    if (one_color.a > 0.0) { drawn_color = one_color; drawn_gradient = 0u; }
    vec3 p = vec3(point, 1.0);
    unit_place = vec2(dot(to_unit[first], p), dot(to_unit[first + 1], p));
}
)";

constexpr std::string_view stream_main = R"(
flat out vec4 drawn_color;
void main() {
    gl_Position = clip_place(point, rank);
    drawn_color = premultiplied(color);
}
)";

constexpr std::string_view stream_gradient_main = R"(
layout(location = 3) in vec2 unit;
layout(location = 4) in uint gradient;
flat out vec4 drawn_color;
flat out uint drawn_gradient;
out vec2 unit_place;
void main() {
    gl_Position = clip_place(point, rank);
    drawn_color = color;
    drawn_gradient = gradient;
    if (one_color.a > 0.0) { drawn_color = one_color; drawn_gradient = 0u; }
    unit_place = unit;
}
)";

std::string joined(std::string_view inputs, std::string_view main) {
    std::string text(view_functions);
    text += inputs;
    text += main;
    return text;
}

}  // namespace

std::string instance_vertex_shader() { return joined(instance_inputs, instance_main); }
std::string instance_gradient_vertex_shader() { return joined(instance_inputs, instance_gradient_main); }
std::string stream_vertex_shader() { return joined(stream_inputs, stream_main); }
std::string stream_gradient_vertex_shader() { return joined(stream_inputs, stream_gradient_main); }

const std::string_view solid_fragment_shader = R"(#version 330 core
flat in vec4 drawn_color;
out vec4 result;
void main() { result = drawn_color; }
)";

// SVG 2, 14.2: the place along a linear gradient is x; along a radial one it is the largest t whose circle, between the
// focal circle at t = 0 and the unit circle at t = 1, passes through the point and has a radius that is not negative.
const std::string_view gradient_fragment_shader = R"(#version 330 core
flat in vec4 drawn_color;
flat in uint drawn_gradient;
in vec2 unit_place;
uniform samplerBuffer gradient_table;  // two texels each: kind, spread, row, - ; focus, focal radius, -
uniform sampler2D ramps;               // texel 0: before, 1 to 512: along, 513: after
out vec4 result;

const float none = -1e30;

float circle_place(vec2 point, vec2 focus, float focal_radius) {
    vec2 d = point - focus;
    float grown = 1.0 - focal_radius;
    float a = dot(focus, focus) - grown * grown;
    float b = -dot(d, focus) + focal_radius * grown;
    float c = dot(d, d) - focal_radius * focal_radius;
    if (abs(a) < 1e-7) {
        float t = abs(b) > 1e-12 ? 0.5 * c / b : none;
        return focal_radius + t * grown >= 0.0 ? t : none;
    }
    float discriminant = b * b - a * c;
    if (discriminant < 0.0) return none;
    float root = sqrt(discriminant) / abs(a);
    float far = b / a + root;
    if (focal_radius + far * grown >= 0.0) return far;
    float near = b / a - root;
    return focal_radius + near * grown >= 0.0 ? near : none;
}

vec4 ramp_color(float t, int spread, int row) {
    const float last = 511.0;
    if (spread == 0 && t < 0.0) return texelFetch(ramps, ivec2(0, row), 0);
    if (spread == 0 && t > 1.0) return texelFetch(ramps, ivec2(513, row), 0);
    if (spread == 1) t = 1.0 - abs(1.0 - mod(t, 2.0));
    if (spread == 2) t = fract(t);
    float place = clamp(t, 0.0, 1.0) * last;
    int left = int(min(floor(place), last - 1.0));
    return mix(texelFetch(ramps, ivec2(left + 1, row), 0), texelFetch(ramps, ivec2(left + 2, row), 0), place - float(left));
}

vec4 gradient_color() {
    vec4 kind = texelFetch(gradient_table, int(drawn_gradient) * 2 - 2);
    vec4 circle = texelFetch(gradient_table, int(drawn_gradient) * 2 - 1);
    float t = kind.x == 0.0 ? unit_place.x : circle_place(unit_place, circle.xy, circle.z);
    if (t == none) return vec4(0.0);
    return ramp_color(t, int(kind.y), int(kind.z));
}

void main() {
    vec4 color = drawn_gradient == 0u ? drawn_color : gradient_color() * drawn_color;
    result = vec4(color.rgb * color.a, color.a);
}
)";

}  // namespace rinceau
