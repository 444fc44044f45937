// Keys of the tables [sizes], [spread], [brine]: floes that differ.

#include "scenario/tables.hpp"

namespace floes {
namespace {

RowsField size_rows(Sizes& sizes) {
    const Range side = above(0).at_most(1000);
    return {{{"length_m", unit::one, side},
             {"breadth_m", unit::one, side},
             {"share_percent", unit::percent, above(0).at_most(100)}},
            [&sizes] {
                std::vector<std::vector<double>> rows;
                for (const ListedSize& one : sizes.list) rows.push_back({one.length, one.breadth, one.share});
                return rows;
            },
            [&sizes](const std::vector<std::vector<double>>& rows) {
                sizes.list.clear();
                for (const std::vector<double>& row : rows) sizes.list.push_back({row[0], row[1], row[2]});
            }};
}

/// The three keys of one property; paths and settings are literals because keys keep no words of their own.
struct SpreadWords {
    std::string_view law, cov, within, given, doc, source, why_cov;
};

void add_property(Keys& keys, Spread& spread, const SpreadWords& words) {
    const auto in_force = [&spread] { return spread.any(); };
    keys.push_back(late_key(word_key(words.law, spread.law, {"none", "normal", "lognormal", "weibull", "uniform"},
                                     words.source, words.doc)));
    keys.push_back(late_key(only_with(
        words.given, in_force,
        number_key(words.cov, spread.cov, unit::one, at_least(0.001).at_most(1), words.why_cov,
                   "Standard deviation over mean of the law before it is cut off; the mean is what [ice] or [brine] "
                   "says."))));
    keys.push_back(
        late_key(only_with(words.given, in_force,
                           numbers_key(words.within, spread.within, unit::one, at_least(0.001).at_most(100),
                                       "3.75 default standard deviations or more",
                                       "Least and largest factor on the mean, at which the law is cut off."))));
}

}  // namespace

void add_sizes(Keys& keys, Sizes& sizes) {
    const Range size = above(0).at_most(1000);
    const auto law_is = [&sizes](auto... laws) { return [&sizes, laws...] { return ((sizes.law == laws) || ...); }; };
    const auto drawn = [&](Key key) {
        return late_key(only_with("sizes.law = \"lognormal\" or \"power_law\"",
                                  law_is(SizeLaw::lognormal, SizeLaw::power_law), std::move(key)));
    };
    const auto lognormal = [&](Key key) {
        return late_key(only_with("sizes.law = \"lognormal\"", law_is(SizeLaw::lognormal), std::move(key)));
    };
    const auto mixed = [&](Key key) {
        return late_key(only_with("a sizes.law other than \"one\"",
                                  law_is(SizeLaw::list, SizeLaw::lognormal, SizeLaw::power_law), std::move(key)));
    };
    keys.push_back(late_key(
        word_key("sizes.law", sizes.law, {"one", "list", "lognormal", "power_law"}, "the paper: one size",
                 "Sizes of the floes, docs/sea_ice.md. one: all as [floe] says. list: those of list_m in their shares. "
                 "lognormal and power_law: spread evenly over the law, from smallest_m to largest_m, so that every "
                 "arrangement has the same floes and covers the same area. Sides are rounded to whole elements.")));
    keys.push_back(mixed(word_key("sizes.by", sizes.by, {"number", "area"}, "as densities of floes are published",
                                  "What the shares, or the density, of the law are of: the number of floes, or the "
                                  "area that floes of a size cover.")));
    keys.push_back(late_key(
        only_with("sizes.law = \"list\"", law_is(SizeLaw::list),
                  {"sizes.list_m", size_rows(sizes), "none",
                   "Sizes with their shares, which sum to 100 %: [[length_m, breadth_m, share_percent], ...]."})));
    keys.push_back(drawn(number_key("sizes.smallest_m", sizes.smallest, unit::one, size, "two elements of Table 1",
                                    "Least D, the side of the square with the floe's area.")));
    keys.push_back(drawn(
        number_key("sizes.largest_m", sizes.largest, unit::one, size, "twice the floe of Table 1", "Largest D.")));
    keys.push_back(lognormal(
        number_key("sizes.mean_m", sizes.mean, unit::one, size, "Table 1", "Mean D of the law before it is cut off.")));
    keys.push_back(
        lognormal(number_key("sizes.cov", sizes.cov, unit::one, at_least(0.001).at_most(2), "an example; give your own",
                             "Standard deviation of D over its mean before the law is cut off.")));
    keys.push_back(late_key(only_with(
        "sizes.law = \"power_law\"", law_is(SizeLaw::power_law),
        number_key("sizes.exponent", sizes.exponent, unit::one, at_least(0).at_most(10), "docs/sea_ice.md",
                   "The density of floes (or of area, with by = \"area\") is in proportion to D^-exponent. Natural "
                   "floes have some 2.3 to 3.1 by number."))));
    keys.push_back(drawn(number_key("sizes.ratio_lowest", sizes.least_ratio, unit::one, at_least(1).at_most(20),
                                    "squares", "Least length over breadth of a floe.")));
    keys.push_back(
        drawn(number_key("sizes.ratio_highest", sizes.largest_ratio, unit::one, at_least(1).at_most(20), "squares",
                         "Largest length over breadth; ratios are spread evenly between the two, whatever "
                         "the size.")));
    keys.push_back(mixed(word_key(
        "sizes.element", sizes.element, {"given", "of_floe", "of_ice"}, "Table 1: one element",
        "Side of the elements. given: floe.element_m. of_floe: the floe's shorter side over elements_across. of_ice: "
        "element_share of the characteristic length that a sheet of [ice] has on water.")));
    keys.push_back(late_key(only_with(
        "sizes.element = \"of_floe\"", [&sizes] { return sizes.element == ElementSide::of_floe; },
        integer_key("sizes.elements_across", sizes.elements_across, 1, 1000, "Table 1: 0.6 m by 0.2 m",
                    "Elements along the shorter side of every floe. A large floe then has few large elements."))));
    keys.push_back(late_key(only_with(
        "sizes.element = \"of_ice\"", [&sizes] { return sizes.element == ElementSide::of_ice; },
        number_key("sizes.element_share", sizes.element_share, unit::one, at_least(0.001).at_most(10),
                   "in the range of docs/fracture.md",
                   "Side of the elements over the characteristic length of the ice; well below 1, or elements are "
                   "too large to show where ice bends."))));
}

void add_spread(Keys& keys, IceSpread& spread) {
    add_property(keys, spread.thickness,
                 {"spread.thickness", "spread.thickness_cov", "spread.thickness_within",
                  "a spread.thickness other than \"none\"",
                  "Law of the floes' thicknesses about ice.thickness_m. Each floe has one draw, from a stream of its "
                  "own: it changes neither the arrangement nor any other draw.",
                  "the paper: one thickness", "an example; give your own"});
    add_property(
        keys, spread.strength,
        {"spread.strength", "spread.strength_cov", "spread.strength_within", "a spread.strength other than \"none\"",
         "Law of the floes' strengths: one factor on all strengths of [ice] together.", "the paper: one strength",
         "0.2 to 0.3: docs/sea_ice.md, from memory"});
    add_property(keys, spread.elastic_modulus,
                 {"spread.elastic_modulus", "spread.elastic_modulus_cov", "spread.elastic_modulus_within",
                  "a spread.elastic_modulus other than \"none\"",
                  "Law of the floes' moduli about ice.elastic_modulus_MPa, with joint.model = \"beam\".",
                  "the paper: one modulus", "an example; give your own"});
    add_property(keys, spread.density,
                 {"spread.density", "spread.density_cov", "spread.density_within",
                  "a spread.density other than \"none\"", "Law of the floes' densities about ice.density_kg_m3.",
                  "the paper: one density", "an example; give your own"});
    add_property(
        keys, spread.salinity,
        {"spread.salinity", "spread.salinity_cov", "spread.salinity_within", "a spread.salinity other than \"none\"",
         "Law of the floes' salinities about brine.salinity_ppt.", "none", "an example; give your own"});
    add_property(keys, spread.temperature,
                 {"spread.temperature", "spread.temperature_cov", "spread.temperature_within",
                  "a spread.temperature other than \"none\"",
                  "Law of the floes' temperatures about brine.temperature_C: a factor on degrees below 0.", "none",
                  "an example; give your own"});
    keys.push_back(late_key(only_with(
        "spread.thickness and spread.strength", [&spread] { return spread.thickness.any() && spread.strength.any(); },
        number_key("spread.correlation", spread.correlation, unit::one, at_least(-1).at_most(1), "independent",
                   "Correlation ρ of thickness and strength: of the two normal variables behind them (Gaussian "
                   "copula). Their ranks then correlate by 6/π asin(ρ/2)."))));
    keys.push_back(late_key(number_key(
        "spread.weakened_percent", spread.weakened, unit::percent, at_least(0).at_most(100), "the paper: none",
        "Share of the floes that are weaker than the others, as floes that were cut, thawed or cracked before. Each "
        "floe has one draw, from a stream of its own.")));
    keys.push_back(late_key(only_with(
        "spread.weakened_percent > 0", [&spread] { return spread.weakened > 0; },
        number_key("spread.weakened_to", spread.weakened_to, unit::one, above(0).at_most(1),
                   "an example: measure yours", "Factor on all strengths of the weaker floes."))));
    keys.push_back(late_key(only_with(
        "a law in [spread]", [&spread] { return spread.any(); },
        integer_key("spread.draw", spread.draw, 0, 1'000'000, "the first",
                    "Number of the draw. Cases that differ in it alone have the same floes in the same places, of "
                    "other ice: what of the scatter is the ice's."))));
}

void add_brine(Keys& keys, Brine& brine) {
    keys.push_back(late_key(number_key(
        "brine.salinity_ppt", brine.salinity, 1e-3, at_least(0).at_most(35), "none: [ice] says the strengths",
        "Salinity of the ice. Above 0 bending strength and modulus follow from it and the temperature (docs/sea_ice.md)"
        ", and the other strengths keep their ratios to ice.bending_strength_kPa. At full scale only.")));
    keys.push_back(late_key(only_with(
        "brine.salinity_ppt > 0", [&brine] { return brine.salinity > 0; },
        number_key("brine.temperature_C", brine.temperature, unit::one, at_least(-22.9).at_most(-0.5),
                   "docs/sea_ice.md", "Temperature of the ice, within what its formula is for."))));
}

}  // namespace floes
