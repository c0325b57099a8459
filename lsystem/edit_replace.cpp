// Replacement of symbols (Stava et al. 2010, section 6, Figure 11). The old symbol is measured with each set of numbers with
// which it stands, the new thing is laid into that box, and every module of the old symbol becomes the new one in its seat.

#include "lsystem/edit_replace.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "lsystem/measure_symbol.h"
#include "lsystem/number_text.h"
#include "lsystem/replacement_content.h"
#include "lsystem/replacement_seats.h"
#include "lsystem/similar_name.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

std::string address_text(const std::vector<int>& address) {
    std::string text;
    for (const int number : address) text += (text.empty() ? "" : ".") + std::to_string(number);
    return text;
}

std::string counted(std::size_t count, const std::string& thing) {
    return std::to_string(count) + ' ' + thing + (count == 1 ? "" : "s");
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

bool is_context(const Production& production, const std::string& symbol) {
    return std::ranges::count(production.left_context, symbol, &ContextModule::symbol) > 0 ||
           std::ranges::count(production.right_context, symbol, &ContextModule::symbol) > 0;
}

/// Brackets around nothing but commands draw nothing.
ModuleTemplates without_idle_brackets(const ModuleTemplates& string) {
    ModuleTemplates result;
    std::vector<std::size_t> open;
    for (const ModuleTemplate& module : string) {
        if (module.symbol == "]" && !open.empty()) {
            const auto group = result.begin() + static_cast<std::ptrdiff_t>(open.back());
            open.pop_back();
            const bool idle = std::all_of(
                group, result.end(), [](const ModuleTemplate& part) { return find_turtle_command(part.symbol) != nullptr; });
            if (idle) {
                result.erase(group, result.end());
                continue;
            }
        }
        if (module.symbol == "[") open.push_back(result.size());
        result.push_back(module);
    }
    return result;
}

/// What is known of all instances of one written module.
struct WrittenModule {
    std::set<std::vector<double>> numbers;  ///< with which it stands
    std::vector<Colouring> colourings;      ///< in force there
};

/// One replacement while it is made.
struct Task {
    const Replacement* replacement = nullptr;
    std::vector<SymbolInstance> measured;                            ///< where the symbol stands if no other one is replaced
    std::vector<SymbolInstance> replaced;                            ///< where it stands beside the others
    std::map<std::pair<WrittenString, int>, WrittenModule> modules;  ///< by string and position, from `measured`
    std::unique_ptr<OldMeasures> sizes;
    std::map<std::vector<double>, Seat> seats;
    Content content;
    std::map<std::size_t, std::string> by_size;  ///< number of arguments -> the production that chooses a seat by them
    std::size_t places = 0;
    double least_scale = 0;
    double most_scale = 0;
};

class Replacer {
  public:
    Replacer(const Grammar& grammar, const std::vector<Replacement>& replacements, const ReplaceOptions& options)
        : written_(grammar), before_(options.resolve ? options.resolve(grammar) : grammar), options_(options) {
        for (const Replacement& replacement : replacements) {
            expect_symbol(replacement.symbol);
            if (!symbols_.insert(replacement.symbol).second)
                throw InputError({}, "expected one replacement of " + replacement.symbol + ", found two");
            tasks_.push_back({.replacement = &replacement});
        }
        for (Task& task : tasks_) find_places(task);
        add_contents(replacements);
    }

    EditResult replace() {
        result_ = with_;  // old and new things; `with_` stays to be measured
        if (options_.at.empty()) {
            replace_everywhere();
        } else {
            for (const std::vector<int>& address : options_.at) replace_at(address);
        }
        drop_exceptions();
        for (const Task& task : tasks_) changes_.push_back(description(task));
        if (dropped_ > 0) changes_.push_back(counted(dropped_, "exception") + " below what was replaced removed");
        if (!options_.keep) remove_leftovers();
        return {std::move(result_), std::move(changes_)};
    }

  private:
    const Grammar& written_;
    Grammar before_;  // without `use`
    const ReplaceOptions& options_;
    std::set<std::string> symbols_;
    std::vector<Task> tasks_;
    Grammar with_;
    Grammar resolved_with_;
    Grammar result_;
    std::size_t dropped_ = 0;
    std::vector<std::string> changes_;
    std::map<std::size_t, std::vector<std::pair<int, int>>> grown_;  // exception -> where it was by how much, with --at

    void expect_symbol(const std::string& symbol) const {
        if (find_turtle_command(symbol) != nullptr)
            throw InputError({}, "expected a symbol to replace, found '" + symbol + "', a command of the turtle");
        const std::vector<std::string> known = symbols_of(before_);
        if (std::ranges::count(known, symbol) == 0)
            throw InputError({}, "expected a symbol of the grammar, found '" + symbol + "'" + instead_of(symbol, known));
        for (const Production& production : before_.productions) {
            if (!is_context(production, symbol)) continue;
            throw InputError(production.place, "expected a symbol that is no context, found " + symbol +
                                                   ", which this production of " + production.symbol +
                                                   " looks for: change or take away that context first");
        }
    }

    void find_places(Task& task) {
        const std::string& symbol = task.replacement->symbol;
        task.measured = find_instances(before_, symbol, {symbol}, options_.derive);
        task.replaced = symbols_.size() == 1 ? task.measured : find_instances(before_, symbol, symbols_, options_.derive);
        task.sizes = std::make_unique<OldMeasures>(before_, symbol, options_.derive);
        for (const SymbolInstance& instance : task.measured) {
            WrittenModule& module = task.modules[{instance.string, instance.position}];
            if (instance.measured) module.numbers.insert(instance.arguments);
            if (std::ranges::count(module.colourings, instance.colouring) == 0)
                module.colourings.push_back(instance.colouring);
        }
    }

    /// A drawing is laid into the largest place; where the place is another one it is scaled by the turtle.
    void add_contents(const std::vector<Replacement>& replacements) {
        std::vector<Box> places;
        for (Task& task : tasks_) {
            Box largest;
            for (const SymbolInstance& instance : task.measured) {
                if (!instance.measured) continue;
                const Box& box = task.sizes->of(instance.arguments).box;
                if (is_empty(largest) || diagonal(box) > diagonal(largest)) largest = box;
            }
            places.push_back(largest);
        }
        WithContents made = with_contents(written_, replacements, places, options_);
        with_ = std::move(made.grammar);
        resolved_with_ = options_.resolve ? options_.resolve(with_) : with_;
        for (std::size_t i = 0; i < tasks_.size(); ++i) tasks_[i].content = std::move(made.contents[i]);
    }

    Task* task_of(const std::string& symbol) {
        const auto found =
            std::ranges::find_if(tasks_, [&](const Task& task) { return task.replacement->symbol == symbol; });
        return found == tasks_.end() ? nullptr : &*found;
    }

    // Everywhere

    void replace_everywhere() {
        result_.axiom = replaced(with_.axiom, {WrittenString::Kind::axiom, 0}, "");
        // a symbol's own productions, and those that came with the new things, stay as they are
        for (std::size_t i = 0; i < written_.productions.size(); ++i) {
            const Production& production = written_.productions[i];
            result_.productions[i].successor =
                replaced(production.successor, {WrittenString::Kind::production, static_cast<int>(i)}, production.symbol);
        }
        for (std::size_t i = 0; i < written_.exceptions.size(); ++i) {
            result_.exceptions[i].successor =
                replaced(written_.exceptions[i].successor, {WrittenString::Kind::exception, static_cast<int>(i)}, "");
        }
        for (Task& task : tasks_) task.places = task.replaced.size();
        expect_no_endless_recursion();
    }

    ModuleTemplates replaced(const ModuleTemplates& string, const WrittenString& place, const std::string& owner) {
        ModuleTemplates result;
        bool erased = false;
        for (std::size_t i = 0; i < string.size(); ++i) {
            Task* task = string[i].symbol == owner ? nullptr : task_of(string[i].symbol);
            if (task == nullptr) {
                result.push_back(string[i]);
                continue;
            }
            const ModuleTemplates part = replaced_module(*task, string[i], place, static_cast<int>(i),
                                                         is_last(string, i, place.kind == WrittenString::Kind::axiom));
            result.insert(result.end(), part.begin(), part.end());
            erased = erased || task->content.string.empty();
        }
        return erased ? without_idle_brackets(result) : result;
    }

    static bool is_last(const ModuleTemplates& string, std::size_t i, bool ends_the_picture) {
        return i + 1 < string.size() ? string[i + 1].symbol == "]" : ends_the_picture;
    }

    ModuleTemplates replaced_module(Task& task, const ModuleTemplate& module, const WrittenString& place, int position,
                                    bool last) {
        const WrittenModule& written = task.modules[{place, position}];
        std::optional<Seat> seat;
        for (const std::vector<double>& numbers : written.numbers) {
            const Seat& here = seat_for(task, numbers);
            if (seat && !same_seat(*seat, here)) return chosen_by_size(task, module);
            if (!seat) seat = here;
        }
        if (!seat) seat = seat_of_unmeasured(task, module);
        note_scale(task, *seat);
        return seated(content_string(task.content, module), *seat, taken_back(task, written.colourings), last);
    }

    /// What comes from elsewhere keeps its own colours.
    ModuleTemplates taken_back(const Task& task, const std::vector<Colouring>& colourings) const {
        return task.content.foreign && !options_.restyle ? without_colouring(colourings) : ModuleTemplates{};
    }

    const Seat& seat_for(Task& task, const std::vector<double>& arguments) {
        const auto found = task.seats.find(arguments);
        if (found != task.seats.end()) return found->second;
        const ModuleTemplate module = with_arguments(task.replacement->symbol, arguments);
        const Seat seat = seat_of(resolved_with_, task.content, module, task.sizes->of(arguments), options_);
        return task.seats.emplace(arguments, seat).first->second;
    }

    /// A module that stands nowhere in the drawing, or only for the drawing.
    Seat seat_of_unmeasured(Task& task, const ModuleTemplate& module) {
        if (const std::optional<Measure> old = task.sizes->of(module))
            return seat_of(resolved_with_, task.content, module, *old, options_);
        for (const SymbolInstance& instance : task.measured) {
            if (instance.measured) return seat_for(task, instance.arguments);
        }
        throw InputError(module.place, "expected to find " + module.symbol +
                                           " in what is derived, found it with numbers that are known in the drawing only");
    }

    /// RowAsLeaf(m) : m == 3 -> [f(2) *(0.5) Leaf]: a production for each set of numbers, the last one for all others.
    ModuleTemplates chosen_by_size(Task& task, const ModuleTemplate& module) {
        const std::size_t count = module.arguments.size();
        std::string& name = task.by_size[count];
        if (name.empty()) name = add_seats(task, count);
        return {{name, module.arguments, {}}};
    }

    std::string add_seats(Task& task, std::size_t count) {
        const std::string& old = task.replacement->symbol;
        const std::string made_of = task.content.string.empty() ? "Nothing" : task.content.string.front().symbol;
        const std::vector<std::string> known = symbols_of(result_);
        std::string name = free_name(old + "As" + made_of,
                                     [&](const std::string& wanted) { return std::ranges::count(known, wanted) > 0; });
        const std::vector<std::string> parameters = parameter_names(old, count);
        std::set<std::vector<double>> sets;
        std::vector<Colouring> colourings;
        for (const auto& [place, module] : task.modules) {
            colourings.insert(colourings.end(), module.colourings.begin(), module.colourings.end());
            for (const std::vector<double>& numbers : module.numbers) {
                if (numbers.size() == count) sets.insert(numbers);
            }
        }
        for (const std::vector<double>& numbers : sets) {
            const Seat& seat = seat_for(task, numbers);
            note_scale(task, seat);
            Production production{.symbol = name, .parameters = parameters};
            if (numbers != *sets.rbegin()) production.condition = equals(parameters, numbers);
            const ModuleTemplates content = content_string(task.content, with_arguments(old, numbers));
            production.successor = seated(content, seat, taken_back(task, colourings), false);
            result_.productions.push_back(std::move(production));
        }
        return name;
    }

    std::vector<std::string> parameter_names(const std::string& symbol, std::size_t count) const {
        for (const Production& production : before_.productions) {
            if (production.symbol == symbol && production.parameters.size() == count) return production.parameters;
        }
        std::vector<std::string> names;
        for (std::size_t i = 0; i < count; ++i) names.push_back("a" + std::to_string(i + 1));
        return names;
    }

    static Expression equals(const std::vector<std::string>& names, const std::vector<double>& numbers) {
        std::string text;
        for (std::size_t i = 0; i < names.size(); ++i)
            text += (i == 0 ? "" : " && ") + names[i] + " == " + number_text(numbers[i]);
        return parse_expression(text);
    }

    static void note_scale(Task& task, const Seat& seat) {
        const double scale = task.content.scale * scale_of(seat.map);
        task.least_scale = task.most_scale == 0 ? scale : std::min(task.least_scale, scale);
        task.most_scale = std::max(task.most_scale, scale);
    }

    // At one address

    void replace_at(const std::vector<int>& address) {
        for (Task& task : tasks_) {
            const auto found = std::ranges::find(task.replaced, address, &SymbolInstance::address);
            if (found == task.replaced.end()) continue;
            except(task, *found);
            ++task.places;
            return;
        }
        throw InputError({}, "expected " + listed({symbols_.begin(), symbols_.end()}) + " at " + address_text(address) +
                                 ", found none there" + where_it_stands());
    }

    std::string where_it_stands() const {
        constexpr std::size_t most_listed = 6;
        const std::vector<SymbolInstance>& instances = tasks_.front().replaced;
        if (instances.empty()) return "";
        std::string text;
        for (std::size_t i = 0; i < std::min(instances.size(), most_listed); ++i)
            text += (i == 0 ? ": it stands at " : ", ") + address_text(instances[i].address);
        return instances.size() > most_listed ? text + ", .." : text;
    }

    void except(Task& task, const SymbolInstance& instance) {
        if (!instance.measured)
            throw InputError({}, "expected a module of what is derived, found " + task.replacement->symbol +
                                     " in the drawing only: replace it everywhere");
        const Seat& seat = seat_for(task, instance.arguments);
        note_scale(task, seat);
        const ModuleTemplate module = with_arguments(task.replacement->symbol, instance.arguments);
        const ModuleTemplates part =
            seated(content_string(task.content, module), seat, taken_back(task, {instance.colouring}), false);
        if (instance.string.kind != WrittenString::Kind::exception) {
            result_.exceptions.push_back({.address = instance.address, .successor = part});
            return;
        }
        const auto index = static_cast<std::size_t>(instance.string.index);
        std::vector<std::pair<int, int>>& longer = grown_[index];
        int position = instance.position;
        for (const auto& [before, by] : longer) position += before < instance.position ? by : 0;
        ModuleTemplates& string = result_.exceptions[index].successor;
        const auto at = string.erase(string.begin() + position);
        string.insert(at, part.begin(), part.end());
        longer.emplace_back(instance.position, static_cast<int>(part.size()) - 1);
    }

    // Afterwards

    void drop_exceptions() {
        std::vector<std::vector<int>> replaced_addresses;
        for (const Task& task : tasks_) {
            for (const SymbolInstance& instance : task.replaced) {
                if (options_.at.empty() || std::ranges::count(options_.at, instance.address) > 0)
                    replaced_addresses.push_back(instance.address);
            }
        }
        std::ranges::sort(replaced_addresses);
        dropped_ = std::erase_if(result_.exceptions, [&](const Exception& exception) {
            std::vector<int> above = exception.address;
            for (above.pop_back(); !above.empty(); above.pop_back()) {
                if (std::ranges::binary_search(replaced_addresses, above)) return true;
            }
            return false;
        });
    }

    void remove_leftovers() {
        WithoutLeftovers rest = without_leftovers(std::move(result_), used_names(before_));
        result_ = std::move(rest.grammar);
        if (!rest.removed.empty()) changes_.push_back("no longer used and removed: " + listed(rest.removed));
    }

    /// A symbol of the grammar that draws the production in which it is put now would hold itself.
    void expect_no_endless_recursion() const {
        for (std::size_t i = 0; i < written_.productions.size(); ++i) {
            const Production& production = written_.productions[i];
            for (const ModuleTemplate& module : production.successor) {
                const auto task = std::ranges::find_if(tasks_, [&](const Task& one) {
                    return one.replacement->symbol == module.symbol && module.symbol != production.symbol;
                });
                if (task == tasks_.end() || task->content.foreign || task->content.string.empty()) continue;
                const bool now = used_names(result_, task->content.string).symbols.contains(production.symbol);
                const bool always = used_names(written_, {{module.symbol, {}, {}}}).symbols.contains(production.symbol);
                if (now && !always) throw_endless(task->replacement->symbol, task->replacement->label, production);
            }
        }
    }
    [[noreturn]] static void throw_endless(const std::string& symbol, const std::string& label,
                                           const Production& production) {
        throw InputError(production.place, "expected something that does not draw " + symbol + " itself in the place of " +
                                               symbol + ", found " + label + ": its " + production.symbol +
                                               " would hold itself without end; take a copy, FILE.lsys#" + label);
    }

    std::string description(const Task& task) const {
        std::string text = task.replacement->symbol;
        const bool erased = task.replacement->label.empty();
        text += erased ? " erased" : " -> " + task.replacement->label;
        std::string how;
        if (task.content.outlines > 0) how = counted(static_cast<std::size_t>(task.content.outlines), "outline");
        if (!erased && task.most_scale > 0) {
            const std::string least = number_text(rounded_in(task.least_scale, task.least_scale, shown_digits));
            const std::string most = number_text(rounded_in(task.most_scale, task.most_scale, shown_digits));
            if (most != "1" || least != "1")
                how += (how.empty() ? "scaled by " : ", scaled by ") + least + (least == most ? "" : " to " + most);
        }
        if (!how.empty()) text += " (" + how + ")";
        return text + " in " + counted(task.places, "place");
    }
    static constexpr int shown_digits = 3;
};

}  // namespace

EditResult replace_symbols(const Grammar& grammar, const std::vector<Replacement>& replacements,
                           const ReplaceOptions& options) {
    return Replacer(grammar, replacements, options).replace();
}

}  // namespace rinceau
