// What grows on a surface: a shape grammar, or the document's rules.

#include <algorithm>
#include <utility>

#include "editor/model/surface_stage.h"
#include "growth/surface/derive_shapes.h"
#include "growth/surface/field_elements.h"
#include "growth/surface/grow_drawing.h"
#include "growth/surface/parse_shape_grammar.h"
#include "growth/surface/surface_world.h"

namespace rinceau {
namespace {

GrownSurface grown_of(const SurfacePattern& pattern, const SurfaceMesh& surface, std::string told) {
    GrownSurface grown;
    MeshAssembly assembly = assembly_of(pattern, surface);
    told += ", " + std::to_string(faces_out(assembly)) + " faces";
    grown.assembly = std::make_shared<const MeshAssembly>(std::move(assembly));
    grown.told = std::move(told);
    return grown;
}

/// The first axiom begins at each seed instead of where it says.
void begin_at_seeds(ShapeGrammar& grammar, const std::vector<SurfaceMark>& seeds) {
    if (seeds.empty() || grammar.axioms.empty()) return;
    const ShapeAxiom first = grammar.axioms.front();
    grammar.axioms.erase(grammar.axioms.begin());
    std::vector<ShapeAxiom> placed;
    for (const SurfaceMark& seed : seeds) {
        ShapeAxiom axiom = first;
        axiom.where = ShapeAxiom::Where::nearest;
        axiom.field.clear();
        axiom.numbers = {number_expression(seed.at.x), number_expression(seed.at.y), number_expression(seed.at.z)};
        ShapeCommand turn{.verb = ShapeVerb::turn_z, .arguments = {number_expression(seed.angle)}, .place = first.place};
        axiom.commands.insert(axiom.commands.begin(), std::move(turn));
        placed.push_back(std::move(axiom));
    }
    grammar.axioms.insert(grammar.axioms.begin(), placed.begin(), placed.end());
}

/// The field that was designed takes the place of the one that leads.
void lead_by(SurfaceWorld& world, const std::shared_ptr<const FieldOnSurface>& field) {
    if (!field) return;
    if (world.fields.empty()) {
        world.fields.push_back({"F1", field});
    } else {
        world.fields.front().field = field;
    }
}

std::string told_of(const SurfacePattern& pattern, long rules) {
    std::string told = std::to_string(pattern.placed.size()) + " shapes";
    if (!pattern.lines.empty()) told += ", " + std::to_string(pattern.lines.size()) + " lines";
    return told + ", " + std::to_string(rules) + " rules";
}

GrownSurface grown_shapes(const SurfaceOrder& order, const ReadNamed& read, const SurfaceWatch& watch) {
    constexpr long rules_a_look = 2000;  // between two questions whether to stop
    const SurfaceSettings& settings = order.settings;
    const std::string& file = settings.grammar;
    ShapeGrammar grammar = parse_shape_grammar(read(file.substr(file.rfind('/') + 1)), file);
    begin_at_seeds(grammar, settings.seeds);
    SurfaceWorld world = make_world(grammar, order.stage->surface, read, settings.seed, watch.progress);
    lead_by(world, order.field);
    ShapeDerivationOptions options = options_of(grammar);
    options.seed = settings.seed;
    ShapeDerivation derivation(grammar, world, options);
    const auto now = [&] {
        const SurfacePattern pattern = derivation.pattern();
        GrownSurface grown = grown_of(pattern, *order.stage->surface, told_of(pattern, derivation.rules_applied()));
        grown.steps = static_cast<int>(derivation.rules_applied());
        if (!pattern.limit.empty()) grown.told += " (" + pattern.limit + ')';
        return grown;
    };
    const long wanted = settings.steps;
    while (!derivation.done() && (wanted < 0 || derivation.rules_applied() < wanted)) {
        const long left = wanted < 0 ? rules_a_look : wanted - derivation.rules_applied();
        derivation.step(std::min(rules_a_look, left), watch.progress);
        if (watch.stop && watch.stop()) break;
        if (watch.wants_look && watch.wants_look()) watch.show(now());
    }
    return now();
}

void add_to(SurfacePattern& all, SurfacePattern&& one) {
    for (NamedMesh& mesh : one.laid) all.laid.push_back(std::move(mesh));
    all.warnings.insert(all.warnings.end(), one.warnings.begin(), one.warnings.end());
}

GrownSurface grown_rules(const SurfaceOrder& order, const SurfaceWatch& watch) {
    const SurfaceSettings& settings = order.settings;
    const SurfaceMesh& surface = *order.stage->surface;
    const double diagonal_drawn = diagonal(order.rules->canvas);
    GrowDrawingOptions options{.heading = settings.heading,
                               .scale = diagonal_drawn > 0 ? settings.size * surface.diagonal / diagonal_drawn : 0,
                               .follow = settings.follow,
                               .height = settings.height * surface.diagonal,
                               .meet_itself = settings.merge,
                               .seed = settings.seed};
    SurfacePattern all;
    long laid = 0, left_out = 0;
    std::vector<SurfaceMark> seeds = settings.seeds;
    if (seeds.empty()) seeds.emplace_back();  // where the library thinks best
    for (const SurfaceMark& seed : seeds) {
        if (!settings.seeds.empty()) {
            options.start = at_vertex(surface, nearest_vertex(surface, seed.at));
            options.heading = settings.heading + seed.angle;
        }
        GrownDrawing drawn = grow_drawing(*order.rules, surface, order.field.get(), options, watch.progress);
        laid += drawn.laid;
        left_out += drawn.dropped + drawn.stopped;
        add_to(all, std::move(drawn.pattern));
        if (watch.stop && watch.stop()) break;
    }
    std::string told = std::to_string(laid) + " elements";
    if (left_out > 0) told += ", " + std::to_string(left_out) + " left out";
    return grown_of(all, surface, std::move(told));
}

}  // namespace

GrownSurface grown_on_surface(const SurfaceOrder& order, const ReadNamed& read, const SurfaceWatch& watch) {
    return order.settings.grammar.empty() ? grown_rules(order, watch) : grown_shapes(order, read, watch);
}

}  // namespace rinceau
