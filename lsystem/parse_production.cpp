#include "lsystem/parse_production.h"

#include <set>
#include <utility>

#include "lsystem/similar_name.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

class ProductionReader {
  public:
    explicit ProductionReader(Scanner& scanner) : scanner_(scanner) {}

    std::optional<Production> read() {
        production_.place = scanner_.place();
        production_.kind = kind();
        try {
            read_predecessor();
            if (scanner_.take(":")) production_.condition = scanner_.condition();
            scanner_.expect("->");
        } catch (const InputError& error) {
            scanner_.keep(error);
            pass_rest();
            return std::nullopt;
        }
        read_successor();
        production_.comment = scanner_.statement().comment;
        return std::move(production_);
    }

  private:
    static constexpr std::string_view what_begins = "a production's symbol, as in A -> ..";

    Scanner& scanner_;
    Production production_;
    std::set<std::string> parameters_;  // of the symbol and its context

    void read_successor() {
        production_.successor = scanner_.modules(":");
        if (scanner_.take(":")) production_.weight = scanner_.expression_until("");
    }
    /// For its mistakes.
    void pass_rest() {
        if (!scanner_.skip_to("->")) return;
        scanner_.expect("->");
        read_successor();
    }

    ProductionKind kind() {
        if (take_word(decomposition_word)) return ProductionKind::decomposition;
        if (take_word(homomorphism_word)) return ProductionKind::homomorphism;
        return ProductionKind::rewriting;
    }
    bool take_word(std::string_view word) { return scanner_.peek_name() == word && scanner_.take(word); }

    /// left < symbol > right
    void read_predecessor() {
        std::vector<ContextModule> modules = read_modules(what_begins);
        if (scanner_.take("<")) {
            production_.left_context = std::move(modules);
            modules = read_modules("the symbol that is rewritten");
        }
        if (modules.size() > 1) {
            throw InputError(modules[1].place, "expected one symbol before '->', found " + modules[1].symbol +
                                                   " after it: write '<' behind a left context, '>' before a right one" +
                                                   did_you_mean(modules[0].symbol, {decomposition_word, homomorphism_word}));
        }
        production_.symbol = std::move(modules.front().symbol);
        production_.parameters = std::move(modules.front().parameters);
        if (scanner_.take(">")) production_.right_context = read_modules("a symbol of the right context");
        const bool in_context = !production_.left_context.empty() || !production_.right_context.empty();
        if (in_context && production_.kind != ProductionKind::rewriting) {
            throw InputError(production_.place,
                             "expected a decomposition or homomorphism without a context, found one with "
                             "'<' or '>': leave the context out, or the word before");
        }
    }

    std::vector<ContextModule> read_modules(std::string_view what) {
        std::vector<ContextModule> modules;
        do {
            ContextModule module;
            module.place = scanner_.place();
            module.symbol = scanner_.name(what);
            if (find_turtle_command(module.symbol) != nullptr) {
                throw InputError(module.place,
                                 "expected a symbol of your own before ->, found the command '" + module.symbol + "'");
            }
            module.parameters = read_parameters();
            modules.push_back(std::move(module));
        } while (!scanner_.peek_name().empty());
        return modules;
    }

    std::vector<std::string> read_parameters() {
        std::vector<std::string> parameters;
        if (!scanner_.take("(") || scanner_.take(")")) return parameters;
        do {
            const SourcePlace place = scanner_.place();
            std::string parameter = scanner_.name("the name of a parameter");
            if (!parameters_.insert(parameter).second) {
                throw InputError(place, "expected different names of parameters, found '" + parameter + "' twice");
            }
            parameters.push_back(std::move(parameter));
        } while (scanner_.take(","));
        scanner_.expect(")");
        return parameters;
    }
};

}  // namespace

std::optional<Production> parse_production(Scanner& scanner) { return ProductionReader(scanner).read(); }

}  // namespace rinceau
