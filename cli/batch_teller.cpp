#include "cli/batch_teller.h"

#include "cli/messages.h"

namespace rinceau {
namespace {

std::string findings(const std::string& input, const BatchRow& row) {
    std::string text = input + ": " + std::to_string(row.elements) + (row.elements == 1 ? " element, " : " elements, ") +
                       std::to_string(row.rules) + (row.rules == 1 ? " rule" : " rules");
    const std::size_t warnings = row.warnings.size();
    if (warnings > 0) text += ", " + std::to_string(warnings) + (warnings == 1 ? " warning" : " warnings");
    return text;
}

std::string drawings_text(std::size_t number) { return std::to_string(number) + (number == 1 ? " drawing" : " drawings"); }

}  // namespace

BatchTeller::BatchTeller(std::size_t todo, std::size_t drawings)
    : progress_(bar_.callback()), todo_(todo), start_(std::chrono::steady_clock::now()) {
    if (todo < drawings) say(std::to_string(drawings - todo) + " of " + drawings_text(drawings) + " are whole already");
}

void BatchTeller::tell(const std::string& input, const BatchRow& row) {
    ++ended_;
    const bool failed = row.status != BatchStatus::done;
    if (failed) ++failed_;
    if (!progress_) {
        say(std::to_string(ended_) + "/" + std::to_string(todo_) + " " + (failed ? row.message : findings(input, row)));
        return;
    }
    if (failed) {
        bar_.wipe();
        say(row.message);
    }
    report(progress_, stage(), static_cast<double>(ended_) / static_cast<double>(todo_));
}

/// "12 of 43 drawings, 1 failed, 0:31 left".
std::string BatchTeller::stage() const {
    using Seconds = std::chrono::duration<double>;
    const double each = Seconds(std::chrono::steady_clock::now() - start_).count() / static_cast<double>(ended_);
    const auto left = static_cast<long long>(each * static_cast<double>(todo_ - ended_));
    constexpr long long minute = 60, hour = 3600;
    const auto two_digits = [](long long number) { return (number < 10 ? "0" : "") + std::to_string(number); };
    std::string text = std::to_string(ended_) + " of " + drawings_text(todo_);
    if (failed_ > 0) text += ", " + std::to_string(failed_) + " failed";
    return text + ", " + std::to_string(left / hour) + ":" + two_digits(left / minute % minute) + ":" +
           two_digits(left % minute) + " left";
}

void BatchTeller::tell_interruption() {
    bar_.wipe();
    say("interrupted: " + std::to_string(ended_) + " of " + drawings_text(todo_) +
        " have been looked at; the same command with --resume goes on");
}

std::size_t say_totals(const BatchEntries& entries) {
    std::size_t drawings = 0, failed = 0;
    entries([&](const BatchEntry& entry) {
        ++drawings;
        if (entry.row.status != BatchStatus::done) ++failed;
    });
    say(drawings_text(drawings) + ": " + std::to_string(drawings - failed) + " done, " + std::to_string(failed) + " failed");
    return failed;
}

}  // namespace rinceau
