#pragma once
// Words whose numbers are still known as values, so that sentences which differ in numbers alone can be told as one.

#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

namespace floes {

class Words {
  public:
    Words() = default;
    Words(std::string text) : texts_{std::move(text)} {}
    Words(const char* text) : Words(std::string(text)) {}

    /// As fmt::format() of fields without names or numbers: numbers stay known, and so do those of Words.
    template <class... Values>
    static Words of(std::string_view format, const Values&... values) {
        Words made;
        const auto put = [&](const auto& value) {
            const std::size_t open = format.find('{');
            const std::size_t end = format.find('}', open) + 1;
            made += std::string(format.substr(0, open));
            made.put(format.substr(open, end - open), value);
            format.remove_prefix(end);
        };
        (put(values), ...);
        return made += std::string(format);
    }

    /// "1 floe", "2 floes".
    static Words counted(std::int64_t count, std::string_view noun);
    static Words joined(const std::vector<Words>& parts, const char* between);

    /// One for all: with the range of each number, "towed at 0.1 to 0.2 m/s". None where they differ in more.
    static std::optional<Words> with_ranges(std::span<const Words> all);

    Words& operator+=(const Words& more);
    friend Words operator+(Words first, const Words& more) { return first += more; }

    std::string text() const;
    bool empty() const { return numbers_.empty() && texts_.front().empty(); }
    friend bool operator==(const Words& a, const Words& b) { return a.text() == b.text(); }

  private:
    struct Number {
        double value = 0;
        std::string text;  ///< as it is said
    };

    template <class Value>
    void put(std::string_view field, const Value& value) {
        if constexpr (std::same_as<Value, Words>) {
            *this += value;
        } else if constexpr (std::is_arithmetic_v<Value>) {
            numbers_.push_back({static_cast<double>(value), fmt::format(fmt::runtime(field), value)});
            texts_.emplace_back();
        } else {
            texts_.back() += fmt::format(fmt::runtime(field), value);
        }
    }

    std::vector<std::string> texts_{""};  ///< before, between and behind the numbers
    std::vector<Number> numbers_;
};

}  // namespace floes
