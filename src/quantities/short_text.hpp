#pragma once
// A short text that is a value of its own: constants of the compiler and what is made at run time alike.

#include <array>
#include <stdexcept>
#include <string_view>

namespace floes {

class ShortText {
  public:
    constexpr ShortText() = default;
    constexpr ShortText(const char* text) : ShortText(std::string_view{text}) {}
    /// Throws std::length_error for one that is too long.
    constexpr explicit ShortText(std::string_view text) : size_(text.size()) {
        if (text.size() > letters_.size()) throw std::length_error("A short text is too long.");
        text.copy(letters_.data(), text.size());
    }

    constexpr operator std::string_view() const { return view(); }
    constexpr std::string_view view() const { return {letters_.data(), size_}; }
    constexpr bool empty() const { return size_ == 0; }
    friend constexpr bool operator==(const ShortText& one, const ShortText& other) {
        return one.view() == other.view();
    }

  private:
    std::array<char, 64> letters_{};
    std::size_t size_ = 0;
};

/// How fmt writes it.
constexpr std::string_view format_as(const ShortText& text) {
    return text.view();
}

}  // namespace floes
