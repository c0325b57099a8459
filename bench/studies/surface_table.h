#pragma once
// Tables of the benchmark of patterns on surfaces.

#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace rinceau::test {

/// Prints cells under their titles, or as comma-separated values. Rows have as many cells as there are titles.
class RowPrinter {
  public:
    /// `widths` of all columns but the last.
    RowPrinter(bool csv, const std::vector<std::string>& titles, std::vector<int> widths)
        : csv_(csv), widths_(std::move(widths)) {
        print(titles);
    }

    void print(const std::vector<std::string>& cells) const {
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (csv_) {
                std::cout << (i == 0 ? "" : ",") << '"' << cells[i] << '"';
            } else {
                std::cout << std::left << std::setw(i < widths_.size() ? widths_[i] : 0) << cells[i] << ' ';
            }
        }
        std::cout << std::endl;
    }

  private:
    bool csv_;
    std::vector<int> widths_;
};

/// Three digits are enough to see whether a bar is met.
inline std::string short_text(double value) {
    std::ostringstream out;
    out << std::setprecision(3) << value;
    return out.str();
}

/// "pass", or what is at fault.
inline std::string verdict_of(const std::string& faults) { return faults.empty() ? "pass" : "FAIL:" + faults; }

}  // namespace rinceau::test
