#include "cli/batch.h"

#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <thread>

#include "cli/batch_journal.h"
#include "cli/batch_processes.h"
#include "cli/batch_report.h"
#include "cli/batch_sheet.h"
#include "cli/batch_teller.h"
#include "cli/batch_work.h"
#include "cli/exit_status.h"
#include "cli/messages.h"
#include "cli/number_range.h"
#include "files/files.h"
#include "files/output_error.h"
#include "files/output_file.h"
#include "lsystem/number_text.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

namespace fs = std::filesystem;

constexpr double default_seconds = 600;

/// Where the row of each drawing stands in the journal.
using RowPlaces = std::vector<std::optional<std::uint64_t>>;

struct BatchReports {
    std::vector<std::string> csv, json, sheets;
};

BatchReports expect_reports(const std::vector<std::string>& names, const std::string& folder) {
    BatchReports reports;
    for (const std::string& name : names) {
        const FileFormat format = is_standard_stream(name) ? FileFormat::unknown : format_of(name, FileFormat::unknown);
        if (format == FileFormat::csv) {
            reports.csv.push_back(name);
        } else if (format == FileFormat::json) {
            reports.json.push_back(name);
        } else if (format == FileFormat::html) {
            way_to_outputs(name, folder);
            reports.sheets.push_back(name);
        } else {
            throw CLI::ValidationError("--report",
                                       "expected a name that ends in .csv, .json or .html, found '" + name + "'");
        }
    }
    return reports;
}

void expect_folder(const std::string& folder) {
    std::error_code ignored;
    if (folder.empty())
        throw CLI::ValidationError("-o", "is needed for many drawings: the folder that their grammars are written to");
    if (folder == "-" || (format_of(folder, FileFormat::lsys) == FileFormat::lsys && !fs::is_directory(folder, ignored)))
        throw CLI::ValidationError("-o", "expected a folder for the grammars of many drawings, found '" + folder + "'");
}

void make_folder(const std::string& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) fail_output(folder, error.value());
}

/// All that decides on a grammar beside the drawing.
std::string options_text(const AnalyzeOptions& analyze) {
    const ImportanceWeights& weights = analyze.weights;
    std::string text = "rinceau " RINCEAU_VERSION "; tolerance " + number_text(analyze.tolerance) + "; similarity " +
                       number_text(analyze.similarity.tolerance) + "; weights";
    for (const double weight : {weights.count, weights.nearness, weights.similarity, weights.length})
        text += " " + number_text(weight);
    text += analyze.objective == Objective::bits ? "; bits" : "; paper";
    if (analyze.symmetrize) text += "; symmetrize";
    if (analyze.stochastic) text += "; stochastic";
    return text;
}

int processors() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

ProcessOptions process_options(const BatchOptions& options) {
    const int jobs = options.jobs.value_or(0);
    ProcessOptions processes{.jobs = jobs > 0 ? jobs : processors(), .seconds = options.seconds.value_or(default_seconds)};
    constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20;
    const auto machine =
        static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    const int memory_mib = options.memory_mib.value_or(0);
    processes.memory_bytes = memory_mib > 0 ? static_cast<std::uint64_t>(memory_mib) * mebibyte
                                            : machine / static_cast<std::uint64_t>(processes.jobs);
    return processes;
}

/// The rows that need no work, those of earlier runs that are whole.
RowPlaces whole_rows(BatchJournal& journal, const BatchDrawings& batch, const BatchWork& work) {
    ProgressBar bar;
    const Progress progress = bar.callback();
    RowPlaces places = journal.find_rows(batch.drawings, work.options);
    for (std::size_t i = 0; i < places.size(); ++i) {
        report(progress, "looking for what is whole", static_cast<double>(i) / static_cast<double>(places.size()));
        const std::string input = input_name(batch, batch.drawings[i]);
        if (places[i] && !is_whole(journal.read(*places[i]), work, input)) places[i].reset();
    }
    return places;
}

/// Of a process that came to no end of its own.
BatchRow row_of_end(const ProcessEnd& end, const std::string& input, const ProcessOptions& limits) {
    if (end.timed_out)
        return {.status = BatchStatus::limit_reached,
                .message = input + ": not done after " + number_text(limits.seconds) +
                           " s, the most that is given to one drawing (--seconds-per-file)"};
    if (end.status == exit_status::limit_reached)  // last_words.h
        return {.status = BatchStatus::limit_reached, .message = input + ": the memory does not suffice"};
    const std::string reason =
        end.signal == 0 ? "ended without a result" : std::string("ended by the signal ") + ::strsignal(end.signal);
    return {.status = BatchStatus::crashed, .message = input + ": the analysis was " + reason};
}

/// False if a signal has come that ends the program.
bool do_work(const BatchDrawings& batch, const BatchWork& work, const ProcessOptions& limits, BatchJournal& journal,
             RowPlaces& places) {
    std::vector<std::size_t> todo;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (!places[i]) todo.push_back(i);
    const auto input_of = [&](std::size_t piece) { return input_name(batch, batch.drawings[todo[piece]]); };
    const auto stem_of = [&](std::size_t piece) { return std::string(output_stem(batch.drawings[todo[piece]])); };

    const SignalsHeld signals;
    BatchTeller teller(todo.size(), batch.drawings.size());
    const auto ended = [&](const ProcessEnd& end) {
        BatchRow row = parse_row(end.output).value_or(row_of_end(end, input_of(end.piece), limits));
        row.drawing = stem_of(end.piece);
        row.options = work.options;
        row.seconds = end.seconds;
        places[todo[end.piece]] = journal.append(row);
        teller.tell(input_of(end.piece), row);
    };
    const auto one_drawing = [&](std::size_t piece) {
        return row_line(analyze_for_batch(work, input_of(piece), stem_of(piece)));
    };
    const bool all = run_in_processes(todo.size(), limits, signals, one_drawing, ended);
    if (!all) teller.tell_interruption();
    return all;
}

BatchEntries entries_of(const BatchDrawings& batch, const BatchJournal& journal, const RowPlaces& places) {
    return [&](const std::function<void(const BatchEntry&)>& sink) {
        for (std::size_t i = 0; i < places.size(); ++i)
            sink({.input = input_name(batch, batch.drawings[i]), .row = journal.read(*places[i])});
    };
}

void write_reports(const BatchReports& reports, const std::string& folder, const BatchEntries& entries) {
    for (const std::string& name : reports.csv) write_batch_csv(name, entries);
    for (const std::string& name : reports.json) write_batch_json(name, entries);
    for (const std::string& name : reports.sheets) write_batch_sheet(name, way_to_outputs(name, folder), entries);
}

BatchDrawings expect_drawings(const std::vector<std::string>& inputs, const Shard& shard) {
    BatchDrawings batch = list_drawings(inputs, shard);
    if (batch.found == 0) throw InputError({inputs.front()}, "expected drawings (.svg, .svgz) in the folder, found none");
    return batch;
}

}  // namespace

void add_batch_options(CLI::App& verb, BatchOptions& options) {
    constexpr int most_jobs = 1024;
    constexpr double longest = 1e7;       // s
    constexpr int most_memory = 1 << 30;  // MiB
    verb.add_option("--jobs", options.jobs, "Many drawings: processes at a time; 0 = one per processor, as without it")
        ->check(CLI::Range(0, most_jobs))
        ->type_name("N");
    verb.add_flag("--resume", options.resume,
                  "Many drawings: leave those that an earlier run into the same folder has done with the same options");
    verb.add_option_function<std::string>(
            "--shard", [&options](const std::string& text) { options.shard = parse_shard(text); },
            "Many drawings: do the i-th of n shares; a drawing's share depends on its name alone")
        ->type_name("i/n");
    verb.add_option("--seconds-per-file", options.seconds,
                    "Many drawings: the longest time for one; 0 = any; without it 600 s")
        ->check(number_between(0, longest))
        ->type_name("S");
    verb.add_option("--memory-per-file", options.memory_mib,
                    "Many drawings: the most memory for one, in MiB; 0 = the machine's divided by the jobs, as without it")
        ->check(CLI::Range(0, most_memory))
        ->type_name("M");
}

bool is_batch(const std::vector<std::string>& inputs, const std::string& output, const BatchOptions& options) {
    if (inputs.size() > 1 || options.jobs || options.shard || options.resume || options.seconds || options.memory_mib)
        return true;
    std::error_code ignored;
    return !output.empty() && fs::is_directory(inputs.front(), ignored);
}

int run_batch(const std::vector<std::string>& inputs, const std::string& folder, const std::vector<std::string>& reports,
              const AnalyzeOptions& analyze, const BatchOptions& options) {
    expect_folder(folder);
    const BatchReports wanted = expect_reports(reports, folder);
    const Shard shard = options.shard.value_or(Shard{});
    const BatchDrawings batch = expect_drawings(inputs, shard);
    make_folder(folder);
    for (const std::string& name : reports) expect_writable(name);

    const ProcessOptions limits = process_options(options);
    BatchJournal journal(folder, shard);
    BatchWork work{.folder = folder,
                   .work_folder = journal.work_folder(),
                   .options = options_text(analyze),
                   .pictures = !wanted.sheets.empty(),
                   .analyze = analyze};
    if (analyze.threads == 0) work.analyze.threads = std::max(1, processors() / limits.jobs);

    RowPlaces places(batch.drawings.size());
    if (options.resume) places = whole_rows(journal, batch, work);
    if (!do_work(batch, work, limits, journal, places)) return exit_status::some_failed;

    const BatchEntries entries = entries_of(batch, journal, places);
    write_reports(wanted, folder, entries);
    const std::size_t failed = say_totals(entries);
    return failed == 0 ? exit_status::done : exit_status::some_failed;
}

}  // namespace rinceau
