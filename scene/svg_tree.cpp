#include "scene/svg_tree.h"

#include "scene/svg_document.h"
#include "scene/svg_number.h"

namespace rinceau {
namespace {

constexpr std::string_view svg_uri = "http://www.w3.org/2000/svg";
constexpr std::string_view xlink_uri = "http://www.w3.org/1999/xlink";

struct QualifiedName {
    std::string_view prefix, local;
};

QualifiedName split_name(std::string_view name) {
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? QualifiedName{{}, name} : QualifiedName{name.substr(0, colon), name.substr(colon + 1)};
}

SvgNamespace namespace_of(std::string_view uri) {
    if (uri == svg_uri) return SvgNamespace::svg;
    if (uri == xlink_uri) return SvgNamespace::xlink;
    return uri.empty() ? SvgNamespace::none : SvgNamespace::other;
}

struct PrefixBinding {
    std::string_view prefix, uri;
};

}  // namespace

struct SvgTree::Document {
    std::unique_ptr<tinyxml2::XMLDocument> parsed;
};

SvgTree::SvgTree() : document_(std::make_unique<Document>()) {}
SvgTree::~SvgTree() = default;
SvgTree::SvgTree(SvgTree&&) noexcept = default;
SvgTree& SvgTree::operator=(SvgTree&&) noexcept = default;

const SvgNode* SvgTree::find(std::string_view id) const {
    const auto found = ids_.find(id);
    return found == ids_.end() ? nullptr : found->second;
}

const std::string_view* find_attribute(const SvgNode& node, std::string_view name) {
    for (const SvgAttribute& attribute : node.attributes)
        if (attribute.space == SvgNamespace::none && attribute.name == name) return &attribute.value;
    return nullptr;
}

std::string_view href_of(const SvgNode& node) {
    std::string_view found;
    for (const SvgAttribute& attribute : node.attributes) {
        if (attribute.name != "href") continue;
        if (attribute.space == SvgNamespace::none) return trimmed(attribute.value);
        if (attribute.space == SvgNamespace::xlink) found = trimmed(attribute.value);
    }
    return found;
}

/// Turns the XML library's document into nodes.
class SvgTreeBuilder {
  public:
    SvgTree build(const std::string& text, const SvgSourceOptions& options) {
        tree_.document_->parsed = parse_svg_document(text, options);
        const tinyxml2::XMLElement* root = tree_.document_->parsed->RootElement();
        if (root == nullptr) throw InputError({options.file_name, 1, 1}, "expected an <svg> element, found none");
        accept_plain_names(*root);
        add_element(*root, nullptr);
        if (!is_svg(tree_.root()) || tree_.root().name != "svg") {
            const std::size_t tag = text.find("<" + std::string(root->Name()));
            throw InputError(place_in_text(text, tag == std::string::npos ? 0 : tag, options.file_name),
                             "expected the root element <svg>, found <" + std::string(root->Name()) + ">");
        }
        return std::move(tree_);
    }

  private:
    /// A drawing without any namespace is taken for SVG all the same.
    void accept_plain_names(const tinyxml2::XMLElement& root) {
        if (std::string_view(root.Name()) == "svg" && root.FindAttribute("xmlns") == nullptr) bindings_.push_back({"", svg_uri});
    }

    std::string_view uri_of(std::string_view prefix) const {
        for (std::size_t i = bindings_.size(); i-- > 0;)
            if (bindings_[i].prefix == prefix) return bindings_[i].uri;
        return {};
    }

    SvgNamespace attribute_space(const QualifiedName& name) const {
        if (name.prefix.empty()) return name.local == "xmlns" ? SvgNamespace::declaration : SvgNamespace::none;
        if (name.prefix == "xml") return SvgNamespace::xml;
        if (name.prefix == "xmlns") return SvgNamespace::declaration;
        const std::string_view uri = uri_of(name.prefix);
        // Many drawings use the usual prefix without declaring it.
        if (uri.empty() && name.prefix == "xlink") return SvgNamespace::xlink;
        const SvgNamespace space = namespace_of(uri);
        return space == SvgNamespace::none ? SvgNamespace::other : space;
    }

    void bind_prefixes(const tinyxml2::XMLElement& element) {
        for (const auto* attribute = element.FirstAttribute(); attribute != nullptr; attribute = attribute->Next()) {
            const std::string_view name = attribute->Name();
            if (name == "xmlns") bindings_.push_back({"", attribute->Value()});
            if (name.starts_with("xmlns:")) bindings_.push_back({name.substr(6), attribute->Value()});
        }
    }

    void read_attributes(const tinyxml2::XMLElement& element, SvgNode& node) {
        for (const auto* attribute = element.FirstAttribute(); attribute != nullptr; attribute = attribute->Next()) {
            const QualifiedName name = split_name(attribute->Name());
            node.attributes.push_back({name.local, attribute->Value(), attribute_space(name)});
        }
        if (const std::string_view* id = find_attribute(node, "id"); id != nullptr && !id->empty()) tree_.ids_.emplace(*id, &node);
    }

    SvgNode& add_element(const tinyxml2::XMLElement& element, SvgNode* parent) {
        const std::size_t outer_bindings = bindings_.size();
        bind_prefixes(element);
        SvgNode& node = tree_.nodes_.emplace_back();
        const QualifiedName name = split_name(element.Name());
        node.name = name.local;
        node.space_name = uri_of(name.prefix);
        node.space = namespace_of(node.space_name);
        // An undeclared "svg:" prefix can only mean one thing.
        if (node.space == SvgNamespace::none && name.prefix == "svg") node.space = SvgNamespace::svg;
        node.line = element.GetLineNum();
        node.parent = parent;
        read_attributes(element, node);
        add_children(element, node);
        bindings_.resize(outer_bindings);
        return node;
    }

    void add_children(const tinyxml2::XMLElement& element, SvgNode& node) {
        SvgNode* last = nullptr;
        SvgNode* last_element = nullptr;
        for (const tinyxml2::XMLNode* child = element.FirstChild(); child != nullptr; child = child->NextSibling()) {
            SvgNode* added = nullptr;
            if (const tinyxml2::XMLElement* inner = child->ToElement()) {
                added = &add_element(*inner, &node);
                added->previous_element = last_element;
                if (last_element != nullptr) {
                    last_element->next_element = added;
                    added->position = last_element->position + 1;
                }
                last_element = added;
            } else if (const tinyxml2::XMLText* text = child->ToText()) {
                added = &tree_.nodes_.emplace_back();
                added->text = text->Value();
                added->parent = &node;
                added->line = text->GetLineNum();
            }
            if (added == nullptr) continue;
            (last == nullptr ? node.first_child : last->next) = added;
            last = added;
        }
    }

    SvgTree tree_;
    std::vector<PrefixBinding> bindings_;  ///< innermost last
};

SvgTree parse_svg_tree(const std::string& text, const SvgSourceOptions& options) { return SvgTreeBuilder().build(text, options); }

}  // namespace rinceau
