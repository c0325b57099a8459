#include "growth/surface/surface_world.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "growth/surface/field_source.h"
#include "growth/surface/shape_settings.h"
#include "lsystem/similar_name.h"

namespace rinceau {

namespace {

std::map<std::string, double> evaluated_numbers(const ShapeSource& source, const ShapeGrammar& grammar,
                                                const ShapeGrammarSetting& setting) {
    std::map<std::string, double> numbers;
    for (const auto& [name, value] : source.numbers) numbers.emplace(name, value_of(value, grammar, setting, source.place));
    return numbers;
}

}  // namespace

PlanePiece plane_piece(const ShapeGrammar& grammar) {
    PlanePiece piece;
    const auto option = grammar.options.find("plane");
    if (option == grammar.options.end()) return piece;
    const ShapeSource& source = option->second;
    if (!source.numbers.contains("value"))
        throw InputError(source.place,
                         "expected the plane's width, as in option plane = 2 height = 1, found '" + source.text + "'");
    constexpr double largest = 1e6, finest = 2000;
    const SettingValues values = setting_values(source, evaluated_numbers(source, grammar, {}),
                                                {{"value", piece.width, 1 / largest, largest},
                                                 {"height", 0, 0, largest},
                                                 {"cells", static_cast<double>(piece.cells), 1, finest, true}},
                                                {});
    piece.width = values.number("value");
    piece.height = values.number("height") > 0 ? values.number("height") : piece.width;
    piece.cells = values.whole("cells");
    return piece;
}

TriangleMesh plane_mesh(const PlanePiece& piece) {
    const double side = std::max(piece.width, piece.height) / piece.cells;
    const int columns = std::max(1, static_cast<int>(std::lround(piece.width / side)));
    const int rows = std::max(1, static_cast<int>(std::lround(piece.height / side)));
    TriangleMesh mesh;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i)
            mesh.positions.push_back({piece.width * (static_cast<double>(i) / columns - 0.5),
                                      piece.height * (static_cast<double>(j) / rows - 0.5), 0});
    const auto corner = [columns](int i, int j) { return j * (columns + 1) + i; };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const std::array<int, 4> square{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)};
            // diagonals turn from square to square, so that no direction is preferred
            const bool even = (i + j) % 2 == 0;
            mesh.triangles.push_back({square[0], square[1], even ? square[2] : square[3]});
            mesh.triangles.push_back({even ? square[0] : square[1], square[2], square[3]});
        }
    return mesh;
}

ShapeGrammarSetting grammar_setting(const SurfaceMesh& surface, std::uint64_t seed) {
    const auto [low, high] = bounds(surface.mesh);
    return {.seed = seed,
            .diagonal = surface.diagonal,
            .area = surface.area,
            .mean_edge = surface.mean_edge,
            .low = low,
            .high = high};
}

FieldSource field_source_of(const ShapeSource& source, const ShapeGrammar& grammar, const ShapeGrammarSetting& setting) {
    return {.name = source.name,
            .kind = source.kind,
            .text = source.text,
            .numbers = evaluated_numbers(source, grammar, setting),
            .words = source.words,
            .place = source.place};
}

std::shared_ptr<const FieldOnSurface> make_world_field(const ShapeSource& source, const ShapeGrammar& grammar,
                                                       const SurfaceMesh& surface, const ReadNamedFile& read_file,
                                                       std::uint64_t seed, const Progress& progress) {
    const FieldSource evaluated = field_source_of(source, grammar, grammar_setting(surface, seed));
    return std::make_shared<const FieldOnSurface>(surface, make_field(evaluated, surface, read_file, progress));
}

SurfaceWorld make_world(const ShapeGrammar& grammar, std::shared_ptr<const SurfaceMesh> surface,
                        const ReadNamedFile& read_file, std::uint64_t seed, const Progress& progress) {
    SurfaceWorld world;
    world.plane = surface == nullptr;
    world.surface = world.plane ? std::make_shared<const SurfaceMesh>(surface_mesh(plane_mesh(plane_piece(grammar))))
                                : std::move(surface);
    const ShapeGrammarSetting setting = grammar_setting(*world.surface, seed);
    param_values(grammar, setting);  // a mistake in them is named before long work
    for (const ShapeSource& shape : grammar.shapes) {
        const auto number_of = [&](const Expression& value) { return value_of(value, grammar, setting, shape.place); };
        world.shapes.push_back(make_shape(shape, read_file, number_of));
    }
    for (const ShapeSource& field : grammar.fields)
        world.fields.push_back({field.name, make_world_field(field, grammar, *world.surface, read_file, seed, progress)});
    return world;
}

ShapeGrammar with_params(ShapeGrammar grammar, const std::vector<std::pair<std::string, Expression>>& values) {
    for (const auto& [name, value] : values) {
        const auto found = std::ranges::find(grammar.params, name, &ShapeParam::name);
        if (found == grammar.params.end()) {
            std::vector<std::string> known;
            for (const ShapeParam& param : grammar.params) known.push_back(param.name);
            throw InputError({grammar.file_name},
                             "expected a param of this grammar to be set, found '" + name + "'" + instead_of(name, known));
        }
        found->value = value;
    }
    return grammar;
}

}  // namespace rinceau
