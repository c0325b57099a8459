#pragma once
// Long text in pieces, for what is too long to be held.

#include <functional>
#include <string>
#include <string_view>

namespace rinceau {

/// Takes the pieces one after the other; a view holds during the call only. What it throws ends the writing.
using TextSink = std::function<void(std::string_view)>;

/// Collects small pieces into large ones.
class TextPieces {
  public:
    /// Refers to the sink, which must outlive it.
    explicit TextPieces(const TextSink& sink) : sink_(sink) {}

    /// To be appended to. Call pass_on_if_large now and then.
    std::string& text() { return text_; }
    void pass_on_if_large() {
        constexpr std::size_t large = std::size_t{1} << 16U;
        if (text_.size() >= large) pass_on();
    }
    /// What is left.
    void pass_on() {
        sink_(text_);
        text_.clear();
    }

  private:
    const TextSink& sink_;
    std::string text_;
};

}  // namespace rinceau
