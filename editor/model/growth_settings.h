#pragma once
// What is set in the panel of growth. In words of its own: what the panels include does not change with the library.

#include <cstdint>
#include <map>
#include <string>

namespace rinceau {

enum class GrowthTab : unsigned char { arrangement, aggregate, surface };

/// What the left mouse button does on the canvas: select as ever; grow elements; draw strokes that elements follow, or that
/// they do not cross; flip edges of the exemplar's connectivity.
enum class GrowthBrush : unsigned char { none, spray, flow, boundary, flip };

/// By how much each element may be turned, enlarged and coloured otherwise.
struct JitterSettings {
    double angle = 0;  ///< degrees to either side
    double scale = 0;  ///< JitterOptions
    double color = 0;
    friend bool operator==(const JitterSettings&, const JitterSettings&) = default;
};

/// Elements stand as in the drawing; are turned so that their neighbours fit; follow flow strokes (RotationMode).
enum class ElementTurn : unsigned char { as_drawn, to_fit, along_flow };

struct ArrangementSettings {
    ElementTurn turn = ElementTurn::as_drawn;
    bool directed = true;                   ///< flow strokes say forward and back
    bool two_rings = false;                 ///< ArrangeOptions::two_rings
    std::map<std::string, int> priorities;  ///< by ExemplarSymbol::name; the others have 0
    std::size_t count = 200;                ///< elements that grow at once
    bool fill = false;                      ///< grow within the canvas until it is full, whatever the count
    double canvas = 2;                      ///< width and height, of the document's canvas
    double brush = 3;                       ///< radius of the spray, of the exemplar's mean edge
    bool finish = true;  ///< what has grown by a count or in the canvas is relaxed and repaired at the end
    JitterSettings jitter;
    std::uint64_t seed = 1;
};

/// A figure of the document among what is packed.
struct ShapeChoice {
    bool used = true;
    double share = 1;  ///< beside those of the others
};

/// As PackMethod and PackQuality.
enum class FillMethod : unsigned char { settle, gaps, darts };
enum class FillQuality : unsigned char { fast, best };

enum class PackTurn : unsigned char { any, none, quarters, within };

struct AggregateSettings {
    std::map<int, ShapeChoice> shapes;  ///< by FiguredDrawing::figures; those that are not here are used alike
    std::string region;                 ///< file of an SVG whose closed outlines are filled; empty = the canvas
    double canvas = 4;                  ///< width and height of what is filled, of the document's canvas
    bool tiled = false;
    double min_scale = 1, max_scale = 1;
    double margin = 0;  ///< scene length that shapes keep from each other, half of it each
    bool keep_holes = false;
    FillMethod method = FillMethod::settle;
    FillQuality quality = FillQuality::fast;
    PackTurn turn = PackTurn::any;
    double spread = 15;   ///< PackTurn::within: degrees to either side
    std::string density;  ///< file of a grey picture; empty = everywhere alike
    std::uint64_t seed = 1;
};

struct GrowthSettings {
    GrowthTab tab = GrowthTab::arrangement;
    std::string raised;  ///< symbol whose every expansion is one element; empty = none
    bool group = true;   ///< FigureOptions::group
    bool edges = false;  ///< who is whose neighbour is drawn over the canvas
    GrowthBrush brush = GrowthBrush::none;
    ArrangementSettings arrangement;
    AggregateSettings aggregate;
};

}  // namespace rinceau
