#pragma once
// The picture of a document, as small as drawing it needs.

#include <cstdint>
#include <memory>
#include <vector>

#include "editor/model/document.h"
#include "geometry/progress.h"
#include "lsystem/interpret.h"

namespace rinceau {

/// A terminal in a style: what one mesh draws.
struct PictureLook {
    int terminal = 0;  ///< index into Grammar::terminals
    int style = 0;     ///< number of the NumberedStyle it is painted in; 0 = the default Style; of no account if verbatim
    friend constexpr auto operator<=>(const PictureLook&, const PictureLook&) = default;
};

struct PictureItem {
    Similarity pose;         ///< terminal frame -> scene
    std::int32_t look = 0;   ///< index into DerivedPicture::looks
    std::int32_t order = 0;  ///< in order of derivation (Placement::order): what selections and highlights refer to
    Repaint repaint;
};

struct DerivedPicture {
    std::shared_ptr<const Grammar> grammar;  ///< resolved: holds the terminals and styles of the looks
    std::vector<PictureLook> looks;
    std::vector<PictureItem> items;  ///< in paint order
    double seconds = 0;              ///< that deriving it took
};

/// Derives and interprets the document's grammar. Throws as interpret().
DerivedPicture derive_picture(const Document& document, const Progress& progress = {});

/// The picture of placements of the grammar's terminals, in the order given.
DerivedPicture placed_picture(const std::shared_ptr<const Grammar>& grammar, const std::vector<Placement>& placements);

/// The picture of the drawing that the document was found in: an item per element. Empty without a drawing.
DerivedPicture drawing_picture(const Scene& drawing);

/// The style that a look is painted in.
Style picture_style(const DerivedPicture& picture, const PictureLook& look);

}  // namespace rinceau
