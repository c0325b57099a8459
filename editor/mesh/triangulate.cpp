// Polygons by the sweep of the GLU tessellator, which works without a context.

#include "editor/mesh/triangulate.h"

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
    Triangles result;

    Corner* add(Point p) {
        corners.push_back({{p.x, p.y, 0}, static_cast<std::uint32_t>(corners.size())});
        result.points.push_back(p);
        return &corners.back();
    }
};

void on_vertex(void* corner, void* sweep) {
    static_cast<Sweep*>(sweep)->result.indices.push_back(static_cast<const Sweep::Corner*>(corner)->index);
}

void on_crossing(const GLdouble at[3], void* [4], const GLfloat[4], void** corner, void* sweep) {
    *corner = static_cast<Sweep*>(sweep)->add({at[0], at[1]});
}

/// Being asked for edges, the tessellator gives triangles only, no fans or strips.
void on_edge(GLboolean) {}

using Callback = void (*)();

template <class Function>
Callback as_callback(Function* function) {
    return reinterpret_cast<Callback>(function);
}

using Tessellator = std::unique_ptr<GLUtesselator, decltype(&gluDeleteTess)>;

Tessellator tessellator_for(FillRule rule) {
    Tessellator tessellator(gluNewTess(), gluDeleteTess);
    gluTessNormal(tessellator.get(), 0, 0, 1);
    gluTessProperty(tessellator.get(), GLU_TESS_WINDING_RULE,
                    rule == FillRule::evenodd ? GLU_TESS_WINDING_ODD : GLU_TESS_WINDING_NONZERO);
    gluTessCallback(tessellator.get(), GLU_TESS_VERTEX_DATA, as_callback(on_vertex));
    gluTessCallback(tessellator.get(), GLU_TESS_COMBINE_DATA, as_callback(on_crossing));
    gluTessCallback(tessellator.get(), GLU_TESS_EDGE_FLAG, as_callback(on_edge));
    return tessellator;
}

}  // namespace

Triangles triangulated(const Contours& contours, FillRule rule) {
    Sweep sweep;
    const Tessellator tessellator = tessellator_for(rule);
    gluTessBeginPolygon(tessellator.get(), &sweep);
    for (const std::vector<Point>& contour : contours) {
        constexpr std::size_t smallest_polygon = 3;
        if (contour.size() < smallest_polygon) continue;
        gluTessBeginContour(tessellator.get());
        for (const Point p : contour) {
            Sweep::Corner* corner = sweep.add(p);
            gluTessVertex(tessellator.get(), corner->at.data(), corner);
        }
        gluTessEndContour(tessellator.get());
    }
    gluTessEndPolygon(tessellator.get());
    return std::move(sweep.result);
}

}  // namespace rinceau
