#include "growth/surface/shape_derivation_options.h"

#include <cmath>

#include "growth/surface/shape_programs.h"
#include "lsystem/number_text.h"

namespace rinceau {

namespace {

/// The options of one grammar, one after the other.
struct OptionReader {
    const ShapeGrammar* grammar;

    const ShapeSource* find(const std::string& name) const {
        const auto found = grammar->options.find(name);
        return found == grammar->options.end() ? nullptr : &found->second;
    }

    /// The word's place in `words`, or `otherwise` if the option is not given.
    std::size_t word(const std::string& name, const std::vector<std::string>& words, std::size_t otherwise) const {
        const ShapeSource* source = find(name);
        if (source == nullptr) return otherwise;
        std::string expected;
        for (std::size_t i = 0; i < words.size(); ++i) {
            if (source->text == words[i]) return i;
            expected += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
        }
        throw InputError(source->place,
                         "expected " + expected + " for the option '" + name + "', found '" + source->text + "'");
    }

    double number(const std::string& name, double lowest, double highest, double otherwise) const {
        const ShapeSource* source = find(name);
        if (source == nullptr) return otherwise;
        const auto given = source->numbers.find("value");
        if (given == source->numbers.end())
            throw InputError(source->place, "expected a number for the option '" + name + "', found '" + source->text + "'");
        const double value = value_of(given->second, *grammar, {}, source->place);
        if (value >= lowest && value <= highest) return value;
        throw InputError(source->place, "expected a number from " + number_text(lowest) + " to " + number_text(highest) +
                                            " for the option '" + name + "', found " + number_text(value));
    }
    long whole(const std::string& name, double lowest, double highest, long otherwise) const {
        return std::lround(number(name, lowest, highest, static_cast<double>(otherwise)));
    }
};

}  // namespace

ShapeDerivationOptions options_of(const ShapeGrammar& grammar, ShapeDerivationOptions defaults) {
    constexpr double most = 1e9;
    const OptionReader read{&grammar};
    ShapeDerivationOptions options = std::move(defaults);
    options.cull =
        static_cast<CullScope>(read.word("cull", {"bracket", "rule", "none"}, static_cast<std::size_t>(options.cull)));
    options.breadth_first = read.word("order", {"breadth", "depth"}, options.breadth_first ? 0 : 1) == 0;
    options.collide_all = read.word("collide", {"asked", "all"}, options.collide_all ? 1 : 0) == 1;
    if (const ShapeSource* follow = read.find("follow")) options.follow = follow->text;
    options.touch = read.number("touch", 0, 0.5, options.touch);
    options.kin = static_cast<int>(read.whole("kin", 0, 64, options.kin));
    options.trace.step = read.number("step", 1e-3, 1, options.trace.step);
    options.trace.turn = read.number("turn", 0.1, 90, options.trace.turn);
    options.trace.jump = read.number("jump", 0, 1, options.trace.jump);
    options.trace.follow = read.number("follow_share", 0, 1, options.trace.follow);
    options.max_shapes = read.whole("max_shapes", 1, most, options.max_shapes);
    options.max_rules = read.whole("max_rules", 1, most, options.max_rules);
    options.max_seconds = read.number("max_seconds", 0, most, options.max_seconds);
    return options;
}

}  // namespace rinceau
