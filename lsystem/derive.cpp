#include "lsystem/derive.h"

#include "lsystem/number_text.h"
#include "lsystem/stream.h"

namespace rinceau {

namespace {

struct Collector {
    static constexpr bool draws_nothing = true;
    std::vector<Module> modules;

    void command(const CompiledModule& module, std::span<const double> arguments) {
        modules.push_back({module.symbol, {arguments.begin(), arguments.end()}});
    }
    void leaf(const CompiledModule& module, std::span<const double> arguments, const StreamPlace&) {
        modules.push_back({module.symbol, {arguments.begin(), arguments.end()}});
    }
    void exception(int) {}
};

}  // namespace

ModuleString derive(const Grammar& grammar, const DeriveOptions& options, const Progress& progress) {
    CompiledGrammar compiled = compile(grammar, options.seed);
    Collector collector;
    stream_modules(compiled, options, progress, false, collector);
    return {std::move(compiled.symbols), std::move(collector.modules)};
}

std::string to_text(const ModuleString& string) {
    std::string text;
    for (const Module& module : string.modules) {
        if (!text.empty()) text += ' ';
        text += string.symbols[static_cast<std::size_t>(module.symbol)];
        for (std::size_t i = 0; i < module.arguments.size(); ++i) {
            text += i == 0 ? "(" : ", ";
            text += number_text(module.arguments[i]);
        }
        if (!module.arguments.empty()) text += ')';
    }
    return text;
}

}  // namespace rinceau
