#pragma once
// Some elements of a document, to be replaced by another drawing; the rest of the document stays byte for byte.

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/element.h"
#include "scene/input_error.h"
#include "scene/svg_read.h"

namespace rinceau {

/// What is put in the place of the selection.
struct SvgReplacementContent {
    std::string svg;    ///< a drawing whose SVG px are the unit of scene()
    std::string rules;  ///< kept with it, as the description of the group
    std::string label;  ///< of the group, in the editor's list of objects
};

/// Which of the ids are of, or inside, a group that a replacement has put into a document.
struct IdsByRules {
    std::vector<std::string> with_rules, others;
};
IdsByRules ids_by_rules(std::string_view document, std::span<const std::string> ids, const SvgReadOptions& options = {});

class SvgReplacement {
  public:
    /// Selects by ids as svg_selection.h says; without any, everything on the page that is neither locked nor hidden.
    /// Throws InputError and LimitError as read_svg does.
    SvgReplacement(std::string_view document, std::span<const std::string> ids, const SvgReadOptions& options = {});
    ~SvgReplacement();
    SvgReplacement(const SvgReplacement&) = delete;
    SvgReplacement& operator=(const SvgReplacement&) = delete;

    /// What is selected, in the space that the replacement is drawn in: that of the group around the uppermost selected
    /// element, or of the group of an earlier replacement. Empty if nothing is selected that draws anything.
    const Scene& scene() const;
    const std::vector<Warning>& warnings() const;
    /// The rules that an earlier replacement has left, if exactly that is selected; else empty.
    const std::string& rules() const;
    /// So many drawn elements that are not selected will lie below what they lay on.
    std::size_t overtaken() const;

    /// The document with a group in the place and by the id of the uppermost selected element, in which the definitions of `content.svg`
    /// that are used twice or more are elements on the page and their uses clones (svg_originals.h). The other selected
    /// elements are gone; what something else refers to has moved to the definitions. The place must not be empty.
    std::string document_with(const SvgReplacementContent& content) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rinceau
