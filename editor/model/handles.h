#pragma once
// What can be taken hold of on the canvas, and what it does to the grammar's numbers.

#include <string>
#include <vector>

#include "editor/model/selection.h"

namespace rinceau {

enum class HandleKind : unsigned char { count };

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
    std::vector<std::string> numbers;  ///< that it changes (lsystem/numbers.h), the first for all places alike ..
    std::string own_number;            ///< .. and the one of this place alone, if that is another; else empty
    std::size_t level = 0;             ///< of Selection::path: whose count or place it changes
    CountTrack track;                  ///< HandleKind::count
};

/// "count", as part of a widget's name.
const char* handle_name(HandleKind kind);

/// The handles of what is selected. The picture is that of the document.
std::vector<CanvasHandle> canvas_handles(const Document& document, const DerivedPicture& picture,
                                         const Selection& selection);

/// The count to which the handle was dragged; `turned` is the angle in radians, counter-clockwise, that the mouse has gone
/// around the ring's centre since the handle was grabbed at its place. At least 1.
int dragged_count(const CountTrack& track, Point to, double turned);

}  // namespace rinceau
