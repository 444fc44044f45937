#include "hydro/hydrostatic_file.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "hydro/rows.hpp"

namespace floes {

namespace {

constexpr std::size_t of_wamit = 3;
constexpr std::size_t of_nemoh = 6;

/// WAMIT writes all elements, people those that are not zero: each motion that floats has one.
void refuse_gaps(const std::array<std::array<bool, 6>, 6>& given, const std::string& file) {
    int count = 0;
    for (const auto& row : given)
        for (const bool one : row) count += one ? 1 : 0;
    constexpr int half = 21;
    constexpr int all = 36;
    for (std::size_t k = 2; k < 5; ++k)
        if (!given.at(k).at(k))
            throw InputError("{}: has no row {} {}, and heave, roll and pitch have one each; was one lost?", file,
                             k + 1, k + 1);
    if (count > half && count < all)
        throw InputError("{}: has {} of the {} elements of a matrix; was a row lost?", file, count, all);
}

}  // namespace

bool is_hydrostatic(std::string_view text) {
    for (const std::string_view line : lines_of(text))
        if (const std::optional<std::vector<double>> row = numbers_of(line); row && !row->empty())
            return row->size() == of_wamit || row->size() == of_nemoh;
    return false;
}

Mat6 read_hydrostatics(std::string_view text, const std::string& file, const WamitUnits& units, double gravity) {
    constexpr std::string_view form =
        "a row of WAMIT's .hst is i, j and the stiffness, one of NEMOH's KH.dat six of them";
    Mat6 found = Mat6::Zero();
    std::array<std::array<bool, 6>, 6> given{};
    GivenOnce<std::pair<int, int>, double> once;
    bool any = false;  // rows of WAMIT
    int rows_of_nemoh = 0;
    for_each_row(text, file, form, [&](const std::vector<double>& row, std::size_t number, const auto& wrong) {
        for (const double value : row)
            if (!std::isfinite(value)) throw wrong("has a number that is not finite");
        if (row.size() == of_nemoh && rows_of_nemoh < 6 && !any) {
            for (int j = 0; j < 6; ++j) found(rows_of_nemoh, j) = row[static_cast<std::size_t>(j)];
            ++rows_of_nemoh;
            return;
        }
        if (row.size() == of_nemoh && !any) throw wrong("is a seventh row");
        if (row.size() != of_wamit || rows_of_nemoh > 0) throw wrong("has {} numbers", row.size());
        const auto [a, b] = motions_in(row[0], row[1], "first two columns", wrong);
        if (const auto other = once.other_line({a, b}, row[2], number))
            throw wrong("gives the element {} {} another value than line {}", a + 1, b + 1, *other);
        any = true;
        given.at(static_cast<std::size_t>(a)).at(static_cast<std::size_t>(b)) = true;
        found(a, b) = row[2] * units.density * gravity * std::pow(units.length, 2 + turns_of(a, b));  // ρgL^k
    });
    if (rows_of_nemoh > 0 && rows_of_nemoh < 6)
        throw InputError("{}: has {} of six rows; was the file cut off?", file, rows_of_nemoh);
    if (rows_of_nemoh == 0) refuse_gaps(given, file);
    if (!(found(2, 2) > 0))
        throw InputError(
            "{}: has no stiffness in heave, which every hull in the waterline has; did the program write it?", file);
    return found;
}

}  // namespace floes
