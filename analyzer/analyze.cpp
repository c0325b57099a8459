#include "analyzer/analyze.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <iterator>
#include <mutex>
#include <optional>
#include <span>
#include <thread>

#include "analyzer/colouring.h"
#include "analyzer/fill_gaps.h"
#include "analyzer/generate_rules.h"
#include "analyzer/grammar_bits.h"
#include "analyzer/inline_groups.h"
#include "analyzer/openings.h"
#include "analyzer/order_rules.h"
#include "analyzer/paint_order.h"
#include "analyzer/regular_drawing.h"
#include "analyzer/report.h"
#include "analyzer/residuals.h"
#include "analyzer/same_picture.h"
#include "analyzer/to_grammar.h"
#include "analyzer/verify_layout.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/to_scene.h"

namespace rinceau {

namespace {

// Shares of the diagonal. A picture 900 pixels wide has a diagonal of some 1100 pixels: the first is a tenth of a pixel.
constexpr double exact_share = 8e-5;     // an element may miss its place by this before it gets an exception
constexpr double digits_share = 1.5e-5;  // one number of the grammar may move what follows it by this

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

/// The drawing in one reading: with these looks.
struct Drawing {
    const Scene& scene;
    const Instancing& instancing;
    const Overlaps& overlaps;
    double diagonal;
    double flat_bits;  ///< of the flat list, the same for all readings
};

/// One finished description of the drawing.
struct Description {
    const Drawing* reading = nullptr;
    OrderedRules ordered;
    WrittenGrammar written;
    Grammar exact;  ///< with residuals, before layers
    std::vector<double> deviation;
    DescriptionBits bits;  ///< of `exact`
    double tolerance = 0;
};

DescriptionBits bits_of(const Description& description, const Grammar& grammar) {
    DescriptionBits bits = description_bits(description.ordered, description.written, grammar,
                                            description.reading->instancing, description.deviation,
                                            description.reading->diagonal);
    bits.drawing = description.reading->flat_bits;
    return bits;
}

/// Nothing if the reading's colours cannot be brought into the rules.
std::optional<Description> describe(const Drawing& drawing, RuleSet rules, double tolerance) {
    Description description;
    description.reading = &drawing;
    description.tolerance = tolerance;
    description.ordered = ordered_for_painting(with_inlined_groups(with_filled_gaps(std::move(rules))), drawing.overlaps);
    std::optional<WrittenGrammar> written = with_colours(
        to_grammar(description.ordered, drawing.instancing, drawing.scene, digits_share * drawing.diagonal), drawing.instancing);
    if (!written) return std::nullopt;
    description.written = std::move(*written);
    Residuals exact = with_residuals(description.written, drawing.instancing, exact_share * drawing.diagonal);
    description.exact = std::move(exact.grammar);
    description.deviation = std::move(exact.deviation);
    description.bits = bits_of(description, description.exact);
    return description;
}

/// No rules: every element stands in the axiom.
RuleSet no_rules(const Drawing& drawing) {
    RuleSet rules = starting_state(drawing.instancing, {}, drawing.diagonal).rules;
    RuleSet flat;
    for (const Part& part : rules.parts) {
        if (part.look >= 0) flat.parts.push_back(part);
    }
    for (Item& item : rules.items) {
        if (item.element < 0) continue;
        item.alive = true;
        flat.items.push_back(std::move(item));
    }
    return flat;
}

/// What decides between descriptions of one drawing: their bits, and for each production what it costs a reader to take in
/// one more thing. (Two rules that fit loosely read better than four that fit to the last bit.)
double reading_cost(const Description& description) {
    constexpr double production_bits = 40;
    constexpr double terminal_bits = 20;  // an outline of its own; readings differ in how many there are
    return description.bits.grammar + production_bits * static_cast<double>(description.exact.productions.size()) +
           terminal_bits * static_cast<double>(description.exact.terminals.size());
}

/// The best description so far at one tolerance.
struct Reading {
    std::optional<Description> description;
    double cost = 0;  ///< reading cost, raised for an opening that must convince
    std::size_t opening = 0;

    /// The same whatever the order of the calls.
    void offer(Description offered, double offered_cost, std::size_t offered_opening) {
        if (description && std::pair{cost, opening} <= std::pair{offered_cost, offered_opening}) return;
        description = std::move(offered);
        cost = offered_cost;
        opening = offered_opening;
    }
};

/// Do exact rules leave so much that the drawing may be an irregular one?
bool may_be_irregular(const std::vector<Description>& exact) {
    // What they say in a quarter of the bits has its structure already.
    constexpr double well_explained = 0.25;
    return std::ranges::none_of(exact, [](const Description& d) { return d.bits.grammar < well_explained * d.bits.drawing; });
}

/// Do nearly all elements stand where the rules put them, or next to it?
bool leaves_little_over(const Description& description) {
    constexpr double little = 0.05;          // of an element's size
    constexpr double most_exceptions = 0.2;  // of the elements
    double off = 0;
    for (std::size_t leaf = 0; leaf < description.deviation.size(); ++leaf) {
        const auto element = static_cast<std::size_t>(description.written.element_of_leaf[leaf]);
        off += description.deviation[leaf] > little * scale_of(description.reading->instancing.instances[element].pose);
    }
    return off <= most_exceptions * static_cast<double>(description.deviation.size());
}

/// Rules that leave little over are what is there; regular ones that leave more must say clearly less.
bool says_clearly_less(const Description& regular, const std::vector<Description>& exact) {
    constexpr double clearly = 0.9;
    return std::ranges::none_of(exact, [&](const Description& rules) {
        return !rules.exact.productions.empty() && leaves_little_over(rules) &&
               reading_cost(regular) >= clearly * reading_cost(rules);
    });
}

/// Calls `task(k, progress)` for k = 0 .. count - 1 on as many threads as there may be, the calling one among them: only
/// this one tells of its progress.
void run_tasks(std::size_t count, int threads, const Progress& progress,
               const std::function<void(std::size_t, const Progress&)>& task) {
    const auto available = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    const auto together = std::min(count, static_cast<std::size_t>(threads > 0 ? threads : available));
    std::atomic<std::size_t> next = 0;
    const auto work = [&](const Progress& told) {
        for (std::size_t k = next++; k < count; k = next++) task(k, told);
    };
    std::vector<std::future<void>> others;
    for (std::size_t k = 1; k < together; ++k) {
        others.push_back(std::async(std::launch::async, [&] { work({}); }));
    }
    work(progress);
    for (auto& other : others) other.get();
}

/// Is the whole drawing one row of one thing, or rows of one row, moved only and exactly? What a person sees is found then,
/// and nothing says less: no need to look any further.
bool is_plain_lattice(const Description& description) {
    const RuleSet& found = description.ordered.rules;
    constexpr std::size_t rows_of_rows = 2;
    return description.ordered.roots.size() == 1 && !found.rules.empty() && found.rules.size() <= rows_of_rows &&
           description.exact.exceptions.empty() && std::ranges::all_of(found.rules, [](const Rule& rule) {
               return rule.kind == RuleKind::sequence && rule.step.linear == Complex{1, 0} && !rule.step.mirrored;
           });
}

/// For each reading of the drawing and each tolerance, in their order, the best description of all openings; a single one if
/// it leaves nothing to wish for.
class Describer {
  public:
    /// `starts[d]`: for drawings[d] a state for each tolerance, as many for all.
    Describer(const std::vector<Drawing>& drawings, std::vector<std::span<const SearchState>> starts,
              const SearchOptions& search)
        : drawings_(drawings), starts_(std::move(starts)), search_(search), readings_(drawings.size() * tolerances()) {}

    std::vector<Description> run(int threads, const Progress& progress) {
        // All ways of an opening before the next opening: the search from below takes longest and comes first.
        const bool paper = search_.objective == Objective::paper;  // works from below only
        const std::size_t tried = paper ? 1 : openings().size();
        run_tasks(readings_.size() * tried, threads, progress, [&](std::size_t k, const Progress& told) {
            try {
                describe_from(k / readings_.size(), k % readings_.size(), told);
            } catch (const Settled&) {
                // Another one leaves nothing to wish for.
            }
        });
        std::vector<Description> descriptions;
        for (Reading& reading : readings_) {
            if (reading.description && (!settled_ || &reading == &readings_.front()))
                descriptions.push_back(std::move(*reading.description));
        }
        return descriptions;
    }

  private:
    struct Settled {};

    std::size_t tolerances() const { return starts_.empty() ? 0 : starts_.front().size(); }

    /// `way` counts readings of the drawing and tolerances.
    void describe_from(std::size_t opening, std::size_t way, const Progress& told) {
        const Progress until_settled = [&](std::string_view stage, double fraction) {
            if (settled_) throw Settled{};
            report(told, stage, fraction);
        };
        if (settled_) return;
        const SearchState& start = starts_[way / tolerances()][way % tolerances()];
        std::optional<SearchState> opened = openings()[opening].open(start, search_, until_settled);
        if (!opened) return;
        SearchState found = generate_rules(std::move(*opened), search_, until_settled);
        std::optional<Description> description =
            describe(drawings_[way / tolerances()], std::move(found.rules), start.tolerance.size);
        if (!description) return;
        const double cost = reading_cost(*description) / openings()[opening].convincing_share;
        const std::lock_guard lock(offering_);
        if (settled_) return;
        // Only the first of all may settle it, so that the result is the same for any order of the calls.
        if (opening == 0 && way == 0 && is_plain_lattice(*description)) {
            settled_ = true;
            readings_.front() = {};
        }
        readings_[way].offer(std::move(*description), cost, opening);
    }

    const std::vector<Drawing>& drawings_;
    std::vector<std::span<const SearchState>> starts_;
    const SearchOptions& search_;
    std::vector<Reading> readings_;
    std::mutex offering_;
    std::atomic<bool> settled_ = false;
};

/// An irregular drawing read once more as the regular one that it was meant to be.
std::vector<Description> describe_regular(const std::vector<Drawing>& drawings, const SearchOptions& search, int threads,
                                          const Progress& progress) {
    constexpr double size = PoseTolerance{}.size;
    std::vector<const Drawing*> drawn;
    std::vector<Drawing> meant;
    std::vector<SearchState> states;
    for (const Drawing& drawing : drawings) {
        const std::optional<Instancing> regular = regular_drawing(drawing.instancing, drawing.diagonal);
        if (!regular) continue;
        drawn.push_back(&drawing);
        meant.push_back(drawing);
        states.push_back(starting_state(*regular, {size, size, PoseTolerance{}.per_distance}, drawing.diagonal));
    }
    std::vector<std::span<const SearchState>> starts;
    for (const SearchState& state : states) starts.emplace_back(&state, 1);
    std::vector<Description> descriptions = Describer(meant, std::move(starts), search).run(threads, progress);
    for (Description& description : descriptions) {
        description.reading = drawn[static_cast<std::size_t>(description.reading - meant.data())];
    }
    return descriptions;
}

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
               const AnalyzeOptions& options) {
    Proof proof;
    if (options.symmetrize) {
        proof.layered = with_paint_order(description.written.grammar, description.written.element_of_leaf, overlaps);
        proof.grammar = parse_grammar(to_text(proof.layered));
        proof.check = verify_layout(proof.grammar, description.written, description.reading->instancing, drawing.diagonal);
        return proof;
    }
    proof.layered = with_paint_order(description.exact, description.written.element_of_leaf, overlaps);
    proof.grammar = parse_grammar(to_text(proof.layered));
    proof.check = verify(proof.grammar, drawing.scene, overlaps, {.threads = options.threads});
    return proof;
}

/// Does it look the same though pairs are exchanged whose order hardly shows?
bool looks_the_same(const Drawing& drawing, const Proof& proof, int threads) {
    const std::vector<OverlapPair>& exchanged = proof.check.exchanged_faint;
    if (exchanged.empty()) return true;
    return same_picture(drawing.scene, to_scene(proof.grammar, interpret(proof.grammar)), exchanged, threads);
}

}  // namespace

Grammar flat_grammar(const Scene& scene, const Instancing& instancing) {
    const Overlaps overlaps;
    const Drawing drawing{scene, instancing, overlaps, drawing_diagonal(scene), 0};
    return describe(drawing, no_rules(drawing), 0)->exact;
}

Analysis analyze(const Scene& scene, const AnalyzeOptions& options, const Progress& progress) {
    return analyze(prepare_drawing(scene, options, progress), options, progress);
}

Analysis analyze(const PreparedDrawing& prepared, const AnalyzeOptions& options, const Progress& progress) {
    Analysis analysis;
    AnalysisReport& report_out = analysis.report;
    report_out.seconds.similarity = prepared.seconds;
    report_out.symmetrized = options.symmetrize;
    Stopwatch watch;
    const Overlaps& overlaps = prepared.overlaps;
    // Two readings: equal shapes in other styles are other looks, or one look with its colours as arguments.
    const double flat_bits = flat_list_bits(prepared.readings.front().instancing, prepared.diagonal);
    std::vector<Drawing> drawings;
    for (const PreparedReading& reading : prepared.readings) {
        if (drawings.empty() || options.objective == Objective::bits)
            drawings.push_back({*prepared.scene, reading.instancing, overlaps, prepared.diagonal, flat_bits});
    }

    // Rules, at several tolerances; the shortest description that proves right is kept.
    SearchOptions search;
    search.weights = options.weights;
    search.objective = report_out.objective = options.objective;
    const bool shortest = options.objective == Objective::bits;
    std::vector<std::span<const SearchState>> starts;
    for (std::size_t d = 0; d < drawings.size(); ++d) starts.emplace_back(prepared.readings[d].starts);
    std::vector<Description> descriptions = Describer(drawings, std::move(starts), search).run(options.threads, progress);
    if (options.tolerance == 0 && may_be_irregular(descriptions)) {
        std::vector<Description> loose = describe_regular(drawings, search, options.threads, progress);
        std::erase_if(loose, [&](const Description& each) { return !says_clearly_less(each, descriptions); });
        std::ranges::move(loose, std::back_inserter(descriptions));
    }
    std::ranges::stable_sort(descriptions, {}, reading_cost);
    std::erase_if(descriptions, [&](const Description& d) { return shortest && d.bits.grammar >= d.bits.drawing; });
    report_out.seconds.rules = watch.lap();

    // The proof, from the text that will be written. The flat list of all elements is the last resort.
    for (std::size_t tried = 0;; ++tried) {
        report(progress, "check", static_cast<double>(tried) / 4);
        const bool last = tried == descriptions.size();
        if (last) descriptions.push_back(*describe(drawings.front(), no_rules(drawings.front()), 0));
        const Description& description = descriptions[tried];
        Proof proof = proof_of(drawings.front(), description, overlaps, options);
        if (proof.check.passed && !looks_the_same(drawings.front(), proof, options.threads)) {
            // What hardly shows once shows when it comes by the hundred: these orders are kept as well.
            proof = proof_of(drawings.front(), description, with_faint_pairs(overlaps), options);
        }
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
        fill_report(report_out, description.ordered, description.written, analysis.grammar,
                    description.reading->instancing);
        report_out.drawing_bits = bits.drawing;
        report_out.grammar_bits = bits.grammar;
        report_out.tolerance = description.tolerance;
        break;
    }
    report_out.seconds.verify = watch.lap();
    return analysis;
}

}  // namespace rinceau
