#include "random_grammar.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rinceau {

namespace {

using Op = Expression::Op;

template <class Value, std::size_t size>
Value one_of(Random& random, const std::array<Value, size>& values) {
    return values[random.below(static_cast<std::uint32_t>(size))];
}

double random_number(Random& random) {
    switch (random.below(5)) {
        case 0:
            return random.below(10);
        case 1:
            return -1.0 * random.below(10);
        case 2:
            return random.uniform(-1000, 1000);
        case 3:
            return std::pow(10.0, random.uniform(-30, 30));
        default:
            return std::round(random.uniform(-100, 100) * 100) / 100;
    }
}

void append(Expression& target, const Expression& part) {
    target.postfix.insert(target.postfix.end(), part.postfix.begin(), part.postfix.end());
}

std::string random_text(Random& random) {
    static constexpr std::array<std::string_view, 9> pieces{"window", " ", "\"", "\\", "#", "é", "\n", "<<<SVG", ";"};
    std::string text;
    for (std::uint32_t i = random.below(6); i > 0; --i) text += one_of(random, pieces);
    return text;
}

std::string random_comment(Random& random) {
    static constexpr std::array<std::string_view, 5> lines{"", "a row of windows", "  indented", "# twice", "axiom: A"};
    std::string text;
    for (std::uint32_t i = random.below(3); i > 0; --i) {
        if (!text.empty()) text += '\n';
        text += one_of(random, lines);
    }
    return text;
}

std::vector<ModuleTemplate> random_string(Random& random, const std::vector<std::string>& names) {
    static constexpr std::array<std::string_view, 16> symbols{"+", "-", "f", "*",  "|",        "[", "]",  "fill",
                                                              ";", "z", "A", "P1", "Window_2", "B", "ff", "stroke"};
    std::vector<ModuleTemplate> string(random.below(30));
    for (ModuleTemplate& module : string) {
        module.symbol = one_of(random, symbols);
        for (std::uint32_t i = random.below(3); i > 0; --i) module.arguments.push_back(random_expression(random, names, 3));
    }
    return string;
}

Point random_point(Random& random) { return {random_number(random), random_number(random)}; }

Box random_box(Random& random) {
    if (random.below(4) == 0) return {};
    return including(including(Box{}, random_point(random)), random_point(random));
}

/// Path data hold numbers up to 1e15 (scene/svg_path_data.h).
Point random_outline_point(Random& random) {
    const Point point = random_point(random);
    constexpr double largest = 1e15;
    return std::abs(point.x) < largest && std::abs(point.y) < largest ? point : Point{1, 2};
}

Path random_path(Random& random) {
    Path path;
    path.start = random_outline_point(random);
    for (std::uint32_t i = 1 + random.below(5); i > 0; --i) {
        const Point to = random_outline_point(random);
        const bool straight = random.below(2) == 0;
        path.segments.push_back(straight ? line_to(to) : curve_to(random_outline_point(random), {3, -4}, to));
    }
    path.closed = random.below(2) == 0;
    return path;
}

Color random_color(Random& random) {
    const auto channel = [&] { return static_cast<std::uint8_t>(random.below(256)); };
    return {channel(), channel(), channel()};
}

Paint random_paint(Random& random) {
    const std::uint32_t kind = random.below(4);
    if (kind == 0) return NoPaint{};
    if (kind < 3) return random_color(random);
    Gradient gradient;
    gradient.kind = random.below(2) == 0 ? GradientKind::linear : GradientKind::radial;
    gradient.spread = one_of(random, std::array{GradientSpread::pad, GradientSpread::reflect, GradientSpread::repeat});
    gradient.map = {random_number(random), random_number(random), random_number(random),
                    random_number(random), random_number(random), random_number(random)};
    if (gradient.kind == GradientKind::radial) gradient.focus = {random.uniform(-0.5, 0.5), 0.25};
    if (random.below(3) == 0) gradient.focal_radius = random.uniform();
    double offset = 0;
    for (std::uint32_t i = 2 + random.below(3); i > 0; --i) {
        gradient.stops.push_back({offset, random_color(random), random.below(2) == 0 ? 1 : random.uniform()});
        offset = random.uniform(offset, 1);
    }
    return std::make_shared<const Gradient>(gradient);
}

Style random_style(Random& random) {
    Style style;
    style.fill = random_paint(random);
    style.fill_opacity = random.below(2) == 0 ? 1 : random.uniform();
    style.fill_rule = one_of(random, std::array{FillRule::nonzero, FillRule::evenodd});
    style.stroke.paint = random_paint(random);
    style.stroke.opacity = random.below(2) == 0 ? 1 : random.uniform();
    style.stroke.width = std::abs(random_number(random));
    style.stroke.cap = one_of(random, std::array{LineCap::butt, LineCap::round, LineCap::square});
    style.stroke.join = one_of(random, std::array{LineJoin::miter, LineJoin::round, LineJoin::bevel});
    style.stroke.miter_limit = 1 + random.below(9);
    for (std::uint32_t i = 2 * random.below(3); i > 0; --i) style.stroke.dashes.push_back(random.uniform(0, 9));
    style.stroke.dash_offset = random_number(random);
    style.stroke.fixed = random.below(3) == 0;
    if (!style.stroke.fixed && random.below(3) == 0) style.stroke.pen = {random_number(random), random_number(random), random_number(random), 1};
    style.opacity = random.below(2) == 0 ? 1 : random.uniform();
    style.stroke_first = random.below(2) == 0;
    style.crisp_edges = random.below(2) == 0;
    return style;
}

Terminal random_terminal(Random& random, const std::string& symbol) {
    static constexpr std::array<std::string_view, 8> fragment_lines{"<text>hi</text>", "SVG",      "SVG1",  "",
                                                                    "  # no comment",  "\"<<<SVG", "SVG\r", "x\t"};
    Terminal terminal;
    terminal.symbol = symbol;
    terminal.style = static_cast<int>(random.below(3));
    terminal.id = random_text(random);
    terminal.comment = random_comment(random);
    for (std::uint32_t i = random.below(3); i > 0; --i) terminal.paths.push_back(random_path(random));
    if (random.below(2) == 0) {
        terminal.verbatim_box = random_box(random);
        for (std::uint32_t i = random.below(6); i > 0; --i) {
            terminal.verbatim += one_of(random, fragment_lines);
            if (random.below(4) > 0) terminal.verbatim += '\n';
        }
    }
    return terminal;
}

bool same_strings(const std::vector<ModuleTemplate>& a, const std::vector<ModuleTemplate>& b) {
    return std::ranges::equal(a, b, [](const ModuleTemplate& x, const ModuleTemplate& y) {
        return x.symbol == y.symbol && x.arguments == y.arguments;
    });
}

bool same_paints(const Paint& a, const Paint& b) {
    const auto* first = std::get_if<std::shared_ptr<const Gradient>>(&a);
    const auto* second = std::get_if<std::shared_ptr<const Gradient>>(&b);
    if (first != nullptr && second != nullptr) return **first == **second;
    return a == b;
}

bool same_styles(const Style& a, const Style& b) {
    const Stroke& s = a.stroke;
    const Stroke& t = b.stroke;
    return same_paints(a.fill, b.fill) && a.fill_opacity == b.fill_opacity && a.fill_rule == b.fill_rule &&
           a.opacity == b.opacity && a.stroke_first == b.stroke_first && a.crisp_edges == b.crisp_edges &&
           same_paints(s.paint, t.paint) && s.opacity == t.opacity && s.width == t.width && s.cap == t.cap &&
           s.join == t.join && s.miter_limit == t.miter_limit && s.dashes == t.dashes && s.dash_offset == t.dash_offset &&
           s.fixed == t.fixed && s.pen == t.pen;
}

}  // namespace

Expression random_expression(Random& random, const std::vector<std::string>& names, int depth) {
    const std::uint32_t kind = depth <= 0 ? random.below(2) : random.below(8);
    if (kind == 0 || (kind == 1 && names.empty())) return number_expression(random_number(random));
    if (kind == 1) return name_expression(names[random.below(static_cast<std::uint32_t>(names.size()))]);
    Expression result = random_expression(random, names, depth - 1);
    if (kind == 2) {
        result.postfix.push_back({one_of(random, std::array{Op::negate, Op::logical_not}), 0, {}, 0});
    } else if (kind == 3) {
        append(result, random_expression(random, names, depth - 1));
        static const std::array<std::string, 6> functions{"min", "pow", "atan2", "hypot", "uniform", "normal"};
        result.postfix.push_back({Op::call, 0, one_of(random, functions), 2});
    } else if (kind == 4) {
        append(result, random_expression(random, names, depth - 1));
        append(result, random_expression(random, names, depth - 1));
        result.postfix.push_back({Op::call, 0, one_of(random, std::array<std::string, 3>{"if", "clamp", "max"}), 3});
    } else {
        append(result, random_expression(random, names, depth - 1));
        result.postfix.push_back(
            {one_of(random, std::array{Op::add, Op::subtract, Op::multiply, Op::divide, Op::modulo, Op::power, Op::less,
                                       Op::less_equal, Op::greater, Op::greater_equal, Op::equal, Op::not_equal,
                                       Op::logical_and, Op::logical_or}),
             0,
             {},
             0});
    }
    return result;
}

namespace {

std::string random_symbol(Random& random) { return one_of(random, std::array<std::string, 3>{"A", "P1", "Window_2"}); }

/// Names that are new in `names`, to which they are added.
std::vector<std::string> random_parameters(Random& random, std::vector<std::string>& names) {
    std::vector<std::string> parameters;
    for (std::uint32_t k = random.below(3); k > 0; --k) {
        parameters.push_back("p" + std::to_string(names.size()));
        names.push_back(parameters.back());
    }
    return parameters;
}

std::vector<ContextModule> random_context(Random& random, std::vector<std::string>& names) {
    std::vector<ContextModule> context(random.below(3));
    for (ContextModule& module : context) {
        module.symbol = random_symbol(random);
        module.parameters = random_parameters(random, names);
    }
    return context;
}

Production random_production(Random& random, std::vector<std::string> names) {
    Production production;
    production.kind = one_of(random, std::array{ProductionKind::rewriting, ProductionKind::rewriting,
                                                ProductionKind::decomposition, ProductionKind::homomorphism});
    production.symbol = random_symbol(random);
    production.parameters = random_parameters(random, names);
    if (production.kind == ProductionKind::rewriting && random.below(2) == 0) {
        production.left_context = random_context(random, names);
        production.right_context = random_context(random, names);
    }
    if (random.below(2) == 0) production.condition = random_expression(random, names, 3);
    if (random.below(3) == 0) production.weight = random_expression(random, names, 2);
    production.successor = random_string(random, names);
    production.comment = random_comment(random);
    return production;
}

bool same_contexts(const std::vector<ContextModule>& a, const std::vector<ContextModule>& b) {
    return std::ranges::equal(a, b, [](const ContextModule& x, const ContextModule& y) {
        return x.symbol == y.symbol && x.parameters == y.parameters;
    });
}

bool same_productions(const Production& a, const Production& b) {
    return a.symbol == b.symbol && a.parameters == b.parameters && a.condition == b.condition && a.weight == b.weight &&
           a.kind == b.kind && same_contexts(a.left_context, b.left_context) &&
           same_contexts(a.right_context, b.right_context) && same_strings(a.successor, b.successor) &&
           a.comment == b.comment;
}

bool same_uses(const Use& a, const Use& b) {
    return a.file == b.file && a.prefix == b.prefix && a.comment == b.comment;
}

}  // namespace

Grammar random_grammar(Random& random) {
    Grammar grammar;
    grammar.title = random_text(random);
    grammar.canvas = random_box(random);
    grammar.sized = random.below(3) > 0;
    for (std::uint32_t i = random.below(3); i > 0; --i) grammar.comments.push_back(random_comment(random).substr(0, 8));
    for (std::string& line : grammar.comments) std::ranges::replace(line, '\n', ' ');
    if (random.below(3) == 0) grammar.seed = (std::uint64_t{random.below(1U << 31U)} << 33U) + random.below(100);
    for (std::uint32_t i = random.below(3); i > 0; --i) {
        grammar.uses.push_back({'x' + random_text(random), random.below(2) == 0 ? "" : "vine_2", random_comment(random)});
    }
    if (random.below(3) == 0) grammar.ignored = {"P1", "Unknown"};
    std::vector<std::string> names;
    for (std::uint32_t i = random.below(3); i > 0; --i) {
        const std::string name = "c" + std::to_string(i);
        grammar.constants.push_back({name, random_expression(random, names, 3), random_comment(random)});
        names.push_back(name);
    }
    grammar.axiom = random_string(random, names);
    for (std::uint32_t i = random.below(4); i > 0; --i) {
        Production production;
        grammar.productions.push_back(random_production(random, names));
    }
    for (std::uint32_t i = random.below(3); i > 0; --i) {
        Exception exception{{static_cast<int>(1 + random.below(9))}, random_string(random, names), random_comment(random)};
        if (random.below(2) == 0) exception.address.push_back(static_cast<int>(1 + random.below(9)));
        grammar.exceptions.push_back(std::move(exception));
    }
    for (std::uint32_t i = random.below(3); i > 0; --i) {
        grammar.styles.push_back({static_cast<int>(i), random_style(random), random_comment(random)});
    }
    for (const char* symbol : {"A", "Window_2"}) grammar.terminals.push_back(random_terminal(random, symbol));
    return grammar;
}

bool same_grammar(const Grammar& a, const Grammar& b) {
    return a.title == b.title && a.canvas == b.canvas && a.sized == b.sized && a.comments == b.comments &&
           same_strings(a.axiom, b.axiom) &&
           std::ranges::equal(a.constants, b.constants,
                              [](const Constant& x, const Constant& y) {
                                  return x.name == y.name && x.value == y.value && x.comment == y.comment;
                              }) &&
           a.seed == b.seed && a.ignored == b.ignored && std::ranges::equal(a.uses, b.uses, same_uses) &&
           std::ranges::equal(a.productions, b.productions, same_productions) &&
           std::ranges::equal(a.exceptions, b.exceptions,
                              [](const Exception& x, const Exception& y) {
                                  return x.address == y.address && same_strings(x.successor, y.successor) &&
                                         x.comment == y.comment;
                              }) &&
           std::ranges::equal(a.styles, b.styles,
                              [](const NumberedStyle& x, const NumberedStyle& y) {
                                  return x.number == y.number && same_styles(x.style, y.style) && x.comment == y.comment;
                              }) &&
           std::ranges::equal(a.terminals, b.terminals, [](const Terminal& x, const Terminal& y) {
               return x.symbol == y.symbol && x.style == y.style && x.paths == y.paths && x.verbatim == y.verbatim &&
                      x.verbatim_box == y.verbatim_box && x.id == y.id && x.comment == y.comment;
           });
}

}  // namespace rinceau
