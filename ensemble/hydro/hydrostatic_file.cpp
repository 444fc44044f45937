#include "hydro/hydrostatic_file.hpp"

#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "hydro/rows.hpp"

namespace floes {

namespace {

constexpr std::size_t of_wamit = 3;
constexpr std::size_t of_nemoh = 6;

}  // namespace

bool is_hydrostatic(std::string_view text) {
    for (const std::string_view line : lines_of(text))
        if (const std::optional<std::vector<double>> row = numbers_of(line); row && !row->empty())
            return row->size() == of_wamit || row->size() == of_nemoh;
    return false;
}

Mat6 read_hydrostatics(std::string_view text, const std::string& file, const WamitUnits& units, double gravity) {
    Mat6 found = Mat6::Zero();
    int rows_of_nemoh = 0;
    int number = 0;
    for (const std::string_view line : lines_of(text)) {
        ++number;
        const auto wrong = [&](const std::string& what) {
            return InputError(fmt::format(
                "{}:{}: {}; a row of WAMIT's .hst is i, j and the stiffness, one of NEMOH's KH.dat six of them", file,
                number, what));
        };
        const std::optional<std::vector<double>> row = numbers_of(line);
        if (row && row->empty()) continue;
        if (!row && number == 1) continue;  // a title
        if (!row) throw wrong("has a word that is no number");
        for (const double value : *row)
            if (!std::isfinite(value)) throw wrong("has a number that is not finite");
        if (row->size() == of_nemoh && rows_of_nemoh < 6) {
            for (int j = 0; j < 6; ++j) found(rows_of_nemoh, j) = (*row)[static_cast<std::size_t>(j)];
            ++rows_of_nemoh;
            continue;
        }
        if (row->size() != of_wamit || rows_of_nemoh > 0) throw wrong(fmt::format("has {} numbers", row->size()));
        const double i = (*row)[0];
        const double j = (*row)[1];
        if (i != std::floor(i) || j != std::floor(j) || i < 1 || j < 1)
            throw wrong("has something other than numbers of motions in its first two columns");
        if (i > 6 || j > 6) throw wrong("is of a second body, and one body of six motions is read");
        const int a = static_cast<int>(i) - 1;
        const int b = static_cast<int>(j) - 1;
        found(a, b) = (*row)[2] * units.density * gravity * std::pow(units.length, 2 + turns_of(a, b));  // ρgL^k
    }
    if (rows_of_nemoh > 0 && rows_of_nemoh < 6)
        throw InputError(fmt::format("{}: has {} of six rows; was the file cut off?", file, rows_of_nemoh));
    if (!(found(2, 2) > 0))
        throw InputError(fmt::format(
            "{}: has no stiffness in heave, which every hull in the waterline has; did the program write it?", file));
    return found;
}

}  // namespace floes
