#include "analyzer/verify.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "analyzer/match_drawn.h"
#include "analyzer/overlaps.h"
#include "lsystem/interpret.h"
#include "lsystem/to_scene.h"

namespace rinceau {
namespace {

/// Deviations of matched elements, as shares of the diagonal.
void measure_matches(const std::vector<DrawnMatch>& matches, double diagonal, double tolerance, Verification& result) {
    double squares = 0;
    int matched = 0;
    for (std::size_t i = 0; i < matches.size(); ++i) {
        const DrawnMatch& match = matches[i];
        const double deviation = match.deviation / diagonal;
        if (match.drawn < 0) {
            ++result.unmatched;
        } else {
            ++matched;
            squares += deviation * deviation;
            result.max_deviation = std::max(result.max_deviation, deviation);
            result.displaced += deviation > tolerance;
            result.wrong_style += !match.same_style;
        }
        if (match.drawn < 0 || deviation > tolerance || !match.same_style) result.faulty.push_back(static_cast<int>(i));
    }
    result.rms_deviation = matched > 0 ? std::sqrt(squares / matched) : 0;
}

void check_order(const Overlaps& overlaps, const std::vector<DrawnMatch>& matches, Verification& result) {
    const auto wrong = [&](const OverlapPair& pair) {
        const int lower = matches[static_cast<std::size_t>(pair.lower)].drawn;
        const int upper = matches[static_cast<std::size_t>(pair.upper)].drawn;
        return lower >= 0 && upper >= 0 && lower > upper;
    };
    std::ranges::copy_if(overlaps.faint, std::back_inserter(result.exchanged_faint), wrong);
    for (const OverlapPair& pair : overlaps.pairs) {
        if (!wrong(pair)) continue;
        ++result.wrong_order;
        result.faulty.push_back(pair.lower);
        result.faulty.push_back(pair.upper);
    }
    std::sort(result.faulty.begin(), result.faulty.end());
    result.faulty.erase(std::unique(result.faulty.begin(), result.faulty.end()), result.faulty.end());
}

std::string counted(int count, const std::string& one, const std::string& many) {
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

/// Two significant digits.
std::string short_number(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 2).ptr;
    return {text, end};
}

std::string faults_of(const Verification& result) {
    std::string faults;
    const auto add = [&](int count, const std::string& one, const std::string& many) {
        if (count > 0) faults += (faults.empty() ? "" : ", ") + counted(count, one, many);
    };
    add(result.unmatched, "element is not drawn", "elements are not drawn");
    add(result.surplus, "is drawn that the drawing does not have", "are drawn that the drawing does not have");
    add(result.displaced, "is off its place", "are off their places");
    add(result.wrong_style, "has another style", "have another style");
    add(result.wrong_order, "overlap is painted in the wrong order", "overlaps are painted in the wrong order");
    return faults;
}

std::string summary_of(const Verification& result, bool all_overlaps) {
    std::string text = result.passed ? (result.elements == 1 ? "The one element is"
                                                             : "All " + std::to_string(result.elements) + " elements are") +
                                           std::string(" drawn as they were")
                                     : "Of " + counted(result.elements, "element", "elements") + ": " + faults_of(result);
    text += "; largest deviation " + short_number(result.max_deviation) + " of the diagonal";
    if (!all_overlaps) text += "; too many overlaps to check the paint order of all";
    return text + '.';
}

}  // namespace

Verification verify(const Grammar& grammar, const Scene& scene, const VerifyOptions& options) {
    return verify(grammar, scene, find_overlaps(scene), options);
}

Verification verify(const Grammar& grammar, const Scene& scene, const Overlaps& overlaps, const VerifyOptions& options,
                    const Progress& progress) {
    const double diagonal = drawing_diagonal(scene);
    // 1. Derive afresh.
    report(progress, "check", 0);
    const Scene drawn = to_scene(grammar, interpret(grammar));
    // 2. Who is who, how far off, in which style.
    const std::vector<DrawnMatch> matches = match_drawn(scene, drawn, options.tolerance * diagonal, options.threads, progress);
    Verification result{.elements = static_cast<int>(scene.elements.size())};
    measure_matches(matches, diagonal, options.tolerance, result);
    result.surplus = static_cast<int>(drawn.elements.size()) - (result.elements - result.unmatched);
    // 3. Paint order.
    check_order(overlaps, matches, result);
    result.passed = result.faulty.empty() && result.surplus == 0;
    result.summary = summary_of(result, overlaps.complete);
    return result;
}

}  // namespace rinceau
