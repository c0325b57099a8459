#include "editor/model/find_selection.h"

#include "lsystem/derivation_limits.h"
#include "scene/input_error.h"

namespace rinceau {

SelectionFound find_selection(const SelectionSearch& search, const Progress& progress) {
    SelectionFound found{search.revision, {}, {}};
    try {
        if (search.clicked >= 0) {
            found.selection = selection_of_click(search.document, search.clicked, search.before, search.level, progress);
        } else if (search.before) {
            found.selection = selection_after_edit(search.document, *search.before, progress);
        }
        if (found.selection && search.handles)
            found.handles = canvas_handles(search.document, *search.picture, *found.selection);
    } catch (const InputError&) {  // whoever asked for the picture is told
    } catch (const LimitError&) {
    }
    return found;
}

}  // namespace rinceau
