#pragma once
// What can be taken hold of on the canvas, and what it does to the grammar's numbers.

#include <string>
#include <vector>

#include "editor/model/selection.h"
#include "lsystem/numbers.h"

namespace rinceau {

/// count: the end of a sequence, how many there are. move: a module, its way from the one before or from what it is part of.
/// radius: the rim of a closed ring. turn, scale: about the place where a module begins; branch: both.
enum class HandleKind : unsigned char { count, move, radius, turn, scale, branch };

/// Where the handle of a sequence's count stands for each count.
struct CountTrack {
    int count = 0;               ///< as it is
    std::vector<Point> places;   ///< [k] = the handle's place for a count of k + 1
    bool ring = false;           ///< closed: what counts is the angle by which the handle is dragged around `center`
    Point center;
    double angle = 0;            ///< radians from one element to the next, counter-clockwise
};

struct CanvasHandle {
    HandleKind kind = HandleKind::count;
    Point at;                          ///< scene
    std::size_t level = 0;  ///< of Selection::path: whose count or place it changes
    std::vector<GrammarNumber> numbers;  ///< that it changes: count: one; else at most two; none = this place alone
    std::string own_number;  ///< count: that of this place alone, if it is another one; else empty
    CountTrack track;        ///< count
    Point local;             ///< else: `at` in the turtle's frame at path[level]
};

/// "count", "move", .. as part of a widget's name.
const char* handle_name(HandleKind kind);

/// "Row.distance, Row.direction": what it changes; for one that changes no number "Window here".
std::string handle_label(const CanvasHandle& handle, const Selection& selection);

/// The handles of what is selected: the counts of all sequences on its path, its own place, size and direction. The picture is that of the document.
std::vector<CanvasHandle> canvas_handles(const Document& document, const DerivedPicture& picture,
                                         const Selection& selection);

/// The count to which the handle was dragged; `turned` is the angle in radians, counter-clockwise, that the mouse has gone
/// around the ring's centre since the handle was grabbed at its place. At least 1.
int dragged_count(const CountTrack& track, Point to, double turned);

}  // namespace rinceau
