#include "analyzer/analyze.h"

#include <algorithm>
#include <chrono>

#include "analyzer/describe_all.h"
#include "analyzer/paint_order.h"
#include "analyzer/rank_with_layers.h"
#include "analyzer/report.h"
#include "analyzer/same_picture.h"
#include "analyzer/scatter.h"
#include "analyzer/symbol_names.h"
#include "analyzer/verify_layout.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/to_scene.h"

namespace rinceau {

namespace {

class Stopwatch {
  public:
    /// Seconds since the last call.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double seconds = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        return seconds;
    }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

Overlaps with_faint_pairs(Overlaps overlaps) {
    overlaps.pairs.insert(overlaps.pairs.end(), overlaps.faint.begin(), overlaps.faint.end());
    overlaps.faint.clear();
    std::ranges::sort(overlaps.pairs, {}, [](const OverlapPair& pair) { return std::pair{pair.upper, pair.lower}; });
    return overlaps;
}

/// A description as it will be written, and whether it draws the drawing.
struct Proof {
    Grammar layered;
    Grammar grammar;  ///< as read back from its text
    Verification check;
};

Proof proof_of(const Drawing& drawing, const Description& description, const Overlaps& overlaps,
               const AnalyzeOptions& options, const Progress& progress) {
    Proof proof;
    report(progress, "check", 0);
    if (options.symmetrize || options.stochastic) {
        const Instancing& instancing = description.reading->instancing;
        const Grammar layout =
            options.symmetrize
                ? description.written.grammar
                : with_scatter(description.written, instancing, exact_tolerance(*description.reading)).grammar;
        proof.layered = with_paint_order(layout, description.written.element_of_leaf, overlaps);
        proof.grammar = parse_grammar(to_text(proof.layered));
        proof.check = verify_layout(proof.grammar, description.written, instancing, drawing.diagonal);
        return proof;
    }
    proof.layered = with_paint_order(description.exact, description.written.element_of_leaf, overlaps);
    report(progress, "check", 0);
    proof.grammar = parse_grammar(to_text(proof.layered));
    proof.check = verify(proof.grammar, drawing.scene, overlaps, {.threads = options.threads}, progress);
    return proof;
}

/// Does it look the same though pairs are exchanged whose order hardly shows?
bool looks_the_same(const Drawing& drawing, const Proof& proof, int threads, const Progress& progress) {
    const std::vector<OverlapPair>& exchanged = proof.check.exchanged_faint;
    if (exchanged.empty()) return true;
    return same_picture(drawing.scene, to_scene(proof.grammar, interpret(proof.grammar)), exchanged, threads, progress);
}

std::vector<int> united(std::vector<int> numbers, const std::vector<int>& others) {
    numbers.insert(numbers.end(), others.begin(), others.end());
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
}

}  // namespace

Grammar flat_grammar(const Scene& scene, const Instancing& instancing) {
    const Overlaps overlaps;
    const Drawing drawing{scene, instancing, overlaps, drawing_diagonal(scene), 0, 0};
    return flat_description(drawing).exact;
}

Analysis analyze(const Scene& scene, const AnalyzeOptions& options, const Progress& progress) {
    Analysis analysis = analyze(prepare_drawing(scene, options, progress), options, progress);
    if (analysis.report.check.passed || analysis.report.check.faulty.empty()) return analysis;
    // Elements that not even a list of copies draws closely enough are nobody's copies.
    AnalyzeOptions careful = options;
    careful.alone = united(options.alone, analysis.report.check.faulty);
    Analysis again = analyze(prepare_drawing(scene, careful, progress), careful, progress);
    return again.report.check.passed ? again : analysis;
}

Analysis analyze(const PreparedDrawing& prepared, const AnalyzeOptions& options, const Progress& progress) {
    Analysis analysis;
    AnalysisReport& report_out = analysis.report;
    report_out.seconds.similarity = prepared.seconds;
    report_out.symmetrized = options.symmetrize;
    report_out.stochastic = options.stochastic;
    if (prepared.redrawn > 0) {
        report_out.warnings.push_back(std::to_string(prepared.redrawn) +
                                      (prepared.redrawn == 1 ? " element is" : " elements are") +
                                      " drawn as another one, with which it was merged by hand");
    }
    Stopwatch watch;
    const Overlaps& overlaps = prepared.overlaps;
    // Two readings: equal shapes in other styles are other looks, or one look with its colours as arguments.
    const double flat_bits = flat_list_bits(prepared.readings.front().instancing, prepared.diagonal);
    std::vector<Drawing> drawings;
    for (const PreparedReading& reading : prepared.readings) {
        if (drawings.empty() || options.objective == Objective::bits)
            drawings.push_back({*prepared.scene, reading.instancing, overlaps, prepared.diagonal, flat_bits,
                                named_kinds(reading.instancing, *prepared.scene)});
    }

    // Rules, at several tolerances; the shortest description that proves right is kept.
    SearchOptions search;
    search.weights = options.weights;
    search.objective = report_out.objective = options.objective;
    const bool shortest = options.objective == Objective::bits;
    std::vector<std::span<const SearchState>> starts;
    for (std::size_t d = 0; d < drawings.size(); ++d) starts.emplace_back(prepared.readings[d].starts);
    std::vector<Description> descriptions = describe_all(drawings, starts, search, options.threads, progress);
    if (options.tolerance == 0 && shortest) {
        descriptions = describe_irregular(drawings, std::move(descriptions), search, options.threads, progress);
    }
    std::erase_if(descriptions, [&](const Description& d) { return shortest && d.bits.grammar >= d.bits.drawing; });
    if (shortest) descriptions = ranked_with_layers(std::move(descriptions), overlaps, options.threads, progress);
    report_out.seconds.rules = watch.lap();

    // The proof, from the text that will be written. The flat list of all elements is the last resort.
    for (std::size_t tried = 0;; ++tried) {
        report(progress, "check", static_cast<double>(tried) / 4);
        const bool last = tried == descriptions.size();
        if (last) descriptions.push_back(flat_description(drawings.front()));
        const Description& description = descriptions[tried];
        Proof proof = proof_of(drawings.front(), description, overlaps, options, progress);
        report(progress, "check", 1);
        if (proof.check.passed && !looks_the_same(drawings.front(), proof, options.threads, progress)) {
            // What hardly shows once shows when it comes by the hundred: these orders are kept as well.
            proof = proof_of(drawings.front(), description, with_faint_pairs(overlaps), options, progress);
        }
        report(progress, "check", 1);
        const DescriptionBits bits = bits_of(description, proof.layered);
        report_out.check = std::move(proof.check);
        analysis.grammar = std::move(proof.grammar);
        if (!last && (!report_out.check.passed || (shortest && bits.grammar >= bits.drawing))) {
            if (!report_out.check.passed) {
                report_out.warnings.push_back("a shorter grammar was dropped because it did not redraw the picture: " +
                                              report_out.check.summary);
            }
            continue;
        }
        fill_report(report_out, description.ordered, description.written, analysis.grammar, description.reading->instancing);
        report_out.drawing_bits = bits.drawing;
        report_out.grammar_bits = bits.grammar;
        report_out.tolerance = description.tolerance;
        break;
    }
    report_out.seconds.verify = watch.lap();
    return analysis;
}

}  // namespace rinceau
