#include "solver/contact_order.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/contract.hpp"

namespace floes {

constexpr std::uint32_t known_levels = 64;

std::uint32_t ContactOrder::next_level(const Contact& pair) {
    const std::uint32_t level =
        std::max(pair.a_moves ? next_level_[pair.a_group] : 0, pair.b_moves ? next_level_[pair.b_group] : 0);
    if (pair.a_moves) next_level_[pair.a_group] = level + 1;
    if (pair.b_moves) next_level_[pair.b_group] = level + 1;
    return level;
}

std::uint32_t ContactOrder::first_level(const Contact& pair) {
    const std::uint64_t taken = (pair.a_moves ? levels_[pair.a_group] : 0) | (pair.b_moves ? levels_[pair.b_group] : 0);
    const auto level = static_cast<std::uint32_t>(std::countr_one(taken));
    if (level == known_levels) return known_levels + next_level(pair);  // more than anything but a wall has neighbours
    const std::uint64_t bit = std::uint64_t{1} << level;
    if (pair.a_moves) levels_[pair.a_group] |= bit;
    if (pair.b_moves) levels_[pair.b_group] |= bit;
    return level;
}

void ContactOrder::find_pairs(std::span<const Contact> contacts, Order order) {
    next_level_.assign(spare_, 0);
    if (order == Order::any) levels_.assign(spare_, 0);
    pairs_.clear();
    for (std::uint32_t i = 0; i < contacts.size(); ++i) {
        if (i > 0 && contacts[i - 1].a == contacts[i].a && contacts[i - 1].b == contacts[i].b) {
            ++pairs_.back().contacts;
            pairs_.back().pressed |= contacts[i].pressed;
            continue;
        }
        const std::uint32_t level = order == Order::any ? first_level(contacts[i]) : next_level(contacts[i]);
        pairs_.push_back({level, contacts[i].pressed, 1, i});
    }
}

void ContactOrder::sort_pairs() {
    // Within a level, pairs with equally many contacts go side by side, because a pack has the rows of its longest
    // pair; so do pairs that probably stay unloaded, whose friction need not be solved.
    constexpr std::uint32_t lengths = 8;
    const auto rank = [&](const Pair& pair) {
        return (2 * pair.level + (pair.pressed ? 0 : 1)) * lengths + lengths - std::min(pair.contacts, lengths);
    };
    std::uint32_t ranks = 0;
    for (const Pair& pair : pairs_) ranks = std::max(ranks, rank(pair) + 1);
    // resize() grows geometrically, so a count that rises one by one seldom allocates.
    start_.resize(std::max<std::size_t>(start_.size(), ranks + 1));
    std::fill(start_.begin(), start_.end(), 0U);
    for (const Pair& pair : pairs_) ++start_[rank(pair) + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    sorted_.resize(pairs_.size());
    for (const Pair& pair : pairs_) sorted_[start_[rank(pair)]++] = pair;
}

void ContactOrder::add_pack(std::span<const Contact> contacts, std::span<const Pair> pairs, std::uint32_t width,
                            std::uint32_t before) {
    const std::uint32_t turns = pairs.size() > width ? 2 : 1;
    const std::uint32_t first_row = packs_.empty() ? 0 : packs_.back().end_row;
    const std::size_t first_slot = pack_slots_.size();
    std::uint32_t most = 0;
    pack_slots_.resize(first_slot + 2 * width * turns, spare_);
    for (std::uint32_t i = 0; i < pairs.size(); ++i) {
        const auto [level, pressed, count, first] = pairs[i];
        const std::uint32_t turn = i / width;
        std::uint32_t* const slots = &pack_slots_[first_slot + 2 * width * turn + i % width];
        slots[0] = contacts[first].a;
        slots[width] = contacts[first].b;
        for (std::uint32_t k = 0; k < count; ++k) row_slots_[first + k] = (first_row + k * turns) * width + i;
        most = std::max(most, count);
    }
    packs_.push_back({turns, first_row, first_row + most * turns, before % sum_columns});
}

void ContactOrder::lay_out(std::span<const Contact> contacts, std::uint32_t spare, int width, int turns, Order order) {
    FLOES_EXPECTS(width >= 1 && turns >= 1);
    spare_ = spare;
    find_pairs(contacts, order);
    sort_pairs();
    const auto lanes = static_cast<std::uint32_t>(width);
    const auto most = static_cast<std::size_t>(width * turns);
    row_slots_.resize(contacts.size());
    pack_slots_.clear();
    packs_.clear();
    std::uint32_t before = 0;  // pairs of the level
    for (std::size_t first = 0, end = 0; first < sorted_.size(); first = end) {
        while (end < sorted_.size() && end < first + most && sorted_[end].level == sorted_[first].level) ++end;
        add_pack(contacts, {&sorted_[first], end - first}, lanes, before);
        const bool goes_on = end < sorted_.size() && sorted_[end].level == sorted_[first].level;
        before = goes_on ? before + static_cast<std::uint32_t>(end - first) : 0;
    }
}

void fill_points(AlignedArray<double>& points, std::span<const SolverContact> contacts, const ContactOrder& order,
                 int lanes) {
    const auto width = static_cast<std::size_t>(lanes);
    points.reserve(order.rows() * width * point_field::count);
    std::array<double, point_field::count> none{};
    none[point_field::normal + 2] = 1;
    none[point_field::distance] = std::numeric_limits<double>::infinity();
    none[point_field::section] = -1;
    double* group = points.data();
    for (std::size_t row = 0; row < order.rows(); ++row) {
        for (const double value : none) group = std::fill_n(group, width, value);
    }
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const SolverContact& contact = contacts[i];
        double* at = points.data() + place(order.slot(i), point_field::count, 0, lanes);
        for (std::size_t k = 0; k < 3; ++k) {
            at[(point_field::on_a + k) * width] = contact.on_a[k];
            at[(point_field::on_b + k) * width] = contact.on_b[k];
            at[(point_field::normal + k) * width] = contact.normal[k];
        }
        at[point_field::distance * width] = contact.distance;
        at[point_field::friction * width] = contact.friction;
        at[point_field::impulse * width] = contact.impulse;
        at[point_field::section * width] = contact.section;
        at[point_field::section_growth * width] = contact.section_growth;
    }
}

void fill_friction_start(AlignedArray<double>& start, std::span<const SolverContact> contacts,
                         const ContactOrder& order, int lanes) {
    constexpr int fields = 3;
    const auto width = static_cast<std::size_t>(lanes);
    start.reserve(order.rows() * width * fields);
    std::fill_n(start.data(), order.rows() * width * fields, 0.0);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        double* at = start.data() + place(order.slot(i), fields, 0, lanes);
        for (std::size_t k = 0; k < 3; ++k) at[k * width] = contacts[i].slide[k] * contacts[i].friction_impulse;
    }
}

void set_friction(SolverContact& contact, const std::array<double, 3>& impulse) {
    const double size = std::sqrt(impulse[0] * impulse[0] + impulse[1] * impulse[1] + impulse[2] * impulse[2]);
    contact.friction_impulse = size;
    for (std::size_t k = 0; k < 3; ++k) contact.slide[k] = size > 0 ? impulse[k] / size : 0;
}

}  // namespace floes
