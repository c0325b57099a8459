#include "editor/gl/draw_plan.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "editor/gl/seen_items.h"

namespace rinceau {
namespace {

constexpr std::size_t vertices_worth_a_call = 1024;  // fewer are drawn faster from the stream
constexpr std::size_t most_stream_vertices = 16'000'000;

/// Meshes for the groups; true if each has the one that it should.
bool give_meshes(SeenItems& seen, const LookTable& table, ShapeStore& store,
                 std::chrono::steady_clock::time_point deadline) {
    const auto shape_of = [&](const SeenGroup& group) { return table.looks[static_cast<std::size_t>(group.look)].shape; };
    std::vector<std::pair<std::shared_ptr<Shape>, MeshLevel>> wanted;
    for (const SeenGroup& group : seen.groups)
        if (!shape_of(group)->meshes.contains(group.level)) wanted.emplace_back(shape_of(group), group.level);
    // looks that differ in colour alone share a shape
    std::ranges::sort(wanted);
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    store.make_meshes(wanted, deadline);
    bool complete = true;
    for (SeenGroup& group : seen.groups) {
        const std::shared_ptr<Shape> shape = shape_of(group);
        const auto exact = shape->meshes.find(group.level);
        complete = complete && exact != shape->meshes.end();
        group.mesh = exact != shape->meshes.end() ? exact->second : nearest_mesh(*shape, group.level);
    }
    return complete;
}

class Planner {
  public:
    Planner(const LookTable& table, const SeenItems& seen, Point origin) : table_(table), seen_(seen) {
        plan_.origin = origin;
        plan_.left_out = seen.left_out;
    }

    void plan_opaque() {
        const std::vector<std::vector<std::uint32_t>> members = opaque_members();
        // Instances by mesh, the uppermost first: what is hidden then costs little.
        for (std::size_t g = members.size(); g-- > 0;) {
            if (members[g].empty() || !seen_.groups[g].mesh) continue;
            if (is_worth_a_call(seen_.groups[g], members[g].size()))
                add_instances(plan_.opaque, seen_.groups[g], members[g]);
        }
        for (const bool crisp : {false, true}) {
            for (const bool gradients : {false, true}) stream_opaque(members, crisp, gradients);
        }
    }

    void plan_translucent() {
        std::vector<std::uint32_t> run;
        std::int32_t group = -1;
        const auto end_run = [&] {
            if (!run.empty()) add_run(seen_.groups[static_cast<std::size_t>(group)], run);
            run.clear();
        };
        for (const SeenItem& item : seen_.items) {
            if (is_opaque(item)) continue;
            if (item.group != group || item.group < 0) end_run();
            group = item.group;
            if (group < 0) {
                plan_.translucent.push_back({.kind = PlanStepKind::fragment, .first = item.item});
            } else if (seen_.groups[static_cast<std::size_t>(group)].mesh) {
                run.push_back(item.item);
            }
        }
        end_run();
    }

    DrawPlan take() {
        if (!plan_.stream_gradients.empty()) plan_.stream_gradients.resize(plan_.stream.size());
        return std::move(plan_);
    }

  private:
    const LookEntry& look(std::int32_t number) const { return table_.looks[static_cast<std::size_t>(number)]; }
    const PictureItem& item(std::uint32_t number) const { return table_.picture->items[number]; }
    bool is_opaque(const SeenItem& seen) const {
        return seen.group >= 0 && look(seen_.groups[static_cast<std::size_t>(seen.group)].look).paint.opaque;
    }
    static bool has_gradients(const LookEntry& entry) { return entry.gradients[0] != 0 || entry.gradients[1] != 0; }
    static bool is_worth_a_call(const SeenGroup& group, std::size_t items) {
        return group.mesh->vertices.size() * items > vertices_worth_a_call;
    }

    std::vector<std::vector<std::uint32_t>> opaque_members() const {
        std::vector<std::vector<std::uint32_t>> members(seen_.groups.size());
        for (std::size_t k = seen_.items.size(); k-- > 0;) {
            const SeenItem& seen = seen_.items[k];
            if (!is_opaque(seen)) continue;
            auto& list = members[static_cast<std::size_t>(seen.group)];
            if (list.empty()) list.reserve(seen_.groups[static_cast<std::size_t>(seen.group)].count);
            list.push_back(seen.item);
        }
        return members;
    }

    void stream_opaque(const std::vector<std::vector<std::uint32_t>>& members, bool crisp, bool gradients) {
        for (std::size_t g = members.size(); g-- > 0;) {
            const SeenGroup& group = seen_.groups[g];
            if (members[g].empty() || !group.mesh || is_worth_a_call(group, members[g].size())) continue;
            const LookEntry& entry = look(group.look);
            if (entry.paint.crisp != crisp || has_gradients(entry) != gradients) continue;
            for (const std::uint32_t number : members[g]) add_to_stream(plan_.opaque, group, number);
        }
    }

    void add_run(const SeenGroup& group, const std::vector<std::uint32_t>& run) {
        if (look(group.look).paint.mixes_within) {
            for (const std::uint32_t number : run) add_mixing(group, number);
        } else if (is_worth_a_call(group, run.size())) {
            add_instances(plan_.translucent, group, run);
        } else {
            for (const std::uint32_t number : run) add_to_stream(plan_.translucent, group, number);
        }
    }

    PackedColor part_color(const LookPaint& paint, const PictureItem& drawn, LookPart which) const {
        const PartPaint& part = paint.part(which);
        const std::optional<Color>& other = which == LookPart::fill ? drawn.repaint.fill : drawn.repaint.stroke;
        return packed_color(other && !part.gradient ? *other : part.color, part.opacity * paint.opacity);
    }

    void add_instances(std::vector<PlanStep>& steps, const SeenGroup& group, const std::vector<std::uint32_t>& numbers) {
        const LookEntry& entry = look(group.look);
        steps.push_back({.kind = PlanStepKind::instances,
                         .look = group.look,
                         .first = static_cast<std::uint32_t>(plan_.instances.size()),
                         .count = static_cast<std::uint32_t>(numbers.size()),
                         .mesh = group.mesh,
                         .crisp = entry.paint.crisp,
                         .gradients = has_gradients(entry)});
        for (const std::uint32_t number : numbers) {
            const PictureItem& drawn = item(number);
            const Point at = apply(drawn.pose, entry.shape->origin) - plan_.origin;
            plan_.instances.push_back({.linear_x = static_cast<float>(drawn.pose.linear.x),
                                       .linear_y = static_cast<float>(drawn.pose.linear.y),
                                       .x = static_cast<float>(at.x),
                                       .y = static_cast<float>(at.y),
                                       .place = 2 * number + (drawn.pose.mirrored ? 1U : 0U),
                                       .fill = part_color(entry.paint, drawn, LookPart::fill),
                                       .stroke = part_color(entry.paint, drawn, LookPart::stroke)});
        }
    }

    /// The step that further vertices of this kind can join. Where order counts, a step takes both solid and gradient
    /// paints.
    PlanStep& stream_step(std::vector<PlanStep>& steps, bool crisp, bool gradients, PlanStage stage = PlanStage::plain) {
        const bool joins = !steps.empty() && steps.back().kind == PlanStepKind::stream && steps.back().crisp == crisp &&
                           steps.back().stage == stage &&
                           (&steps == &plan_.translucent || steps.back().gradients == gradients);
        if (!joins) {
            steps.push_back({.kind = PlanStepKind::stream,
                             .first = static_cast<std::uint32_t>(plan_.indices.size()),
                             .stage = stage,
                             .crisp = crisp,
                             .gradients = gradients});
        }
        steps.back().gradients = steps.back().gradients || gradients;
        return steps.back();
    }

    bool has_room(const ShapeMesh& mesh) {
        if (plan_.stream.size() + mesh.vertices.size() <= most_stream_vertices) return true;
        ++plan_.left_out;
        return false;
    }

    /// U over L, both times o, is: beside U, o L; in U, first L times o (1 - u) / (1 - o u), then o U, where u is U's
    /// opacity.
    void add_mixing(const SeenGroup& group, std::uint32_t number) {
        const LookPaint& paint = look(group.look).paint;
        const LookPart upper = paint.upper;
        const LookPart lower = paint.lower();
        const double whole = paint.opacity;
        const double through = 1 - paint.part(upper).opacity;
        const double seen = whole * paint.part(upper).opacity;
        const double rest = whole * paint.part(lower).opacity;
        if (!has_room(*group.mesh)) return;
        add_part(group, number, {upper, seen, 1, PlanStage::mark});
        add_part(group, number, {lower, rest, 0, PlanStage::plain});
        add_part(group, number, {lower, rest * through / (1 - seen), 1, PlanStage::marked});
        add_part(group, number, {upper, seen, 1, PlanStage::marked});
    }

    struct MixedPart {
        LookPart part;
        double opacity;
        std::uint32_t rank;  ///< within the item
        PlanStage stage;
    };

    void add_part(const SeenGroup& group, std::uint32_t number, const MixedPart& mixed) {
        const ShapeMesh& mesh = *group.mesh;
        const LookEntry& entry = look(group.look);
        const bool gradients = has_gradients(entry);
        PlanStep& step = stream_step(plan_.translucent, entry.paint.crisp, gradients, mixed.stage);
        const auto first = static_cast<std::uint32_t>(plan_.stream.size());
        const auto part = static_cast<float>(mixed.part);
        for (const std::uint32_t index : mesh.indices) {
            if (mesh.vertices[index].part != part) continue;
            plan_.indices.push_back(first + index);
            ++step.count;
        }
        add_vertices(mesh, entry, number);
        for (auto vertex = plan_.stream.begin() + first; vertex != plan_.stream.end(); ++vertex) {
            vertex->rank = 2 * number + mixed.rank;
            vertex->color.back() = packed_color({}, mixed.opacity).back();
        }
        if (gradients) add_gradients(mesh, entry, first);
    }

    void add_to_stream(std::vector<PlanStep>& steps, const SeenGroup& group, std::uint32_t number) {
        const ShapeMesh& mesh = *group.mesh;
        if (!has_room(mesh)) return;
        const LookEntry& entry = look(group.look);
        const bool gradients = has_gradients(entry);
        PlanStep& step = stream_step(steps, entry.paint.crisp, gradients);
        step.count += static_cast<std::uint32_t>(mesh.indices.size());
        const auto first = static_cast<std::uint32_t>(plan_.stream.size());
        for (const std::uint32_t index : mesh.indices) plan_.indices.push_back(first + index);
        add_vertices(mesh, entry, number);
        if (gradients) add_gradients(mesh, entry, first);
    }

    void add_vertices(const ShapeMesh& mesh, const LookEntry& entry, std::uint32_t number) {
        const PictureItem& drawn = item(number);
        const Affine map = to_affine(drawn.pose);
        const Point at = apply(drawn.pose, entry.shape->origin) - plan_.origin;
        const std::array<PackedColor, 2> colors{part_color(entry.paint, drawn, LookPart::fill),
                                                part_color(entry.paint, drawn, LookPart::stroke)};
        const bool stroke_above = entry.paint.upper == LookPart::stroke;
        for (const ShapeVertex& vertex : mesh.vertices) {
            const bool stroke = vertex.part != 0;
            plan_.stream.push_back({static_cast<float>(map.a * vertex.x + map.c * vertex.y + at.x),
                                    static_cast<float>(map.b * vertex.x + map.d * vertex.y + at.y),
                                    2 * number + (stroke == stroke_above ? 1U : 0U), colors[stroke ? 1 : 0]});
        }
    }

    void add_gradients(const ShapeMesh& mesh, const LookEntry& entry, std::uint32_t first) {
        plan_.stream_gradients.resize(first);
        for (const ShapeVertex& vertex : mesh.vertices) {
            const std::size_t part = vertex.part != 0 ? 1 : 0;
            const Point unit = apply(entry.to_unit[part], {vertex.x, vertex.y});
            plan_.stream_gradients.push_back(
                {static_cast<float>(unit.x), static_cast<float>(unit.y), entry.gradients[part]});
        }
    }

    const LookTable& table_;
    const SeenItems& seen_;
    DrawPlan plan_;
};

}  // namespace

DrawPlan draw_plan(const LookTable& table, const PlanRequest& request, ShapeStore& store) {
    SeenItems seen =
        seen_items(table, {.region = request.region, .zoom = request.zoom, .only = request.only, .most = most_drawn_items});
    const bool complete = give_meshes(seen, table, store, request.deadline);
    Planner planner(table, seen, center(request.region));
    planner.plan_opaque();
    planner.plan_translucent();
    DrawPlan plan = planner.take();
    plan.complete = complete;
    return plan;
}

}  // namespace rinceau
