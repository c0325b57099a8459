#pragma once
// Programs for surfaces in space. Internal to the folder.

#include <string_view>

namespace rinceau {

/// Slots of vertex attributes; `turn` takes three.
namespace surface_slot {
constexpr unsigned place = 0, normal = 1, move = 2, scale = 3, rotation = 4;
}  // namespace surface_slot

/// An instance is scaled, turned by a unit quaternion, moved; then looked at in parallel projection.
constexpr std::string_view surface_vertex = R"(#version 330 core
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 move;
layout(location = 3) in vec3 scale;
layout(location = 4) in vec4 rotation;
uniform mat3 eye;
uniform vec3 centre;
uniform vec3 shrink;
uniform float nearer;
out vec3 seen_normal;
vec3 turned(vec3 v) { return v + 2.0 * cross(rotation.xyz, cross(rotation.xyz, v) + rotation.w * v); }
void main() {
    vec3 seen = eye * (turned(scale * place) + move - centre);
    seen_normal = eye * turned(normal / scale);
    gl_Position = vec4(seen.xy * shrink.xy, -(seen.z * shrink.z) - nearer, 1.0);
}
)";

/// Light from the upper left and a weaker one from the right, as pictures of meshes have it; sheets are seen from both
/// sides.
constexpr std::string_view surface_fragment = R"(#version 330 core
in vec3 seen_normal;
uniform vec3 color;
uniform bool lit;
out vec4 pixel;
void main() {
    vec3 n = normalize(seen_normal);
    if (n.z < 0.0) n = -n;
    float light = 0.35 + 0.6 * max(0.0, dot(n, normalize(vec3(-0.5, 0.65, 0.8)))) +
                  0.15 * max(0.0, dot(n, normalize(vec3(0.8, -0.2, 0.5))));
    pixel = vec4(lit ? min(color * light, vec3(1.0)) : color, 1.0);
}
)";

}  // namespace rinceau
