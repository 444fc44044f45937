// Measured figures: [[target]].

#include <cmath>

#include "fuzz/fuzz.hpp"
#include "match/waves.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using floes::fuzz::require;
    const auto targets =
        floes::fuzz::taken([&] { return floes::read_targets(floes::fuzz::as_text(data, size), "targets.toml"); });
    if (!targets) return 0;
    require(!targets->empty(), "no targets were taken");
    for (const floes::Target& one : *targets) {
        require(!one.name().empty(), "a target has no name");
        require(std::isfinite(one.value), "a value is not finite");
        require(std::isfinite(one.uncertainty) && one.uncertainty >= 0, "an uncertainty is not finite, or below 0");
        require(std::isfinite(one.discrepancy) && one.discrepancy >= 0, "a discrepancy is not finite, or below 0");
        require(one.runs >= 1, "a target has no runs");
        if (one.quantity.positive) require(one.value > 0, "a value is not above 0");
        require(one.quantity.positive || (one.value >= one.quantity.least && one.value <= one.quantity.most),
                "a value is none that the quantity can have");
    }
    return 0;
}
