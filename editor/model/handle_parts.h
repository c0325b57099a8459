#pragma once
// What the files that find handles share. Internal to the folder.

#include <vector>

#include "editor/model/handles.h"
#include "editor/model/picture_boxes.h"
#include "lsystem/drag_point.h"
#include "lsystem/numbers.h"

namespace rinceau {

struct HandleContext {
    const Document& document;
    const Selection& selection;
    const PictureBoxes& boxes;
    const PointDrag& drag;
    std::vector<GrammarNumber> numbers;  ///< of the document's grammar that may be changed: not locked
};

void add_count_handles(const HandleContext& context, std::vector<CanvasHandle>& handles);
void add_place_handles(const HandleContext& context, std::vector<CanvasHandle>& handles);

}  // namespace rinceau
