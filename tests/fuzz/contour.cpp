// The ice of an environmental contour: distributions or regimes in TOML, or a scatter diagram, whose text begins with
// #csv.

#include <cmath>

#include "fuzz/fuzz.hpp"
#include "match/contour_section.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using floes::fuzz::require;
    constexpr std::string_view mark = "#csv\n";
    std::string_view text = floes::fuzz::as_text(data, size);
    const bool table = text.starts_with(mark);
    if (table) text.remove_prefix(mark.size());
    const auto ice =
        floes::fuzz::taken([&] { return floes::read_contour_inputs(text, table ? "ice.csv" : "ice.toml"); });
    if (!ice) return 0;
    require(ice->keys[0] != ice->keys[1] && !ice->keys[0].empty(), "the inputs are not two");
    require(std::isfinite(ice->time) && ice->time > 0, "the ice has no hours");
    require(ice->inputs.one.valid(0), "the first input has no distribution");
    for (const floes::ContourPoint& point : floes::contour(ice->inputs, 3, 8))
        require(!std::isnan(point.value[0]), "a point is not a number");
    return 0;
}
