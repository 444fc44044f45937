#include "campaign/held_numbers.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace floes {
namespace {

constexpr std::size_t most_numbers = 30'000'000;  // 240 MB

}  // namespace

void HeldNumbers::add(const Scenario& scenario) {
    for (const std::vector<double>& values : scenario.arrangement.values) numbers_ += values.size();
    for (const Outline& one : scenario.shapes.traced.outlines) numbers_ += 2 * one.size();
    numbers_ += 3 * scenario.arrangement.poses.size() + 2 * scenario.structure.shape.rows().size() +
                5 * scenario.structure.shape.piece_rows().size() + scenario.analysis.exceedance_levels.size() +
                scenario.analysis.averaging.size();
    if (numbers_ > most_numbers)
        throw InputError(fmt::format(
            "{}: poses, outlines, profiles, levels and times of all cases are more than {} numbers, which cannot be "
            "held; take fewer cases or shorter lists",
            file_, most_numbers));
}

}  // namespace floes
