#include "hydro/radiation_tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "hydro/rows.hpp"

namespace floes {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double turn = 2 * std::numbers::pi;

struct Matrices {
    Mat6 added = Mat6::Constant(nan);
    Mat6 damping = Mat6::Constant(nan);
};

/// What one of a pair of halves has the other gets; what neither has is zero by symmetry.
int mirror(Mat6& matrix) {
    int mirrored = 0;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            if (!std::isnan(matrix(i, j)) || std::isnan(matrix(j, i))) continue;
            matrix(i, j) = matrix(j, i);
            ++mirrored;
        }
    }
    matrix = matrix.array().isNaN().select(0.0, matrix);
    return mirrored;
}

using Periods = std::map<double, Matrices>;  // below 0: the limit of zero frequency; 0: that of infinite frequency

std::string period_name(double period) {
    return period < 0    ? "the limit of zero frequency"
           : period == 0 ? "the limit of infinite frequency"
                         : fmt::format("the period {:.6g} s", period);
}

/// What stands at one period or limit stands at all; what stands at none is zero by symmetry. A motion that moves with
/// another has an element of its own.
void refuse_gaps(const Periods& periods, const std::string& file) {
    const auto stands = [&](int i, int j) {
        return std::ranges::count_if(periods, [&](const auto& one) { return !std::isnan(one.second.added(i, j)); });
    };
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            const auto count = stands(i, j);
            if (count == 0) continue;
            for (const auto& [period, block] : periods)
                if (std::isnan(block.added(i, j)))
                    throw InputError(
                        "{}: {} lacks the element {} {}, which {} of {} periods and limits have; was a row lost? What "
                        "is zero by symmetry is missing at all of them",
                        file, period_name(period), i + 1, j + 1, count, periods.size());
            for (const int own : {i, j})
                if (stands(own, own) == 0)
                    throw InputError("{}: has the element {} {} and nowhere {} {}; were rows lost?", file, i + 1, j + 1,
                                     own + 1, own + 1);
        }
    }
}

int elements_of(const Matrices& block) {
    return static_cast<int>((!block.added.array().isNaN()).count());
}

/// Of a table's frequencies, which may be periods.
struct FrequencyUnit {
    std::string name = "rad/s";
    double factor = 1;
    bool period = false;

    double in_rad_s(double value) const { return period ? turn / value : factor * value; }
};

/// By the head of the first column: "w (rad/s)", "f (Hz)", "T (s)".
FrequencyUnit unit_of(std::string_view header, const std::string& file, std::size_t number) {
    const std::size_t open = header.find('(');
    const std::size_t close = header.find(')', std::min(open, header.size()));
    const std::string unit(close == std::string_view::npos ? "" : header.substr(open + 1, close - open - 1));
    if (unit == "rad/s") return {.name = unit};
    if (unit == "Hz") return {.name = unit, .factor = turn};
    if (unit == "s") return {.name = unit, .period = true};
    throw InputError("{}:{}: {}; its frequencies are to be in (rad/s), (Hz) or (s)", file, number,
                     unit.empty() ? "names no unit" : fmt::format("has the unit ({})", unit));
}

/// The number behind a word in the head of a zone, Zone t="Motion of body   1 in DoF   1",I=  26,F=POINT; 0 if none.
int number_behind(std::string_view word, std::string_view head) {
    const std::size_t at = head.find(word);
    if (at == std::string_view::npos) return 0;
    const std::string_view rest = head.substr(at + word.size());
    const std::vector<std::string> words = words_of(rest.substr(0, rest.find_first_of(",\"")));
    return words.empty() ? 0 : static_cast<int>(number_of(words.front()).value_or(0));
}

class NemohZones {
  public:
    NemohZones(std::string_view text, std::string file) : file_(std::move(file)) {
        std::size_t number = 0;
        for (const std::string_view line : lines_of(text)) {
            ++number;
            if (line.find("VARIABLES") != std::string_view::npos) unit_ = unit_of(line, file_, number);
            const bool zone =
                line.find("Zone") != std::string_view::npos || line.find("ZONE") != std::string_view::npos;
            if (zone) {
                begin_zone(line, number);
            } else if (const std::optional<std::vector<double>> row = numbers_of(line); row && !row->empty()) {
                add(*row, number);
            } else if (moves_ > 0 && !row && !is_title(line)) {
                throw wrong(number, "has a word that is no number");
            }
        }
        end_zone();
        if (moves_ != 6)
            throw InputError("{}: has {} of the six zones, one for each motion; was the file cut off?", file_, moves_);
    }

    const std::map<double, Matrices>& blocks() const { return blocks_; }
    const std::string& unit() const { return unit_.name; }

  private:
    template <class... Values>
    InputError wrong(std::size_t number, fmt::format_string<Values...> what, Values&&... values) const {
        return InputError(
            "{}:{}: {}; a row of NEMOH's radiation coefficients is the frequency and an added mass and a damping for "
            "each of six forces",
            file_, number, fmt::format(what, std::forward<Values>(values)...));
    }

    void add(const std::vector<double>& row, std::size_t number) {
        if (moves_ == 0 || moves_ > 6) throw wrong(number, "is outside the zones of six motions");
        if (row.size() != 13) throw wrong(number, "has {} numbers", row.size());
        for (const double value : row)
            if (!std::isfinite(value))
                throw wrong(number, "has a number that is not finite, as at very low frequencies");
        if (!(row.front() > 0)) throw wrong(number, "has {:g} ({}), not above 0", row.front(), unit_.name);
        if (const auto other = once_.other_line({moves_, row.front()}, row, number))
            throw wrong(number, "gives {:g} ({}) other values than line {} of the same zone", row.front(), unit_.name,
                        *other);
        Matrices& block = blocks_[unit_.in_rad_s(row.front())];
        rows_ += std::isnan(block.added(0, moves_ - 1)) ? 1 : 0;
        for (int force = 0; force < 6; ++force) {
            block.added(force, moves_ - 1) = row[static_cast<std::size_t>(1 + 2 * force)];
            block.damping(force, moves_ - 1) = row[static_cast<std::size_t>(2 + 2 * force)];
        }
    }

    void begin_zone(std::string_view head, std::size_t number) {
        end_zone();
        ++moves_;
        stated_ = number_behind(",I=", head);
        if (number_behind("body", head) > 1)
            throw wrong(number, "is of a second body, and one body of six motions is read");
        const int motion = number_behind("DoF", head);
        if (motion > 0 && motion != moves_)
            throw wrong(number, "is the zone of motion {}, and that of motion {} is due", motion, moves_);
    }

    void end_zone() {
        if (stated_ > 0 && stated_ != rows_)
            throw InputError("{}: zone {} has {} rows, and its head says {}; were some lost?", file_, moves_, rows_,
                             stated_);
        rows_ = 0;
    }

    std::string file_;
    FrequencyUnit unit_{};
    int moves_ = 0;   ///< zones so far
    int rows_ = 0;    ///< of this zone
    int stated_ = 0;  ///< rows by its head
    GivenOnce<std::pair<int, double>, std::vector<double>> once_{};
    std::map<double, Matrices> blocks_{};
};

}  // namespace

bool is_nemoh(std::string_view bytes) {
    return bytes.substr(0, 4096).find("VARIABLES") != std::string_view::npos;
}

RadiationFile read_wamit(std::string_view text, const std::string& file, const WamitUnits& units) {
    constexpr std::string_view form =
        "a row of WAMIT's .1 is period, i, j, added mass and, but for the limits, damping";
    Periods periods;
    GivenOnce<std::tuple<double, int, int>, std::vector<double>> once;
    for_each_row(text, file, form, [&](const std::vector<double>& row, std::size_t number, const auto& wrong) {
        const bool limit = row.front() <= 0;
        if (row.size() != (limit ? 4U : 5U) && !(limit && row.size() == 5)) throw wrong("has {} numbers", row.size());
        for (const double value : row)
            if (!std::isfinite(value)) throw wrong("has a number that is not finite, as at very low frequencies");
        const auto [a, b] = motions_in(row[1], row[2], "second and third column", wrong);
        const double period = row.front() < 0 ? -1.0 : row.front();
        if (const auto other = once.other_line({period, a, b}, row, number))
            throw wrong("gives the element {} {} of {} other values than line {}", a + 1, b + 1, period_name(period),
                        *other);
        Matrices& block = periods[period];
        const double scale = units.density * std::pow(units.length, 3 + turns_of(a, b));  // ρL^k
        block.added(a, b) = row[3] * scale;
        if (!limit) block.damping(a, b) = row[4] * scale * turn / period;
    });
    RadiationFile found;
    refuse_gaps(periods, file);
    for (auto& [period, block] : periods) {
        if (period > 0) found.elements = elements_of(block);
        const int mirrored = mirror(block.added);
        mirror(block.damping);
        if (period < 0)
            found.at_zero = block.added;
        else if (period == 0)
            found.at_infinity = block.added;
        else
            found.points.push_back({turn / period, block.added, block.damping});
        if (period > 0) found.mirrored = mirrored;
    }
    found.elements += found.mirrored;
    std::ranges::reverse(found.points);  // of rising frequencies
    return found;
}

RadiationFile read_nemoh(std::string_view text, const std::string& file) {
    refuse_cut_number(text, file);
    const NemohZones zones(text, file);
    RadiationFile found;
    found.elements = 36;
    for (const auto& [frequency, block] : zones.blocks()) {
        if (block.added.hasNaN())
            throw InputError(
                "{}: has {:.6g} rad/s, a period of {:.6g} s, in some of its six zones and not in all; was a row lost?",
                file, frequency, turn / frequency);
        found.points.push_back({frequency, block.added, block.damping});
    }
    found.remarks.push_back(fmt::format("{}: its frequencies are in {}", file, zones.unit()));
    return found;
}

}  // namespace floes
