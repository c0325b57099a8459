#pragma once
// What expressions of shape grammars may ask (Li et al. 2010, section 4.3.2).

#include <string>
#include <string_view>
#include <vector>

#include "growth/surface/shape_grammar.h"

namespace rinceau {

/// What can be asked of a field at a place. Direction 1 is that of the major eigenvector of a tensor, of a vector, or the
/// nearest one of a cross to the scope's X; direction 2 that of the minor eigenvector, or what is a quarter turn
/// counter-clockwise from direction 1. Their sign is the one nearer to the scope's X, but for vectors. Angles are degrees.
enum class FieldQuantity : unsigned char {
    angle1,      ///< Xangle1: from the scope's X to direction 1, counter-clockwise about the normal
    angle2,      ///< Xangle2: likewise to direction 2
    length1,     ///< major eigenvalue of a tensor; length of a vector; strength of a cross
    length2,     ///< minor eigenvalue of a tensor; else as length1
    vector1,     ///< component in space of length1 times direction 1
    vector2,     ///< component in space of length2 times direction 2
    direction1,  ///< component in space of direction 1, which has length 1
    direction2,  ///< likewise 2
    maxcurv,     ///< the larger principal curvature, if the field is the surface's curvature tensor; = length1
    mincurv,     ///< the smaller one; = length2
    mean,        ///< half of their sum
    gauss,       ///< their product
    divergence,  ///< div: of the field of vector1
    curl,        ///< of the field of vector1, about the normal
    curvature,   ///< of the field line through the place, 1 / length; positive where it bends to the left
    gradient,    ///< component in space of the gradient of value where there are numbers by vertex, else of length1
    index,       ///< of the face: in n-th parts of a turn
    distance,    ///< dist: in space, to the nearest singular point; the surface's diagonal if there is none
    red,         ///< of an image's colour at the place, 0 .. 255
    green,       ///< likewise
    blue,        ///< likewise
    brightness,  ///< of an image at the place, 0 .. 1
    value        ///< the field's number: of the numbers by vertex if it has some, else brightness or strength
};

struct ShapeQuery {
    enum class About : unsigned char {
        field,     ///< F1.length1: quantity
        size,      ///< S.x: of the scope
        position,  ///< P.x: of the scope, in space
        normal,    ///< N.x: of the surface
        depth,     ///< of the derivation; an axiom's commands have 0
        count,     ///< count("leaf"): how many are placed
        near       ///< near("leaf"): from P to the nearest other one that is placed; the surface's diagonal if there is none
    };
    About about = About::depth;
    FieldQuantity quantity = FieldQuantity::angle1;
    int field = -1;     ///< index into the grammar's fields
    int shape = -1;     ///< index into the grammar's shapes
    int component = 0;  ///< 0, 1, 2 = x, y, z: of vectors, size, position and normal
    friend bool operator==(const ShapeQuery&, const ShapeQuery&) = default;
};

/// Answers queries at a scope. What is not asked costs nothing.
class QuerySource {
  public:
    QuerySource() = default;
    QuerySource(const QuerySource&) = default;
    QuerySource& operator=(const QuerySource&) = default;
    virtual ~QuerySource() = default;
    virtual double answer(const ShapeQuery& query) = 0;
};

/// Is it a query, by its looks: with a dot or a text, or depth?
bool looks_like_query(std::string_view name);

/// Throws InputError at `place` for a query that does not exist, or names no field or shape of the grammar.
ShapeQuery parse_shape_query(const std::string& name, const ShapeGrammar& grammar, const SourcePlace& place);

/// A word behind "F1." with what it is, for documentation and messages.
struct FieldQuantityInfo {
    std::string_view word;
    FieldQuantity quantity;
    bool vector;  ///< has components .x .y .z
};
const std::vector<FieldQuantityInfo>& field_quantities();

}  // namespace rinceau
