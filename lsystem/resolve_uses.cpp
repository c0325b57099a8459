#include "lsystem/resolve_uses.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "lsystem/mistakes.h"
#include "lsystem/number_text.h"
#include "lsystem/parse_text.h"
#include "lsystem/prefix_names.h"

namespace rinceau {

namespace {

constexpr std::size_t max_levels = 16;
constexpr std::size_t max_text = std::size_t{16} << 20;
constexpr int max_files = 10'000;         // each as often as it comes along
constexpr int max_style = 1'000'000'000;  // fits an int, and is exact in expressions

/// What a grammar names, as "terminal A", "define n", "production A(1)", with the places of the parts.
class Names {
  public:
    void add(const std::string& name, const SourcePlace& place) {
        first_.try_emplace(name, place);
        parts_.emplace(name, place.file, place.line, place.column);
    }
    bool holds(const std::string& name, const SourcePlace& place) const {
        return place.line > 0 && parts_.contains({name, place.file, place.line, place.column});
    }
    const SourcePlace* find(const std::string& name) const {
        const auto found = first_.find(name);
        return found == first_.end() ? nullptr : &found->second;
    }

  private:
    std::map<std::string, SourcePlace> first_;
    std::set<std::tuple<std::string, std::string, int, int>> parts_;
};

/// A name for a prefix: the file's own, as far as it is one.
std::string prefix_for(const std::string& file) {
    std::string name;
    for (const char c : std::filesystem::path(file).stem().string()) name += continues_name(c) ? c : '_';
    return name.empty() || !starts_name(name.front()) ? "other" : name;
}

class Resolver {
  public:
    explicit Resolver(const GrammarLoader& load) : load_(load) {}

    /// The grammar of a file, which is the last of open_.
    Grammar resolve(Grammar grammar) {
        const std::vector<Use> uses = std::move(grammar.uses);
        grammar.uses.clear();
        if (uses.empty()) return grammar;
        Names names = names_of(grammar);
        std::vector<Constant> constants;  // those of used files come first: the grammar's own may use them
        for (const Use& use : uses) {
            if (std::optional<Grammar> used = read(use)) add(grammar, constants, names, std::move(*used), use);
        }
        constants.insert(constants.end(), std::make_move_iterator(grammar.constants.begin()),
                         std::make_move_iterator(grammar.constants.end()));
        grammar.constants = std::move(constants);
        return grammar;
    }

    std::vector<Warning> mistakes() { return std::move(mistakes_); }

  private:
    const GrammarLoader& load_;
    std::vector<std::string> open_;  // the files from the grammar down to the one that is read
    std::size_t text_ = 0;           // bytes that have come along
    int files_ = 0;
    bool full_ = false;
    std::set<std::string> faulty_;  // files whose mistakes are known
    std::vector<Warning> mistakes_;

    void warn(const SourcePlace& place, const std::string& message) { add_mistake(mistakes_, place, message); }

    static std::string beside(const std::string& user, const std::string& file) {
        return (std::filesystem::path(user).parent_path() / file).lexically_normal().string();
    }

    /// The grammar that is used, resolved, with its prefix.
    std::optional<Grammar> read(const Use& use) {
        const std::string user = std::filesystem::path(use.place.file).lexically_normal().string();
        const std::string file = beside(user, use.file);
        if (full_ || !may_open(use, user, file)) return std::nullopt;
        std::string text;
        try {
            text = load_(file);
        } catch (const InputError& error) {
            warn(use.place, "expected the grammar " + file + ", found that it " + cause(error.what(), file));
            return std::nullopt;
        } catch (const LimitError& error) {
            warn(use.place, "expected the grammar " + file + ", found that it is " + cause(error.what(), file));
            return std::nullopt;
        }
        text_ += text.size();
        full_ = text_ > max_text || ++files_ > max_files;
        if (full_) {
            warn(use.place, "expected at most " + std::to_string(max_files) + " files and " +
                                std::to_string(max_text >> 20) +
                                " MiB of text, each file counted as often as it is used, found more with this one: "
                                "use fewer or smaller ones");
            return std::nullopt;
        }
        return read_text(use, user, file, text);
    }

    bool may_open(const Use& use, const std::string& user, const std::string& file) {
        const std::vector<std::string> files = opened_from(user);
        const auto circle = std::ranges::find(files, file);
        if (circle != files.end()) {
            std::string way;
            for (auto step = circle; step != files.end(); ++step) way += *step + " uses ";
            warn(use.place, "expected files that do not use themselves, found that " + way + file + ": take one 'use' away");
            return false;
        }
        if (files.size() <= max_levels) return true;
        warn(use.place, "expected at most " + std::to_string(max_levels) +
                            " files that use one another, found one more: use it from a file nearer to the first");
        return false;
    }
    std::vector<std::string> opened_from(const std::string& user) const {
        return open_.empty() ? std::vector<std::string>{user} : open_;
    }

    /// "x.lsys: cannot be read: .." -> "cannot be read: .."
    static std::string cause(const std::string& message, const std::string& file) {
        const std::string front = file + ": ";
        return message.starts_with(front) ? message.substr(front.size()) : message;
    }

    Grammar read_text(const Use& use, const std::string& user, const std::string& file, const std::string& text) {
        ParseState parsed = parse_text(text, file);
        if (faulty_.insert(file).second) {
            for (const Warning& mistake : parsed.mistakes) warn(mistake.place, mistake.message);
        }
        const std::vector<std::string> before = open_;
        open_ = opened_from(user);
        open_.push_back(file);
        Grammar grammar = with_prefix(resolve(std::move(parsed.grammar)), use.prefix);
        open_ = before;
        return grammar;
    }

    static std::string production_name(const Production& production) {
        constexpr std::array kinds{"", "decomposition ", "homomorphism "};
        return kinds[static_cast<std::size_t>(production.kind)] + ("production " + production.symbol) + '(' +
               std::to_string(production.parameters.size()) + ')';
    }

    static std::string constant_name(const Constant& constant) { return "define " + constant.name; }
    static std::string terminal_name(const Terminal& terminal) { return "terminal " + terminal.symbol; }

    static Names names_of(const Grammar& grammar) {
        Names names;
        for (const Constant& constant : grammar.constants) names.add(constant_name(constant), constant.place);
        for (const Terminal& terminal : grammar.terminals) names.add(terminal_name(terminal), terminal.place);
        for (const Production& production : grammar.productions) names.add(production_name(production), production.place);
        return names;
    }

    /// True if it is new. A clash of names is a mistake.
    bool is_new(const Names& names, const std::string& name, const SourcePlace& place, const Use& use) {
        const SourcePlace* known = names.find(name);
        if (known == nullptr) return true;
        if (names.holds(name, place)) return false;
        const std::string prefix = prefix_for(use.file);
        const std::string cure =
            use.prefix.empty() ? "use it as 'use \"" + use.file + "\" as " + prefix + "'" : "put another name behind 'as'";
        warn(use.place, "expected new names in " + place.file + ", found '" + name + "' of line " +
                            std::to_string(place.line) + ", which is in " + known->file + ", line " +
                            std::to_string(known->line) + ", too: " + cure);
        return false;
    }

    void add(Grammar& grammar, std::vector<Constant>& constants, Names& names, Grammar used, const Use& use) {
        const int raise = highest_style(grammar);
        if (highest_style(used) > max_style - raise) {
            warn(use.place, "expected numbers of styles that add up to at most " + std::to_string(max_style) +
                                ", found larger ones: number them from 1");
            return;
        }
        used = with_styles_raised(std::move(used), raise);
        std::vector<std::pair<std::string, SourcePlace>> added;  // not clashing with one another: they are of one file
        const auto take = [&](auto& from, auto& to, const auto& name_of) {
            for (auto& part : from) {
                const std::string name = name_of(part);
                if (!is_new(names, name, part.place, use)) continue;
                added.emplace_back(name, part.place);
                to.push_back(std::move(part));
            }
        };
        take(used.constants, constants, constant_name);
        take(used.productions, grammar.productions, production_name);
        take(used.terminals, grammar.terminals, terminal_name);
        for (const auto& [name, place] : added) names.add(name, place);
        grammar.styles.insert(grammar.styles.end(), used.styles.begin(), used.styles.end());
        for (const std::string& symbol : used.ignored) {
            if (std::ranges::find(grammar.ignored, symbol) == grammar.ignored.end()) grammar.ignored.push_back(symbol);
        }
    }

    static int highest_style(const Grammar& grammar) {
        int highest = 0;
        for (const NumberedStyle& style : grammar.styles) highest = std::max(highest, style.number);
        return highest;
    }
};

}  // namespace

ResolvedGrammar resolve_uses_with_mistakes(const Grammar& grammar, const GrammarLoader& load) {
    Resolver resolver(load);
    Grammar whole = resolver.resolve(grammar);
    return {std::move(whole), resolver.mistakes()};
}

Grammar resolve_uses(const Grammar& grammar, const GrammarLoader& load) {
    if (grammar.uses.empty()) return grammar;
    ResolvedGrammar resolved = resolve_uses_with_mistakes(grammar, load);
    if (resolved.mistakes.empty()) return std::move(resolved.grammar);
    throw InputError(resolved.mistakes.front().place, resolved.mistakes.front().message);
}

}  // namespace rinceau
