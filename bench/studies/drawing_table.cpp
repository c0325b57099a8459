#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

#include "analyzer/analyze.h"
#include "analyzer/derivation_tree.h"
#include "closed_loop/findings.h"
#include "lsystem/turtle_commands.h"
#include "scene/svg_read.h"
#include "tables.h"

namespace rinceau::test {

namespace {

/// Exceptions by what they say of the place: only in which layer it is painted, where it is instead, that nothing stands
/// there, or something else.
struct ExceptionCounts {
    int layers = 0, residuals = 0, missing = 0, stand_ins = 0;
};

/// The symbol that stands at each address of the derivation, exceptions left out.
std::map<std::vector<int>, std::string> symbols_by_address(Grammar grammar) {
    grammar.exceptions.clear();
    const std::vector<Placement> leaves = interpret(grammar, {.addresses = true});
    const DerivationTree tree = derivation_tree(grammar, leaves);
    std::map<std::vector<int>, std::string> symbols;
    for (const DerivedModule& node : tree.nodes) {
        if (node.site < 0) continue;
        const std::vector<int>& address = leaves[static_cast<std::size_t>(node.leaf)].address;
        const ModuleSite& site = tree.sites[static_cast<std::size_t>(node.site)];
        symbols[{address.begin(), address.begin() + node.address_length}] =
            string_at(grammar, site)[static_cast<std::size_t>(site.position)].symbol;
    }
    return symbols;
}

ExceptionCounts count_exceptions(const Grammar& grammar) {
    ExceptionCounts counts;
    if (grammar.exceptions.empty()) return counts;
    const auto symbols = symbols_by_address(grammar);
    for (const Exception& exception : grammar.exceptions) {
        const auto is_symbol = [](const ModuleTemplate& module) { return find_turtle_command(module.symbol) == nullptr; };
        const auto moves = [&](const ModuleTemplate& module) { return !is_symbol(module) && module.symbol != "z"; };
        const auto symbol = std::ranges::find_if(exception.successor, is_symbol);
        const auto standing = symbols.find(exception.address);
        if (symbol == exception.successor.end()) {
            ++counts.missing;
        } else if (standing != symbols.end() && standing->second != symbol->symbol) {
            ++counts.stand_ins;
        } else if (std::ranges::any_of(exception.successor, moves)) {
            ++counts.residuals;
        } else {
            ++counts.layers;
        }
    }
    return counts;
}

struct DrawingRow {
    std::string name;
    Analysis analysis;
    double seconds = 0;
    double ratio() const { return analysis.report.drawing_bits / std::max(1.0, analysis.report.grammar_bits); }
};

Scene scene_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << stream.rdbuf();
    return read_svg(bytes.str(), {.file_name = file.filename().string()}).scene;
}

DrawingRow row_of(const std::filesystem::path& file, Objective objective) {
    const Scene scene = scene_of(file);
    const auto start = std::chrono::steady_clock::now();
    DrawingRow row{file.filename().string(), analyze(scene, {.objective = objective}), 0};
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return row;
}

void print_row(const DrawingRow& row) {
    const AnalysisReport& report = row.analysis.report;
    const ExceptionCounts counts = count_exceptions(row.analysis.grammar);
    std::printf("%-30s %6d %6zu %6zu %6d %5d %5d %5d %5d %10.0f %9.0f %7.2f  %8.1e %8.2f%s\n", row.name.c_str(), report.elements,
                report.terminals.size(), report.productions.size(), axiom_symbols(row.analysis.grammar), counts.layers,
                counts.residuals, counts.missing, counts.stand_ins, report.drawing_bits, report.grammar_bits, row.ratio(),
                report.check.max_deviation, row.seconds, report.check.passed ? "" : "  does not draw it");
    std::fflush(stdout);
}

std::vector<std::filesystem::path> drawings_in(const std::string& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code unreadable;
    for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
        if (entry.path().extension() == ".svg" || entry.path().extension() == ".svgz") files.push_back(entry.path());
    }
    std::ranges::sort(files);
    return files;
}

void print_head() {
    std::printf("%-30s %6s %6s %6s %6s %5s %5s %5s %5s %10s %9s %7s  %8s %8s\n", "file", "N", "term.", "rules", "axiom", "layer",
                "resid", "miss", "stand", "bits", "as rules", "ratio", "deviat.", "seconds");
}

void print_both_head() {
    std::printf("%-30s %6s %10s  %11s %9s %8s  %11s %9s %8s\n", "file", "N", "bits", "ours", "bits", "seconds", "paper's", "bits",
                "seconds");
}

void print_both(const DrawingRow& ours, const DrawingRow& theirs) {
    const auto counts = [](const DrawingRow& row) {
        return std::to_string(row.analysis.report.productions.size()) + "/" + std::to_string(axiom_symbols(row.analysis.grammar));
    };
    std::printf("%-30s %6d %10.0f  %11s %9.0f %8.2f  %11s %9.0f %8.2f\n", ours.name.c_str(), ours.analysis.report.elements,
                ours.analysis.report.drawing_bits, counts(ours).c_str(), ours.analysis.report.grammar_bits, ours.seconds,
                counts(theirs).c_str(), theirs.analysis.report.grammar_bits, theirs.seconds);
    std::fflush(stdout);
}

void print_summary(std::vector<double> ratios) {
    if (ratios.empty()) return;
    std::ranges::sort(ratios);
    const std::size_t half = ratios.size() / 2;
    const double median = ratios.size() % 2 == 1 ? ratios[half] : (ratios[half - 1] + ratios[half]) / 2;
    std::printf("%zu drawings: median ratio %.2f, least %.2f\n", ratios.size(), median, ratios.front());
}

}  // namespace

bool print_drawing_table(const std::string& folder, Objective objective, bool both) {
    const std::vector<std::filesystem::path> files = drawings_in(folder);
    if (files.empty()) return false;
    both ? print_both_head() : print_head();
    std::vector<double> ratios;
    for (const std::filesystem::path& file : files) {
        try {
            const DrawingRow row = row_of(file, objective);
            both ? print_both(row, row_of(file, Objective::paper)) : print_row(row);
            ratios.push_back(row.ratio());
        } catch (const std::exception& error) {
            std::printf("%-30s %s\n", file.filename().string().c_str(), error.what());
        }
    }
    print_summary(std::move(ratios));
    return true;
}

}  // namespace rinceau::test
