#pragma once
// Names for another language: none of its words, none twice.

#include <set>
#include <string>

namespace rinceau {

class UniqueNames {
  public:
    /// `reserved`: names that cannot be given.
    explicit UniqueNames(std::set<std::string> reserved) : taken_(std::move(reserved)) {}

    /// `wanted`, or with underscores behind it; taken from now on.
    std::string take(std::string wanted) {
        while (!taken_.insert(wanted).second) wanted += '_';
        return wanted;
    }
    bool is_taken(const std::string& name) const { return taken_.contains(name); }

  private:
    std::set<std::string> taken_;
};

}  // namespace rinceau
