#include "cli/batch_sheet.h"

#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>

#include <CLI/Error.hpp>

#include "cli/batch_work.h"
#include "files/output_file.h"
#include "scene/svg_write.h"

namespace rinceau {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t cards_on_page = 120;      // more are slow to look through
constexpr std::size_t most_failed_named = 200;  // at the top of the first page

struct Totals {
    std::size_t drawings = 0;
    std::size_t done = 0;
    std::size_t elements = 0;
    std::size_t rules = 0;
    double drawing_bits = 0;
    double grammar_bits = 0;
};

Totals totals_of(const BatchEntries& entries) {
    Totals totals;
    entries([&totals](const BatchEntry& entry) {
        const BatchRow& row = entry.row;
        ++totals.drawings;
        if (row.status == BatchStatus::done) ++totals.done;
        totals.elements += static_cast<std::size_t>(row.elements);
        totals.rules += static_cast<std::size_t>(row.rules);
        totals.drawing_bits += row.drawing_bits;
        totals.grammar_bits += row.grammar_bits;
    });
    return totals;
}

/// A file's name as part of an address.
std::string address(const std::string& name) {
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string text;
    for (const char c : name) {
        if (plain.find(c) != std::string_view::npos) {
            text += c;
        } else {
            const auto byte = static_cast<unsigned char>(c);
            text += {'%', digits[byte / digits.size()], digits[byte % digits.size()]};
        }
    }
    return text;
}

std::string counted(std::size_t number, const std::string& singular, const std::string& plural) {
    return std::to_string(number) + " " + (number == 1 ? singular : plural);
}

std::string counted(int number, const std::string& singular, const std::string& plural) {
    return counted(static_cast<std::size_t>(number), singular, plural);
}

std::string bits_text(double drawing_bits, double grammar_bits) {
    std::string text =
        std::to_string(std::llround(drawing_bits)) + " &rarr; " + std::to_string(std::llround(grammar_bits)) + " bits";
    if (drawing_bits > 0) text += " (" + std::to_string(std::llround(100 * grammar_bits / drawing_bits)) + " %)";
    return text;
}

std::string short_number(double value) {
    constexpr int digits = 2;
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits).ptr;
    return {text.data(), end};
}

constexpr const char* style = R"(
body { font: 15px/1.4 sans-serif; margin: 1.5em; color: #222; background: #f4f4f2; }
h1 { font-size: 1.4em; margin: 0 0 .3em; }
nav { margin: 1em 0; }
nav a, nav b { margin-right: .6em; }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(340px, 1fr)); gap: 1em; }
article { background: #fff; border: 1px solid #ddd; border-radius: 6px; padding: .7em; overflow-wrap: anywhere; }
article.failed { border-color: #c33; }
h2 { font-size: 1em; margin: 0 0 .5em; }
.pictures { display: flex; gap: .5em; }
figure { margin: 0; flex: 1; text-align: center; }
figure img { width: 100%; height: 160px; object-fit: contain; background: #fff; border: 1px solid #eee; }
figcaption { font-size: .8em; color: #777; }
p { margin: .4em 0 0; }
.message, .failures { color: #a11; }
details { margin-top: .3em; font-size: .85em; color: #666; }
)";

std::string figure(const std::string& file, const std::string& caption) {
    return "<figure><a href=\"" + file + "\"><img src=\"" + file + "\" alt=\"" + caption +
           "\" loading=\"lazy\"></a><figcaption>" + caption + "</figcaption></figure>";
}

std::string findings(const BatchRow& row) {
    std::string text = "<p>" + counted(row.elements, "element", "elements") + ", " +
                       counted(row.terminals, "terminal", "terminals") + ", " + counted(row.rules, "rule", "rules");
    std::string kinds;
    for (const auto& [kind, number] : row.kinds)
        kinds += (kinds.empty() ? "" : ", ") + std::to_string(number) + " " + xml_escaped(kind);
    if (!kinds.empty()) text += " (" + kinds + ")";
    text += "</p>\n<p>" + bits_text(row.drawing_bits, row.grammar_bits) + "; largest deviation " +
            short_number(row.error_max) + " of the diagonal</p>\n";
    return text;
}

std::string card(const BatchEntry& entry, const std::string& way) {
    const BatchRow& row = entry.row;
    const std::string title = xml_escaped(entry.input);
    const std::string id = "<article id=\"" + address(row.drawing) + "\"";
    if (row.status != BatchStatus::done)
        return id + " class=\"failed\">\n<h2>" + title + "</h2>\n<p class=\"message\">" + xml_escaped(row.message) +
               "</p>\n</article>\n";
    std::string text = id + ">\n<h2><a href=\"" + way + address(grammar_file(row.drawing)) + "\">" + title +
                       "</a></h2>\n<div class=\"pictures\">" +
                       figure(way + address(picture_before_file(row.drawing)), "before") +
                       figure(way + address(picture_after_file(row.drawing)), "after") + "</div>\n" + findings(row);
    if (row.warnings.empty()) return text + "</article>\n";
    text += "<details><summary>" + counted(row.warnings.size(), "warning", "warnings") + "</summary>\n";
    for (const std::string& warning : row.warnings) text += "<p>" + xml_escaped(warning) + "</p>\n";
    return text + "</details>\n</article>\n";
}

/// The pages of one sheet.
class Pages {
  public:
    Pages(const std::string& name, std::size_t cards) : name_(name), number_((cards + cards_on_page - 1) / cards_on_page) {}

    /// As a file; the first has the name that was given.
    std::string file(std::size_t page) const {
        const fs::path first(name_);
        if (page == 0) return name_;
        const std::string own = first.stem().string() + "-" + std::to_string(page + 1) + first.extension().string();
        return (first.parent_path() / own).string();
    }

    std::string link(std::size_t page) const { return address(fs::path(file(page)).filename().string()); }

    /// Ways to the pages around, the first and the last.
    std::string navigation(std::size_t page) const {
        constexpr std::size_t around = 4;
        if (number_ < 2) return "";
        std::string text = "<nav>Pages: ";
        for (std::size_t i = 0; i < number_; ++i) {
            const bool near = i + around >= page && i <= page + around;
            if (!near && i != 0 && i + 1 != number_) continue;
            const std::string label = std::to_string(i + 1);
            text += i == page ? "<b>" + label + "</b>" : "<a href=\"" + link(i) + "\">" + label + "</a>";
        }
        return text + "</nav>\n";
    }

  private:
    std::string name_;
    std::size_t number_;
};

std::string heading(const Totals& totals) {
    const std::size_t failed = totals.drawings - totals.done;
    return "<h1>" + counted(totals.drawings, "drawing", "drawings") + ", " + std::to_string(totals.done) + " done, " +
           std::to_string(failed) + " failed</h1>\n<p>" + counted(totals.elements, "element", "elements") + ", " +
           counted(totals.rules, "rule", "rules") + "; " + bits_text(totals.drawing_bits, totals.grammar_bits) + "</p>\n";
}

std::string failures(const BatchEntries& entries, const Pages& pages) {
    std::string text;
    std::size_t place = 0, named = 0;
    entries([&](const BatchEntry& entry) {
        const std::size_t page = place++ / cards_on_page;
        if (entry.row.status == BatchStatus::done || named++ >= most_failed_named) return;
        text +=
            "<a href=\"" + pages.link(page) + "#" + address(entry.row.drawing) + "\">" + xml_escaped(entry.input) + "</a> ";
    });
    if (text.empty()) return "";
    if (named > most_failed_named) text += "and " + std::to_string(named - most_failed_named) + " more";
    return "<p class=\"failures\">Failed: " + text + "</p>\n";
}

void begin_page(OutputFile& file, const std::string& top) {
    file.write(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>Rinceau: drawings before and after"
        "</title>\n<style>" +
        std::string(style) + "</style>\n</head>\n<body>\n" + top + "<main>\n");
}

void end_page(OutputFile& file, const std::string& navigation) {
    file.write("</main>\n" + navigation + "</body>\n</html>\n");
    file.finish();
}

}  // namespace

std::string way_to_outputs(const std::string& name, const std::string& folder) {
    const fs::path inside = fs::weakly_canonical(fs::absolute(folder));
    const fs::path page_folder = fs::weakly_canonical(fs::absolute(name)).parent_path();
    const fs::path relative = page_folder.lexically_relative(inside);
    if (relative.empty() || *relative.begin() == "..")
        throw CLI::ValidationError("--report",
                                   "expected a page (.html) inside the folder of -o, which it shows, found '" + name + "'");
    std::string way;
    for (const fs::path& part : relative)
        if (part != ".") way += "../";
    return way;
}

void write_batch_sheet(const std::string& name, const std::string& way, const BatchEntries& entries) {
    const Totals totals = totals_of(entries);
    const Pages pages(name, totals.drawings);
    const std::string first_top = heading(totals) + failures(entries, pages);
    std::optional<OutputFile> file;
    std::size_t page = 0, cards = 0;
    file.emplace(name);
    begin_page(*file, first_top + pages.navigation(0));
    entries([&](const BatchEntry& entry) {
        if (cards == cards_on_page) {
            end_page(*file, pages.navigation(page));
            ++page;
            cards = 0;
            file.emplace(pages.file(page));
            begin_page(*file, pages.navigation(page));
        }
        file->write(card(entry, way));
        ++cards;
    });
    end_page(*file, pages.navigation(page));
}

}  // namespace rinceau
