#include "core/words.hpp"

#include <algorithm>

namespace floes {

Words Words::counted(std::int64_t count, std::string_view noun) {
    return of("{} {}{}", count, noun, count == 1 ? "" : "s");
}

Words Words::joined(const std::vector<Words>& parts, const char* between) {
    Words made;
    for (std::size_t k = 0; k < parts.size(); ++k) made += k == 0 ? parts[k] : between + parts[k];
    return made;
}

std::optional<Words> Words::with_ranges(std::span<const Words> all) {
    if (all.empty()) return {};
    Words made = all.front();
    if (std::ranges::any_of(all, [&](const Words& one) { return one.texts_ != made.texts_; })) return {};
    for (std::size_t k = 0; k < made.numbers_.size(); ++k) {
        const auto [least, most] =
            std::ranges::minmax(all, {}, [k](const Words& one) { return one.numbers_[k].value; });
        made.numbers_[k] = least.numbers_[k];
        if (most.numbers_[k].text != least.numbers_[k].text) made.numbers_[k].text += " to " + most.numbers_[k].text;
    }
    return made;
}

Words& Words::operator+=(const Words& more) {
    texts_.back() += more.texts_.front();
    texts_.insert(texts_.end(), more.texts_.begin() + 1, more.texts_.end());
    numbers_.insert(numbers_.end(), more.numbers_.begin(), more.numbers_.end());
    return *this;
}

std::string Words::text() const {
    std::string all = texts_.front();
    for (std::size_t k = 0; k < numbers_.size(); ++k) all += numbers_[k].text + texts_[k + 1];
    return all;
}

}  // namespace floes
