#include "growth/surface/check_shape_grammar.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "growth/surface/field_source.h"
#include "growth/surface/parse_shape_grammar.h"
#include "growth/surface/shape_derivation_options.h"
#include "growth/surface/shape_grammar_hints.h"
#include "growth/surface/surface_world.h"
#include "lsystem/mistakes.h"
#include "lsystem/similar_name.h"

namespace rinceau {

namespace {

/// All options, those of options_of() and of plane_piece().
constexpr std::array<std::string_view, 14> known_options{"cull",  "order",      "collide",   "follow",     "touch",
                                                         "kin",   "step",       "turn",      "jump",       "follow_share",
                                                         "plane", "max_shapes", "max_rules", "max_seconds"};

class ShapeGrammarChecker {
  public:
    ShapeGrammarChecker(const ShapeGrammar& grammar, const ReadNamedFile& read_file)
        : grammar_(grammar), read_file_(read_file), compiled_(compile_shape_grammar(grammar, {}, mistakes_)) {
        check_parts();
        check_options();
        for (const ShapeSource& shape : grammar_.shapes) keeping([&] { check_shape(shape); });
        for (const ShapeSource& field : grammar_.fields) keeping([&] { check_field(field); });
        std::ranges::stable_sort(
            mistakes_, {}, [](const Warning& mistake) { return std::tuple(mistake.place.line, mistake.place.column); });
    }

    const std::vector<Warning>& mistakes() const { return mistakes_; }
    const CompiledShapeGrammar& compiled() const { return compiled_; }

  private:
    const ShapeGrammar& grammar_;
    const ReadNamedFile& read_file_;
    std::vector<Warning> mistakes_;
    CompiledShapeGrammar compiled_;

    template <class Work>
    void keeping(Work work) {
        try {
            work();
        } catch (const InputError& error) {
            add_mistake(mistakes_, error);
        }
    }

    void check_parts() {
        const SourcePlace top{grammar_.file_name, 1, 1};
        if (grammar_.axioms.empty())
            add_mistake(mistakes_, top, "expected an axiom, such as 'axiom vertex 0 A', found none: nothing would grow");
    }

    void check_options() {
        for (const auto& [name, option] : grammar_.options) {
            if (std::ranges::find(known_options, name) != known_options.end()) continue;
            add_mistake(mistakes_, option.place,
                        "expected the name of an option, found '" + name + "'" +
                            instead_of(name, {known_options.begin(), known_options.end()}));
        }
        keeping([&] { plane_piece(grammar_); });
        keeping([&] {
            const std::string follow = options_of(grammar_).follow;
            const auto is_followed = [&](const ShapeSource& field) { return field.name == follow; };
            if (follow.empty() || follow == "none" || std::ranges::any_of(grammar_.fields, is_followed)) return;
            throw InputError(grammar_.options.at("follow").place,
                             "expected a field of this grammar, or none, for the option 'follow', found '" + follow + "'");
        });
    }

    void check_shape(const ShapeSource& shape) const {
        if (!shape.text.empty() && !read_file_) return;
        const auto number_of = [&](const Expression& value) { return value_of(value, grammar_, {}, shape.place); };
        make_shape(shape, read_file_, number_of);
    }

    void check_field(const ShapeSource& field) const {
        check_field_source(field_source_of(field, grammar_, {}));
        if (!field.text.empty() && read_file_) read_named(read_file_, field.text, field.place);
    }
};

}  // namespace

std::vector<Warning> shape_grammar_mistakes(const ShapeGrammar& grammar, const ReadNamedFile& read_file) {
    return ShapeGrammarChecker(grammar, read_file).mistakes();
}

GrammarFindings inspect_shape_grammar(std::string_view text, const std::string& file_name, const ReadNamedFile& read_file) {
    const ParsedShapeGrammar parsed = read_shape_grammar(text, file_name);
    // what stands in statements with mistakes is not known: names would seem to be missing
    if (!parsed.mistakes.empty()) return {parsed.mistakes, {}};
    const ShapeGrammarChecker checker(parsed.grammar, read_file);
    if (!checker.mistakes().empty()) return {checker.mistakes(), {}};
    return {{}, shape_grammar_hints(parsed.grammar, checker.compiled())};
}

}  // namespace rinceau
