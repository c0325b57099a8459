#include "analyzer/grammar_bits.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "analyzer/colour_pattern.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

constexpr double precision = 0.002;  // of an element's size, and radians

double place_bits(double diagonal, double size) { return std::max(1.0, std::log2(diagonal / (precision * size))); }

double entropy(std::map<std::int64_t, int>& counts, double total) {
    double bits = 0;
    for (const auto& [unused, count] : counts) bits -= count / total * std::log2(count / total);
    return bits;
}

/// Cost of one instance of a look written flat: which look, place, angle and mirror, scale; the latter by their frequency.
std::vector<double> flat_bits(const Instancing& instancing, double diagonal) {
    struct Sample {
        std::map<std::int64_t, int> angles, scales, tints;
        double count = 0, log_size = 0;
    };
    std::vector<Sample> samples(instancing.looks.size());
    for (const Instance& instance : instancing.instances) {
        Sample& sample = samples[static_cast<std::size_t>(instance.look)];
        const SymmetryGroup& symmetry = instancing.looks[static_cast<std::size_t>(instance.look)].symmetry;
        const auto rotations = std::ranges::count_if(symmetry.elements, [](const Similarity& s) { return !s.mirrored; });
        const double fold = symmetry.continuous ? 0 : static_cast<double>(rotations);
        const double angle = fold > 0 ? wrap_angle(arg(instance.pose.linear) * fold) / fold : 0;
        const double log_scale = std::log(scale_of(instance.pose));
        ++sample.angles[std::llround(angle / precision) * 2 + (instance.pose.mirrored ? 1 : 0)];
        ++sample.scales[std::llround(log_scale / precision)];
        ++sample.tints[instance.tint];
        sample.log_size += log_scale;
        ++sample.count;
    }
    std::vector<double> bits;
    const double which = std::log2(std::max<double>(1, static_cast<double>(instancing.looks.size())));
    for (std::size_t look = 0; look < samples.size(); ++look) {
        Sample& sample = samples[look];
        if (!instancing.looks[look].verbatim.empty() || sample.count == 0) {
            bits.push_back(which);
            continue;
        }
        const double size = std::exp(sample.log_size / sample.count);
        bits.push_back(which + 2 * place_bits(diagonal, size) + entropy(sample.angles, sample.count) +
                       entropy(sample.scales, sample.count) + entropy(sample.tints, sample.count));
    }
    return bits;
}

bool is_natural_angle(double in_degrees) {
    return std::abs(in_degrees / 15 - std::round(in_degrees / 15)) < 1e-12 && std::abs(in_degrees) <= 360;
}

/// Natural values are short, as a person reads them; any other costs what its kind costs at the precision.
double number_bits(double value, double otherwise) {
    const double magnitude = std::abs(value);
    if (magnitude == std::round(magnitude) && magnitude <= 12) return 4;
    if (is_natural_angle(magnitude)) return 5;
    return otherwise;
}

/// How many of the last arguments choose styles (colouring.h).
std::size_t style_choices(const ModuleTemplate& module, const WrittenGrammar& written) {
    if (module.symbol == ";") return module.arguments.size();
    const auto found = written.tint_arguments.find(module.symbol);
    const std::size_t tints = found == written.tint_arguments.end() ? 0 : static_cast<std::size_t>(found->second);
    return std::min(tints, module.arguments.size());
}

double style_choice_bits(const ModuleTemplate& module, const WrittenGrammar& written) {
    double bits = 0;
    for (std::size_t k = module.arguments.size() - style_choices(module, written); k < module.arguments.size(); ++k)
        bits += tint_bits(module.arguments[k]);
    return bits;
}

constexpr double which_command = 2.5;

/// What a production says beyond its form: brackets, the condition and the call of itself are given with its kind.
double module_bits(const ModuleTemplate& module, const WrittenGrammar& written, const std::string& own_symbol, double symbols,
                   double length_bits) {
    const double angle_bits = std::log2(two_pi / precision);
    if (module.symbol == "[" || module.symbol == "]") return 0;
    if (module.symbol == own_symbol) return style_choice_bits(module, written);
    const bool turns = module.symbol == "+" || module.symbol == "-";
    double bits = find_turtle_command(module.symbol) != nullptr ? which_command : std::log2(symbols);
    bits += style_choice_bits(module, written);
    for (std::size_t k = 0; k + style_choices(module, written) < module.arguments.size(); ++k) {
        const Expression& argument = module.arguments[k];
        for (const Expression::Node& node : argument.postfix) {
            const bool number = node.op == Expression::Op::number;
            bits += number ? number_bits(node.number, turns ? angle_bits : length_bits) : 2;
        }
    }
    return bits;
}

/// A group in the axiom: two coordinates, angle, scale, its module and count.
double group_bits(const Similarity& turtle, double symbols, double length_bits) {
    constexpr double count_bits = 4, short_angle = 3, short_scale = 1, other_scale = 10;
    const double angle = degrees(arg(turtle.linear));
    const bool even = std::abs(scale_of(turtle) - 1) < precision;
    const bool natural = std::abs(angle / 15 - std::round(angle / 15)) * radians(15) < precision;
    return 2 * length_bits + (natural ? short_angle : std::log2(two_pi / precision)) + (even ? short_scale : other_scale) +
           std::log2(symbols) + count_bits;
}

/// What the move of a group holds, measured as that of one of its elements; twice if it turns or grows as well.
double move_bits(const MovedGroup& group, const WrittenGrammar& written, const Instancing& instancing) {
    double log_size = 0;
    for (std::size_t leaf = group.first_leaf; leaf < group.first_leaf + group.leaves; ++leaf)
        log_size += std::log(scale_of(instancing.instances[static_cast<std::size_t>(written.element_of_leaf[leaf])].pose));
    const double size = std::exp(log_size / static_cast<double>(group.leaves));
    return (group.turned ? 4 : 2) * std::log2(1 + group.deviation / (precision * size));
}

}  // namespace

double flat_list_bits(const Instancing& instancing, double diagonal) {
    const std::vector<double> flat = flat_bits(instancing, diagonal);
    double bits = 0;
    for (const Instance& instance : instancing.instances) bits += flat[static_cast<std::size_t>(instance.look)];
    return bits;
}

DescriptionBits description_bits(const OrderedRules& ordered, const WrittenGrammar& written, const Grammar& final_grammar,
                                 const Instancing& instancing, const LeftOver& left_over, double diagonal, double exact) {
    DescriptionBits bits;
    const std::vector<double> flat = flat_bits(instancing, diagonal);
    double log_size = 0, drawn = 0;
    for (const Instance& instance : instancing.instances) {
        bits.drawing += flat[static_cast<std::size_t>(instance.look)];
        if (!instancing.looks[static_cast<std::size_t>(instance.look)].verbatim.empty()) continue;
        log_size += std::log(scale_of(instance.pose));
        ++drawn;
    }
    const double size = drawn > 0 ? std::exp(log_size / drawn) : 1;
    const double length_bits = place_bits(diagonal, size);
    const double symbols = static_cast<double>(turtle_commands().size() + final_grammar.terminals.size()) +
                           static_cast<double>(final_grammar.productions.size());

    // Axiom: single elements cost what they cost in the drawing.
    for (const int root : ordered.roots) {
        const Item& item = ordered.rules.items[static_cast<std::size_t>(root)];
        const Part& part = ordered.rules.parts[static_cast<std::size_t>(item.part)];
        const Similarity turtle = item.pose * written.anchor_of_part[static_cast<std::size_t>(item.part)];
        bits.grammar +=
            part.look >= 0 ? flat[static_cast<std::size_t>(part.look)] : group_bits(turtle, symbols, length_bits);
        // What has no name is listed there, copy by copy.
        if (part.look < 0 && written.symbol_of_part[static_cast<std::size_t>(item.part)].empty())
            bits.grammar += std::log2(symbols) * static_cast<double>(item.members.size());
    }
    for (const ModuleTemplate& module : final_grammar.axiom) {
        if (module.symbol != ";") bits.grammar += style_choice_bits(module, written);  // of elements: told with them
    }
    for (const Production& production : final_grammar.productions) {
        bits.grammar += std::log2(symbols);
        for (const ModuleTemplate& module : production.successor) {
            bits.grammar += module_bits(module, written, production.symbol, symbols, length_bits);
        }
    }
    bits.grammar += static_cast<double>(final_grammar.constants.size()) * 6;
    const double leaf_bits = std::log2(std::max<double>(2, static_cast<double>(instancing.instances.size())));
    for (const Exception& exception : final_grammar.exceptions) {
        bits.grammar += leaf_bits;
        for (const ModuleTemplate& module : exception.successor) {
            // What a residual's numbers hold is counted by the deviation below.
            if (module.symbol == "z") bits.grammar += 6;
        }
    }
    for (const Exception& exception : written.grammar.exceptions) {  // what stands in for something else, where, in which style
        for (const ModuleTemplate& module : exception.successor)
            bits.grammar += module_bits(module, written, "", symbols, length_bits);
    }
    std::vector<char> alone(instancing.instances.size(), 0);  // written flat: nothing is left over
    for (const int root : ordered.roots) {
        const int element = ordered.rules.items[static_cast<std::size_t>(root)].element;
        if (element >= 0) alone[static_cast<std::size_t>(element)] = 1;
    }
    for (const MovedGroup& group : left_over.groups) bits.grammar += move_bits(group, written, instancing);
    const std::vector<double>& deviation = left_over.deviation;
    for (std::size_t leaf = 0; leaf < deviation.size() && leaf < written.element_of_leaf.size(); ++leaf) {
        const auto element = static_cast<std::size_t>(written.element_of_leaf[leaf]);
        if (alone[element]) continue;
        const Instance& instance = instancing.instances[element];
        const double in_precisions = deviation[leaf] / (precision * scale_of(instance.pose));
        if (in_precisions <= 1) continue;
        const double residual = 2 * std::log2(1 + in_precisions);
        bits.grammar += residual;
        if (deviation[leaf] <= exact) bits.unseen += residual;
    }
    return bits;
}

}  // namespace rinceau
