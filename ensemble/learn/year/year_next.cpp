#include <fmt/format.h>

#include <algorithm>

#include "year/year_section.hpp"
#include "year/year_words.hpp"

namespace floes {

Section year_next(const Evidence& evidence, const Year& year, const std::string& program) {
    const YearLevel& rarest = *std::ranges::min_element(year.levels, {}, &YearLevel::per_year);
    if (rarest.uncertainty.empty())
        return {.before = "Next: nothing, because no regime has the load so often; check hours_per_year.\n"};
    const auto widest =
        static_cast<std::size_t>(std::ranges::max_element(rarest.uncertainty) - rarest.uncertainty.begin());
    const TailSource& source = year.sources[widest];
    const std::string& name = evidence.campaign.name;
    const int arrangements = 2 * std::max(evidence.campaign.arrangements, static_cast<int>(source.arrangements));
    return {
        .before = fmt::format(
            "Next: {} wants more members: it has {} of the uncertainty of the load of {} a year.\n  {} run {}.toml -o "
            "{} --set campaign.arrangements={} --resume\nThis doubles the arrangements of all cases; what is done is "
            "not computed again. Give every --set of the first run as well.\n",
            source.words(), percent_of(rarest.uncertainty[widest]), per_year_text(rarest.per_year), program, name,
            evidence.file.string(), arrangements)};
}

}  // namespace floes
