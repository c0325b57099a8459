#pragma once
// Values of parameters. Internal to the folder.

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace rinceau {

/// The parameters of productions that are open, one behind the other, and behind them room for values in work.
class ParameterStack {
  public:
    std::size_t size() const { return size_; }
    const double* from(std::size_t index) const { return values_.data() + index; }

    /// Room for so many values behind the last parameter; it stays until parameters are added. Pointers of from() end.
    double* room(std::size_t count) {
        if (values_.size() < size_ + count) values_.resize(2 * (size_ + count));
        return values_.data() + size_;
    }
    /// The values may stand in the room.
    void add(std::span<const double> values) {
        if (values.data() != values_.data() + size_) std::ranges::copy(values, room(values.size()));
        size_ += values.size();
    }
    void shrink_to(std::size_t size) { size_ = size; }

  private:
    std::vector<double> values_;
    std::size_t size_ = 0;
};

}  // namespace rinceau
