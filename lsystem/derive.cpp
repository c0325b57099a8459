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

void append_module(std::string& text, const std::string& symbol, std::span<const double> arguments) {
    text += symbol;
    if (arguments.empty()) return;
    char before = '(';
    for (const double argument : arguments) {
        text += before;
        if (before == ',') text += ' ';
        append_number(text, argument);
        before = ',';
    }
    text += ')';
}

/// Writes the modules that Collector would collect.
class TextWriter {
  public:
    static constexpr bool draws_nothing = true;
    TextWriter(const std::vector<std::string>& symbols, const TextSink& sink) : symbols_(symbols), pieces_(sink) {}

    void command(const CompiledModule& module, std::span<const double> arguments) { append(module, arguments); }
    void leaf(const CompiledModule& module, std::span<const double> arguments, const StreamPlace&) {
        append(module, arguments);
    }
    void exception(int) {}
    void end() { pieces_.pass_on(); }

  private:
    const std::vector<std::string>& symbols_;
    TextPieces pieces_;
    bool first_ = true;

    void append(const CompiledModule& module, std::span<const double> arguments) {
        if (!first_) pieces_.text() += ' ';
        first_ = false;
        append_module(pieces_.text(), symbols_[static_cast<std::size_t>(module.symbol)], arguments);
        pieces_.pass_on_if_large();
    }
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
        append_module(text, string.symbols[static_cast<std::size_t>(module.symbol)], module.arguments);
    }
    return text;
}

void derive_text(const Grammar& grammar, const DeriveOptions& options, const TextSink& sink, const Progress& progress) {
    const CompiledGrammar compiled = compile(grammar);
    TextWriter writer(compiled.symbols, sink);
    stream_modules(compiled, options, progress, false, writer);
    writer.end();
}

}  // namespace rinceau
