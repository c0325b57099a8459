#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "analyzer/analyze.h"
#include "closed_loop/findings.h"
#include "closed_loop/listed_scenes.h"
#include "tables.h"

namespace rinceau::test {

namespace {

enum class Verdict { missed, partly, found };

/// What was found in one drawing of a scene.
struct Finding {
    int elements = 0, rules = 0, axiom = 0, exceptions = 0;
    double drawing_bits = 0, grammar_bits = 0, deviation = 0, seconds = 0;
    bool passed = false;
    Verdict verdict = Verdict::missed;
};

/// Partly: not what a person would write, but half as long as the drawing.
Verdict verdict_of(const ListedScene& scene, const Analysis& analysis) {
    if (is_found(scene, analysis)) return Verdict::found;
    const AnalysisReport& report = analysis.report;
    const bool half = scene.most_rules > 0 && 2 * report.grammar_bits <= report.drawing_bits;
    return half && report.check.passed ? Verdict::partly : Verdict::missed;
}

Finding finding_in(const ListedScene& listed, const Scene& scene, const AnalyzeOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    const Analysis analysis = analyze(scene, options);
    Finding finding;
    finding.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    finding.elements = analysis.report.elements;
    finding.rules = static_cast<int>(analysis.report.productions.size());
    finding.axiom = axiom_symbols(analysis.grammar);
    finding.exceptions = static_cast<int>(analysis.grammar.exceptions.size());
    finding.drawing_bits = analysis.report.drawing_bits;
    finding.grammar_bits = analysis.report.grammar_bits;
    finding.deviation = analysis.report.check.max_deviation;
    finding.passed = analysis.report.check.passed;
    finding.verdict = verdict_of(listed, analysis);
    return finding;
}

const char* word_of(Verdict verdict) {
    return verdict == Verdict::found ? "found" : verdict == Verdict::partly ? "partly" : "missed";
}

std::string range_text(int low, int high) {
    return low == high ? std::to_string(low) : std::to_string(low) + "-" + std::to_string(high);
}

/// All drawings of a scene; the line shows the median by bits, the verdict counts them all.
struct SceneRow {
    Finding middle;
    Verdict verdict = Verdict::missed;
    int found = 0, drawings = 0;
};

SceneRow row_of(const ListedScene& scene, int seeds, const AnalyzeOptions& options) {
    constexpr double most = 0.9;  // of the drawings of a scene must be found
    SceneRow row;
    std::vector<Finding> findings;
    int partly = 0;
    for (int seed = 1; seed <= std::min(seeds, scene.seeds); ++seed) {
        findings.push_back(finding_in(scene, scene.make(static_cast<std::uint64_t>(seed)), options));
        row.found += findings.back().verdict == Verdict::found ? 1 : 0;
        partly += findings.back().verdict != Verdict::missed ? 1 : 0;
    }
    row.drawings = static_cast<int>(findings.size());
    std::ranges::sort(findings, {}, &Finding::grammar_bits);
    row.middle = findings[findings.size() / 2];
    row.verdict = row.found >= most * row.drawings ? Verdict::found : 2 * partly >= row.drawings ? Verdict::partly : Verdict::missed;
    return row;
}

void print_row(const ListedScene& scene, const SceneRow& row) {
    const Finding& at = row.middle;
    const std::string expected = range_text(scene.rules, scene.most_rules) + "/" + std::to_string(scene.axiom_symbols);
    const std::string counts = std::to_string(at.rules) + "/" + std::to_string(at.axiom);
    const std::string share = row.drawings > 1 ? " " + std::to_string(row.found) + "/" + std::to_string(row.drawings) : "";
    std::printf("%-13s %-28s %6d  %9s %9s %6d  %9.0f %8.0f %7.1f  %8.1e %8.3f  %s%s%s\n", scene.family.c_str(), scene.name.c_str(),
                at.elements, expected.c_str(), counts.c_str(), at.exceptions, at.drawing_bits, at.grammar_bits,
                at.grammar_bits > 0 ? at.drawing_bits / at.grammar_bits : 0, at.deviation, at.seconds, word_of(row.verdict),
                share.c_str(), at.passed ? "" : " (does not draw it)");
    std::fflush(stdout);
}

void print_both(const std::vector<ListedScene>& scenes) {
    std::printf("%-13s %-28s %6s  %9s  %9s %8s %8s  %9s %8s %8s\n", "family", "scene", "N", "expected", "ours", "bits", "seconds",
                "paper's", "bits", "seconds");
    for (const ListedScene& scene : scenes) {
        const Scene drawing = scene.make(1);
        const Finding ours = finding_in(scene, drawing, {}), theirs = finding_in(scene, drawing, {.objective = Objective::paper});
        const auto counts = [](const Finding& finding) { return std::to_string(finding.rules) + "/" + std::to_string(finding.axiom); };
        const std::string expected = range_text(scene.rules, scene.most_rules) + "/" + std::to_string(scene.axiom_symbols);
        std::printf("%-13s %-28s %6d  %9s  %9s %8.0f %8.3f  %9s %8.0f %8.3f\n", scene.family.c_str(), scene.name.c_str(), ours.elements,
                    expected.c_str(), counts(ours).c_str(), ours.grammar_bits, ours.seconds, counts(theirs).c_str(), theirs.grammar_bits,
                    theirs.seconds);
        std::fflush(stdout);
    }
}

std::vector<ListedScene> chosen_scenes(const SceneTableOptions& options) {
    std::vector<ListedScene> scenes = listed_scenes(options.largest);
    std::erase_if(scenes, [&](const ListedScene& scene) {
        return (scene.family + " " + scene.name).find(options.only) == std::string::npos;
    });
    return scenes;
}

void print_findings(const SceneTableOptions& options, const std::vector<ListedScene>& scenes) {
    std::printf("%-13s %-28s %6s  %9s %9s %6s  %9s %8s %7s  %8s %8s  %s\n", "family", "scene", "N", "expected", "found", "except",
                "bits", "as rules", "ratio", "deviat.", "seconds", "verdict");
    int counts[3] = {0, 0, 0};
    for (const ListedScene& scene : scenes) {
        const SceneRow row = row_of(scene, options.seeds, {.objective = options.objective});
        print_row(scene, row);
        ++counts[static_cast<int>(row.verdict)];
    }
    std::printf("%d found, %d partly, %d missed\n", counts[2], counts[1], counts[0]);
}

}  // namespace

void print_scene_table(const SceneTableOptions& options) {
    options.both ? print_both(chosen_scenes(options)) : print_findings(options, chosen_scenes(options));
}

}  // namespace rinceau::test
