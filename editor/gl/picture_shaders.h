#pragma once
// The shaders that draw pictures. Colours leave them multiplied by their opacity.

#include <string>
#include <string_view>

namespace rinceau {

namespace attribute_slot {
constexpr unsigned point = 0, part = 1, pose = 2, place = 3, fill = 4, stroke = 5;  // instances
constexpr unsigned rank = 1, color = 2, unit = 3, gradient = 4;                     // stream; point is shared
}  // namespace attribute_slot

std::string instance_vertex_shader();
std::string instance_gradient_vertex_shader();
std::string stream_vertex_shader();
std::string stream_gradient_vertex_shader();
extern const std::string_view solid_fragment_shader;
extern const std::string_view gradient_fragment_shader;

}  // namespace rinceau
