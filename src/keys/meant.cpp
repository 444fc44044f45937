#include "keys/meant.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace floes {

constexpr std::size_t longest_compared = 200;  // the time grows with the product of the lengths

// Allocates nothing, because an unknown key is compared with every key.
std::size_t edit_distance(std::string_view one, std::string_view other) {
    one = one.substr(0, longest_compared);
    other = other.substr(0, longest_compared);
    std::array<std::array<std::size_t, longest_compared + 1>, 3> rows;  // used in turn
    std::size_t* before_last = rows[0].data();
    std::size_t* last = rows[1].data();
    std::size_t* row = rows[2].data();
    std::iota(last, last + other.size() + 1, std::size_t{0});
    for (std::size_t i = 1; i <= one.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= other.size(); ++j) {
            const std::size_t substituted = last[j - 1] + (one[i - 1] == other[j - 1] ? 0 : 1);
            row[j] = std::min({substituted, last[j] + 1, row[j - 1] + 1});
            const bool swapped = i > 1 && j > 1 && one[i - 1] == other[j - 2] && one[i - 2] == other[j - 1];
            if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
        std::swap(before_last, last);
        std::swap(last, row);
    }
    return last[other.size()];
}

}  // namespace floes
