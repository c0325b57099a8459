#include "scene/svg_read.h"

#include "scene/compound_path.h"
#include "scene/svg_budget.h"
#include "scene/svg_draw.h"
#include "scene/svg_source.h"

namespace rinceau {
namespace {

/// What would come from other files.
void note_inclusions(SvgReader& reader, const SvgNode& node) {
    if (node.name == "include" && node.space_name == "http://www.w3.org/2001/XInclude")
        reader.warnings.add("{} XInclude elements are left out: other files are not read", node);
    for (const SvgNode* child = node.first_child; child != nullptr; child = child->next) note_inclusions(reader, *child);
}

}  // namespace

SvgReadResult read_svg(std::string_view bytes, const SvgReadOptions& options) {
    const SvgSourceOptions source{options.file_name, options.max_bytes, options.max_depth};
    const std::string text = svg_source_text(bytes, source);
    const SvgTree tree = parse_svg_tree(text, source);
    SvgReader reader = reader_of(tree, options);
    reader.scene.elements.reserve(expanded_elements(reader));
    for (const std::string& fault : reader.sheet.faults) reader.warnings.add(fault, tree.root());
    note_inclusions(reader, tree.root());
    if (text.substr(0, text.find("<svg")).find("<?xml-stylesheet") != std::string::npos)
        reader.warnings.add("style sheets in other files (xml-stylesheet) are not read", tree.root());
    draw_root(reader);
    if (options.split_compound_paths) reader.scene.elements = split_compound_paths(std::move(reader.scene.elements));
    return {std::move(reader.scene), reader.warnings.summary(options.file_name)};
}

}  // namespace rinceau
