#include "editor/mesh/sweep.h"

#include <GL/glu.h>

#include <array>
#include <deque>
#include <memory>

namespace rinceau {
namespace {

/// What the callbacks of one polygon fill. Addresses of corners must hold until the polygon ends: hence the deque.
struct Sweep {
    struct Corner {
        std::array<GLdouble, 3> at;
        std::uint32_t index;
    };
    std::deque<Corner> corners;
    Triangles triangles;
    Contours outline;

    Corner* add(Point p) {
        corners.push_back({{p.x, p.y, 0}, static_cast<std::uint32_t>(corners.size())});
        triangles.points.push_back(p);
        return &corners.back();
    }
};

void add_crossing(const GLdouble at[3], void* [4], const GLfloat[4], void** corner, void* sweep) {
    *corner = static_cast<Sweep*>(sweep)->add({at[0], at[1]});
}

void add_triangle_corner(void* corner, void* sweep) {
    static_cast<Sweep*>(sweep)->triangles.indices.push_back(static_cast<const Sweep::Corner*>(corner)->index);
}

/// Being asked for edges, the tessellator gives triangles only, no fans or strips.
void ignore_edge(GLboolean) {}

void begin_contour(GLenum, void* sweep) { static_cast<Sweep*>(sweep)->outline.emplace_back(); }

void add_contour_corner(void* corner, void* sweep) {
    const Sweep::Corner& added = *static_cast<const Sweep::Corner*>(corner);
    static_cast<Sweep*>(sweep)->outline.back().push_back({added.at[0], added.at[1]});
}

template <class Function>
void call_back(GLUtesselator* tessellator, GLenum event, Function* function) {
    gluTessCallback(tessellator, event, reinterpret_cast<void (*)()>(function));
}

using Tessellator = std::unique_ptr<GLUtesselator, decltype(&gluDeleteTess)>;

Tessellator tessellator_for(FillRule rule) {
    Tessellator tessellator(gluNewTess(), gluDeleteTess);
    gluTessNormal(tessellator.get(), 0, 0, 1);
    gluTessProperty(tessellator.get(), GLU_TESS_WINDING_RULE,
                    rule == FillRule::evenodd ? GLU_TESS_WINDING_ODD : GLU_TESS_WINDING_NONZERO);
    call_back(tessellator.get(), GLU_TESS_COMBINE_DATA, add_crossing);
    return tessellator;
}

void run(GLUtesselator* tessellator, const Contours& contours, Sweep& sweep) {
    gluTessBeginPolygon(tessellator, &sweep);
    for (const std::vector<Point>& contour : contours) {
        constexpr std::size_t smallest_polygon = 3;
        if (contour.size() < smallest_polygon) continue;
        gluTessBeginContour(tessellator);
        for (const Point p : contour) {
            Sweep::Corner* corner = sweep.add(p);
            gluTessVertex(tessellator, corner->at.data(), corner);
        }
        gluTessEndContour(tessellator);
    }
    gluTessEndPolygon(tessellator);
}

}  // namespace

Triangles swept_triangles(const Contours& contours, FillRule rule) {
    Sweep sweep;
    const Tessellator tessellator = tessellator_for(rule);
    call_back(tessellator.get(), GLU_TESS_VERTEX_DATA, add_triangle_corner);
    call_back(tessellator.get(), GLU_TESS_EDGE_FLAG, ignore_edge);
    run(tessellator.get(), contours, sweep);
    return std::move(sweep.triangles);
}

Contours swept_outline(const Contours& contours, FillRule rule) {
    Sweep sweep;
    const Tessellator tessellator = tessellator_for(rule);
    gluTessProperty(tessellator.get(), GLU_TESS_BOUNDARY_ONLY, GL_TRUE);
    call_back(tessellator.get(), GLU_TESS_BEGIN_DATA, begin_contour);
    call_back(tessellator.get(), GLU_TESS_VERTEX_DATA, add_contour_corner);
    run(tessellator.get(), contours, sweep);
    return std::move(sweep.outline);
}

}  // namespace rinceau
