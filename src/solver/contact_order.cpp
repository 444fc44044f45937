#include "solver/contact_order.hpp"

#include <algorithm>
#include <tuple>

namespace floes {

void ContactOrder::find_pairs(std::span<const Contact> contacts, std::uint32_t spare) {
    next_level_.assign(spare, 0);
    pairs_.clear();
    for (std::uint32_t i = 0; i < contacts.size(); ++i) {
        const auto [slots, a_moves, b_moves, pressed] = contacts[i];
        if (i > 0 && contacts[i - 1].slots.a == slots.a && contacts[i - 1].slots.b == slots.b) {
            ++pairs_.back().contacts;
            pairs_.back().pressed |= pressed;
            continue;
        }
        const std::uint32_t level = std::max(a_moves ? next_level_[slots.a] : 0, b_moves ? next_level_[slots.b] : 0);
        if (a_moves) next_level_[slots.a] = level + 1;
        if (b_moves) next_level_[slots.b] = level + 1;
        pairs_.push_back({level, pressed, 1, i});
    }
}

void ContactOrder::add_pack(std::span<const Contact> contacts, std::span<const Pair> pairs, std::uint32_t spare,
                            std::uint32_t width) {
    const std::uint32_t turns = pairs.size() > width ? 2 : 1;
    const std::uint32_t first_row = packs_.empty() ? 0 : packs_.back().end_row;
    const std::size_t first_slot = pack_slots_.size();
    std::uint32_t most = 0;
    pack_slots_.resize(first_slot + 2 * width * turns, spare);
    for (std::uint32_t i = 0; i < pairs.size(); ++i) {
        const auto [level, pressed, count, first] = pairs[i];
        const std::uint32_t turn = i / width;
        std::uint32_t* const slots = &pack_slots_[first_slot + 2 * width * turn + i % width];
        slots[0] = contacts[first].slots.a;
        slots[width] = contacts[first].slots.b;
        for (std::uint32_t k = 0; k < count; ++k) row_slots_[first + k] = (first_row + k * turns) * width + i;
        most = std::max(most, count);
    }
    packs_.push_back({turns, first_row, first_row + most * turns});
}

void ContactOrder::lay_out(std::span<const Contact> contacts, std::uint32_t spare, int width, int turns) {
    find_pairs(contacts, spare);
    // Side by side those with as many contacts, since a pack has the rows of its longest pair, and those that will
    // likely bear nothing, for which there is no friction to solve.
    std::sort(pairs_.begin(), pairs_.end(), [](const Pair& x, const Pair& y) {
        return std::tuple(x.level, y.pressed, y.contacts, x.first) <
               std::tuple(y.level, x.pressed, x.contacts, y.first);
    });
    const auto lanes = static_cast<std::uint32_t>(width);
    const auto most = static_cast<std::size_t>(width * turns);
    row_slots_.resize(contacts.size());
    pack_slots_.clear();
    packs_.clear();
    for (std::size_t first = 0, end = 0; first < pairs_.size(); first = end) {
        while (end < pairs_.size() && end < first + most && pairs_[end].level == pairs_[first].level) ++end;
        add_pack(contacts, {&pairs_[first], end - first}, spare, lanes);
    }
}

}  // namespace floes
