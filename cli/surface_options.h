#pragma once
// What `rinceau grow` and `rinceau field` share: options of a surface and of looks at it, and reading it.

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/App.hpp>

#include "geometry/point.h"
#include "growth/mesh/mesh_glb_write.h"
#include "growth/surface/surface_mesh.h"

namespace rinceau {

/// Where a picture is seen from, degrees.
struct LookFrom {
    double turn = 30;       ///< round the up axis from the front
    double elevation = 20;  ///< above the horizon, -90 to 90
};

/// `--repair`
void add_repair_option(CLI::App& verb, bool& repair);
/// `--size W,H`
void add_plane_option(CLI::App& verb, std::optional<Point>& size, const std::string& help);
/// `--up y|z`
void add_up_option(CLI::App& verb, UpAxis& up, const std::string& help);
/// `--view TURN,ELEVATION`
void add_view_option(CLI::App& verb, std::optional<LookFrom>& look, const std::string& help);

constexpr int widest_png = 16384;  ///< pixels

/// So many numbers between commas. Throws CLI::ValidationError: "expected EXPECTED, found 'TEXT'".
std::vector<double> parse_numbers(const std::string& option, const std::string& expected, const std::string& text,
                                  std::size_t count);

/// An option whose value is one of some words; the words in `type` stand between bars. What was given is added to `given`,
/// if there is such a list.
template <class Value>
void add_choice(CLI::App& verb, const std::string& name, Value& value, const std::string& help,
                const std::map<std::string, Value>& choices, const std::string& type,
                std::vector<std::string>* given = nullptr) {
    const auto choose = [&value, name, choices, type, given](const std::string& word) {
        const auto chosen = choices.find(word);
        if (chosen == choices.end()) throw CLI::ValidationError(name, "expected " + type + ", found '" + word + "'");
        value = chosen->second;
        if (given != nullptr) given->push_back(name);
    };
    verb.add_option_function<std::string>(name, choose, help)->type_name(type);
}

/// Throws CLI::ValidationError naming the option if the output would take the place of one of these inputs.
void expect_other_file(const std::string& option, const std::string& output, const std::vector<std::string>& inputs);

/// The surface in the file `name`. Says warnings and adds them. Throws as read_input() and read_surface().
SurfaceMesh read_surface_file(const std::string& name, bool repair, std::vector<std::string>& warnings);

}  // namespace rinceau
