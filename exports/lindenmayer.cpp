#include "exports/lindenmayer.h"

#include <algorithm>
#include <map>
#include <sstream>

#include "exports/js_expression.h"
#include "exports/json_style.h"
#include "exports/number.h"
#include "exports/unique_names.h"
#include "lsystem/derivation_facts.h"
#include "lsystem/flat_grammar.h"
#include "lsystem/plain_rules.h"
#include "lsystem/unfolded_exceptions.h"
#include "scene/svg_write.h"

namespace rinceau {

namespace {

using NameMap = std::map<std::string, std::string>;

std::set<std::string> js_words() {
    return {"break",   "case",      "catch",     "class",      "const",     "continue",   "debugger",  "default",
            "delete",  "do",        "else",      "enum",       "export",    "extends",    "false",     "finally",
            "for",     "function",  "if",        "import",     "in",        "instanceof", "new",       "null",
            "return",  "super",     "switch",    "this",       "throw",     "true",       "try",       "typeof",
            "var",     "void",      "while",     "with",       "yield",     "let",        "static",    "await",
            "async",   "eval",      "arguments", "implements", "interface", "package",    "private",   "protected",
            "public",  "undefined", "NaN",       "Infinity",   "Math",      "JSON",       "console",   "process",
            "LSystem", "lsystem",   "math",      "inRadians",  "canvas",    "styles",     "terminals", "placements",
            "Turtle",  "finals",    "module",    "part",       "Object"};
}

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

class ModuleWriter {
  public:
    explicit ModuleWriter(const Grammar& grammar) : grammar_(grammar), names_(js_words()) {
        for (const Constant& constant : grammar.constants) constants_[constant.name] = names_.take(constant.name);
    }

    std::string write(int iterations) const {
        std::string text;
        append_comments(text, grammar_.title);
        for (const std::string& line : grammar_.comments) append_comments(text, line);
        text += "// npm install lindenmayer\nimport LSystem from 'lindenmayer';\n\n";
        text += canvas_text() + styles_text() + terminals_text() + '\n';
        text += js_functions();
        for (const Constant& constant : grammar_.constants)
            text += "const " + constants_.at(constant.name) + " = " + js_expression(constant.value, constants_) + ";\n";
        text += "const module = (symbol, ...params) => ({ symbol, params });\n\n";
        text +=
            "export const lsystem = new LSystem({\n  axiom: [" + modules_text(grammar_.axiom, constants_, "    ") + "],\n";
        text += "  productions: {\n" + productions_text() + "  },\n  finals: finals(),\n});\n";
        text += "lsystem.iterate(" + std::to_string(iterations) + ");\n\n";
        return text + turtle_text();
    }

  private:
    const Grammar& grammar_;
    UniqueNames names_;
    NameMap constants_;

    static void append_comments(std::string& text, const std::string& lines) {
        std::istringstream stream(lines);
        stream.exceptions(std::ios::badbit);  // a lack of memory passes
        for (std::string line; std::getline(stream, line);) text += "// " + line + '\n';
    }

    std::string canvas_text() const {
        const Box& box = grammar_.canvas;
        if (is_empty(box)) return "export const canvas = null;\n";
        return "export const canvas = { x: " + number_of(box.low.x) + ", y: " + number_of(-box.high.y) +
               ", width: " + number_of(box.high.x - box.low.x) + ", height: " + number_of(box.high.y - box.low.y) + " };\n";
    }

    /// SVG's properties by number; 0 = a terminal without style.
    std::string styles_text() const {
        std::string text = "export const styles = {\n  0: {},\n";
        for (const NumberedStyle& style : grammar_.styles)
            text += "  " + std::to_string(style.number) + ": " + dumped(style_json(style.style)) + ",\n";
        return text + "};\n";
    }

    std::string terminals_text() const {
        std::string text = "export const terminals = {\n";
        for (const Terminal& terminal : grammar_.terminals) {
            Json json{{"style", terminal.style}, {"path", svg_path_data(terminal.paths)}};
            if (!terminal.verbatim.empty()) json["verbatim"] = terminal.verbatim;
            text += "  " + dumped(terminal.symbol) + ": " + dumped(json) + ",\n";
        }
        return text + "};\n";
    }

    static std::string modules_text(const std::vector<ModuleTemplate>& modules, const NameMap& names,
                                    const std::string& indent) {
        constexpr std::size_t longest = 110;
        std::string text;
        std::size_t line = indent.size();
        for (const ModuleTemplate& module : modules) {
            std::string call = "module('" + module.symbol + '\'';
            for (const Expression& argument : module.arguments) call += ", " + js_expression(argument, names);
            call += ')';
            const bool full = line + call.size() > longest && !text.empty();
            if (!text.empty()) text += full ? ",\n" + indent : ", ";
            line = full ? indent.size() + call.size() : line + call.size() + 2;
            text += call;
        }
        return text;
    }

    std::string productions_text() const {
        std::vector<std::string> symbols;
        for (const Production& production : grammar_.productions) {
            if (std::ranges::find(symbols, production.symbol) == symbols.end()) symbols.push_back(production.symbol);
        }
        std::string text;
        for (const std::string& symbol : symbols) {
            text += "    " + dumped(symbol) + ": ({ part }) => {\n";
            for (const Production& production : grammar_.productions) {
                if (production.symbol == symbol) text += production_text(production);
            }
            text += "      return part;\n    },\n";
        }
        return text;
    }

    std::string production_text(const Production& production) const {
        NameMap names = constants_;
        std::string list;
        std::set<std::string> own;
        for (const std::string& parameter : production.parameters) {
            std::string name = parameter;
            while (names_.is_taken(name) || own.contains(name)) name += '_';
            own.insert(name);
            names[parameter] = name;
            list += (list.empty() ? "" : ", ") + name;
        }
        std::string text = "      if (part.params.length === " + std::to_string(production.parameters.size()) + ") {\n";
        if (!list.empty()) text += "        const [" + list + "] = part.params;\n";
        const std::string condition =
            production.condition ? "if (" + js_expression(*production.condition, names) + ") " : "";
        text +=
            "        " + condition + "return [" + modules_text(production.successor, names, "          ") + "];\n      }\n";
        return text;
    }

    static std::string turtle_text() {
        return R"(// Where what is drawn stands, y down as in SVG; the turtle heads up.
class Turtle {
  state = { matrix: [1, 0, 0, 1, 0, 0], style: 0, layer: 0, fill: null, stroke: null };
  stack = [];
  placements = [];

  transform(a, b, c, d, e, f) {
    const [p, q, r, s, t, u] = this.state.matrix;
    this.state.matrix =
      [p * a + r * b, q * a + s * b, p * c + r * d, q * c + s * d, p * e + r * f + t, q * e + s * f + u];
  }
  turn(left) {
    const cos = math.cos(left), sin = math.sin(left);
    this.transform(cos, -sin, sin, cos, 0, 0);
  }
  draw(terminal) {
    const { matrix, style, layer, fill, stroke } = this.state;
    this.placements.push({ terminal, style: style || terminals[terminal].style, layer, fill, stroke, matrix });
  }
}

const color = channels => (channels.length < 3 ? null
  : '#' + channels.map(c => Math.min(255, Math.max(0, Math.round(c))).toString(16).padStart(2, '0')).join(''));

function finals() {
  const commands = {
    '+': ({ part }, turtle) => turtle.turn(part.params[0]),
    '-': ({ part }, turtle) => turtle.turn(-part.params[0]),
    f: ({ part }, turtle) => turtle.transform(1, 0, 0, 1, 0, -part.params[0]),
    '*': ({ part }, turtle) => turtle.transform(part.params[0], 0, 0, part.params[0], 0, 0),
    '|': (_, turtle) => turtle.transform(-1, 0, 0, 1, 0, 0),
    '[': (_, turtle) => turtle.stack.push({ ...turtle.state }),
    ']': (_, turtle) => { turtle.state = turtle.stack.pop(); },
    ';': ({ part }, turtle) => { turtle.state.style = part.params[0]; },
    z: ({ part }, turtle) => { turtle.state.layer += part.params[0]; },
    fill: ({ part }, turtle) => { turtle.state.fill = color(part.params); },
    stroke: ({ part }, turtle) => { turtle.state.stroke = color(part.params); },
  };
  for (const terminal of Object.keys(terminals)) commands[terminal] = (_, turtle) => turtle.draw(terminal);
  return commands;
}

// What is drawn, the lowest first: { terminal, style, layer, fill, stroke, matrix } with SVG's [a, b, c, d, e, f].
export function placements() {
  const turtle = new Turtle();
  lsystem.final(turtle);
  return turtle.placements.sort((one, other) => one.layer - other.layer);
}

if (typeof process !== 'undefined' && process.argv[1] && import.meta.url.endsWith(encodeURI(process.argv[1])))
  console.log(JSON.stringify(placements()));
)";
    }
};

}  // namespace

Export to_lindenmayer(const Grammar& grammar, const ExportOptions& options) {
    Export result;
    Grammar plain;
    if (is_stochastic(grammar) || is_context_sensitive(grammar)) {
        plain = flat_grammar(grammar, options.derive);
        result.notes.push_back(is_context_sensitive(grammar)
                                   ? "contexts are written as what they lead to: every placement by itself"
                                   : "what is drawn by chance is frozen as the seed has it: every placement by itself");
    } else {
        plain = plain_rules(unfolded_exceptions(grammar, options.derive));
    }
    DeriveOptions whole = options.derive;
    whole.depth = -1;
    result.bytes = ModuleWriter(plain).write(derivation_facts(plain, whole).depth);
    return result;
}

}  // namespace rinceau
