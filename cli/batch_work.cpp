#include "cli/batch_work.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <stdexcept>

#include "cli/analysis_check.h"
#include "files/files.h"
#include "files/fingerprint.h"
#include "files/output_error.h"
#include "files/output_file.h"
#include "lsystem/grammar_text.h"
#include "lsystem/interpret.h"
#include "lsystem/to_scene.h"
#include "scene/svg_raster.h"
#include "scene/svg_read.h"

namespace rinceau {
namespace {

namespace fs = std::filesystem;

constexpr double picture_side = 320;       // pixels of the longer side
constexpr std::size_t most_warnings = 20;  // that a row holds

void put(const BatchWork& work, const std::string& file, const std::string& bytes) {
    const fs::path name = fs::path(work.folder) / file;
    std::error_code error;
    fs::create_directories(name.parent_path(), error);
    if (error) fail_output(name.string(), error.value());
    write_output(name.string(), bytes, work.work_folder);
}

int picture_width(const Scene& scene) {
    const double across = width(scene.viewport), longer = std::max(across, height(scene.viewport));
    return longer > 0 ? std::max(1, static_cast<int>(picture_side * across / longer)) : 1;
}

/// What stands in the place of a picture that cannot be drawn.
std::string no_picture() {
    return svg_to_png(
        "<svg xmlns='http://www.w3.org/2000/svg' width='160' height='40'><text x='80' y='25' text-anchor='middle' "
        "font-family='sans-serif' font-size='14' fill='gray'>no picture</text></svg>");
}

std::string picture_of(const std::string& svg, int width, BatchRow& row) {
    try {
        return svg_to_png(svg, width);
    } catch (const InputError& error) {
        row.warnings.push_back(std::string("no picture: ") + error.what());
    } catch (const LimitError& error) {
        row.warnings.push_back(std::string("no picture: ") + error.what());
    }
    return no_picture();
}

void put_pictures(const BatchWork& work, const std::string& drawing, const Scene& scene, const Grammar& grammar,
                  BatchRow& row) {
    const int width = picture_width(scene);
    put(work, picture_before_file(row.drawing), picture_of(drawing, width, row));
    std::string drawn;
    write_grammar_svg(grammar, {}, {}, [&drawn](std::string_view piece) { drawn += piece; });
    put(work, picture_after_file(row.drawing), picture_of(drawn, width, row));
}

void tell_findings(const AnalysisReport& report, BatchRow& row) {
    row.elements = report.elements;
    row.verbatim = report.verbatim;
    row.terminals = static_cast<int>(report.terminals.size());
    row.rules = static_cast<int>(report.productions.size());
    for (const ProductionReport& production : report.productions) ++row.kinds[production.kind];
    row.drawing_bits = report.drawing_bits;
    row.grammar_bits = report.grammar_bits;
    row.error_max = report.check.max_deviation;
    row.error_rms = report.check.rms_deviation;
    row.tolerance = report.tolerance;
}

void tell_warnings(const std::vector<Warning>& reading, const std::vector<std::string>& analysis, BatchRow& row) {
    for (const Warning& warning : reading) row.warnings.push_back(located(warning.place, warning.message));
    row.warnings.insert(row.warnings.end(), analysis.begin(), analysis.end());
    if (row.warnings.size() <= most_warnings) return;
    const std::size_t more = row.warnings.size() - most_warnings;
    row.warnings.resize(most_warnings);
    row.warnings.push_back("and " + std::to_string(more) + " more");
}

void analyze_and_write(const BatchWork& work, const std::string& input, BatchRow& row) {
    const std::string& stem = row.drawing;
    std::error_code unlisted;
    if (stem.ends_with('/') && fs::directory_iterator(input, unlisted) == fs::directory_iterator() && unlisted)
        throw InputError({input}, "the folder cannot be listed: " + unlisted.message());
    expect_no_shape_grammar(input);
    const std::string bytes = read_input(input);
    row.bytes = bytes.size();
    row.fingerprint = fingerprint(bytes);
    const SvgReadResult drawing = read_svg(bytes, {.file_name = input});
    const Analysis analysis = analyze(drawing.scene, work.analyze);
    expect_passed(analysis.report.check, input);
    tell_findings(analysis.report, row);
    tell_warnings(drawing.warnings, analysis.report.warnings, row);
    const std::string grammar = to_text(analysis.grammar);
    row.grammar_fingerprint = fingerprint(grammar);
    put(work, grammar_file(stem), grammar);
    if (work.pictures) put_pictures(work, bytes, drawing.scene, analysis.grammar, row);
}

bool exists(const BatchWork& work, const std::string& file) {
    std::error_code ignored;
    return fs::is_regular_file(fs::path(work.folder) / file, ignored);
}

}  // namespace

std::string grammar_file(const std::string& stem) { return stem + ".lsys"; }
std::string picture_before_file(const std::string& stem) { return "pictures/" + stem + "_before.png"; }
std::string picture_after_file(const std::string& stem) { return "pictures/" + stem + "_after.png"; }

BatchRow analyze_for_batch(const BatchWork& work, const std::string& input, const std::string& stem) {
    BatchRow row{.drawing = stem, .options = work.options};
    const auto failed = [&row](BatchStatus status, const std::string& message) {
        row.status = status;
        row.message = message;
    };
    try {
        analyze_and_write(work, input, row);
        row.status = BatchStatus::done;
    } catch (const InputError& error) {
        failed(BatchStatus::input_at_fault, error.what());
    } catch (const LimitError& error) {
        failed(BatchStatus::limit_reached, error.what());
    } catch (const std::bad_alloc&) {
        failed(BatchStatus::limit_reached, input + ": the memory does not suffice");
    } catch (const std::length_error&) {
        failed(BatchStatus::limit_reached, input + ": the memory does not suffice");
    } catch (const OutputError& error) {
        failed(BatchStatus::output_not_written, error.what());
    } catch (const std::exception& error) {
        failed(BatchStatus::crashed, input + ": " + error.what());
    }
    return row;
}

bool is_whole(const BatchRow& row, const BatchWork& work, const std::string& input) {
    if (row.options != work.options) return false;
    if (row.status != BatchStatus::done && row.status != BatchStatus::input_at_fault) return false;
    try {
        const std::string bytes = read_input(input);
        if (row.bytes != bytes.size() || row.fingerprint != fingerprint(bytes)) return false;
        if (row.status == BatchStatus::input_at_fault) return true;
        const fs::path grammar = fs::path(work.folder) / grammar_file(row.drawing);
        if (row.grammar_fingerprint != fingerprint(read_input(grammar.string()))) return false;
    } catch (const std::runtime_error&) {
        return false;  // what cannot be read: the reason may be another one now
    }
    return !work.pictures ||
           (exists(work, picture_before_file(row.drawing)) && exists(work, picture_after_file(row.drawing)));
}

}  // namespace rinceau
