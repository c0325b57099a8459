#pragma once
// The lines that the benchmark of growth prints: a figure, what it must be, and whether it is.

#include <ctime>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>

namespace rinceau::test {

constexpr double any = std::numeric_limits<double>::infinity();

/// Counts what passes and what fails. Text for a person, or comma-separated values.
class GrowthLines {
  public:
    explicit GrowthLines(bool csv) : csv_(csv) {
        if (csv_) std::cout << "case,figure,value,low,high,verdict\n";
    }
    void begin(const std::string& name) {
        name_ = name;
        if (!csv_) std::cout << '\n' << name << '\n';
    }
    /// A figure that is only said.
    void say(const std::string& figure, double value) { line(figure, value, "", "", ""); }
    void at_most(const std::string& figure, double value, double high) { judged(figure, value, -any, high); }
    void at_least(const std::string& figure, double value, double low) { judged(figure, value, low, any); }
    void between(const std::string& figure, double value, double low, double high) { judged(figure, value, low, high); }
    void failed(const std::string& what) {
        ++failures_;
        csv_ ? std::cout << '"' << name_ << "\",\"" << what << "\",,,,FAIL\n" : std::cout << "  FAIL: " << what << '\n';
    }
    /// A judgement that is printed elsewhere.
    void count(bool good) {
        ++judgements_;
        failures_ += good ? 0 : 1;
    }
    int failures() const { return failures_; }
    int judgements() const { return judgements_; }

  private:
    static std::string text(double value) {
        std::ostringstream out;
        out << std::setprecision(4) << value;
        return out.str();
    }
    void judged(const std::string& figure, double value, double low, double high) {
        const bool good = value >= low && value <= high;
        ++judgements_;
        failures_ += good ? 0 : 1;
        line(figure, value, low > -any ? text(low) : "", high < any ? text(high) : "", good ? "pass" : "FAIL");
    }
    void line(const std::string& figure, double value, const std::string& low, const std::string& high,
              const std::string& verdict) {
        if (csv_) {
            std::cout << '"' << name_ << "\",\"" << figure << "\"," << text(value) << ',' << low << ',' << high << ','
                      << verdict << '\n';
            return;
        }
        const std::string bar = low.empty() && high.empty() ? ""
                                : low.empty()               ? "<= " + high
                                : high.empty()              ? ">= " + low
                                                            : low + " .. " + high;
        std::cout << "  " << std::left << std::setw(44) << figure << std::setw(12) << text(value) << std::setw(18) << bar
                  << verdict << std::endl;
    }

    bool csv_;
    std::string name_;
    int failures_ = 0, judgements_ = 0;
};

/// Seconds of the processor since `start` = std::clock(): what else runs on the machine does not count.
inline double processor_seconds(std::clock_t start) { return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC; }

}  // namespace rinceau::test
