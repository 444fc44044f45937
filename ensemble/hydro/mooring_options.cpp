#include "hydro/mooring_options.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "hydro/rows.hpp"

namespace floes {

namespace {

enum class Use {
    density,
    gravity,
    depth,
    friction,
    sideways_friction,  // across a line
    bottom,             // its stiffness
    static_friction,    // over that of motion
    waves,
    currents,
    seafloor,
    none,  // nothing at rest
};

/// Each name between blanks.
using Names = std::pair<Use, std::string_view>;

constexpr auto names = std::to_array<Names>({
    {Use::density, " WTRDNSTY RHO RHOW "},
    {Use::gravity, " G GRAVITY "},
    {Use::depth, " WTRDPTH WTRDEPTH DEPTH "},
    {Use::friction, " FRICTIONCOEFFICIENT MU_KA "},
    {Use::sideways_friction, " MU_KT "},
    {Use::bottom, " KBOT KB "},
    {Use::static_friction, " STATDYNFRICSCALE MC "},
    {Use::waves, " WAVEKIN WATERKIN "},
    {Use::currents, " CURRENTS "},
    {Use::seafloor, " SEAFLOORFILE "},
    // Of time steps, initial conditions, damping and outputs.
    {Use::none,
     " DTM DT CFL WRITELOG TSCHEME CBOT CB DTIC ICDT TMAXIC ICTMAX CDSCALEIC ICDFAC THRESHIC ICTHRESH ICGENDYNAMIC "
     "GENDYNAMICIC FILEIC ICFILE DTWAVE WAVEKIN_RAMPT UNIFYCURRENTGRID WRITEUNITS FRICDAMP CV DTOUT OUTSWITCH "
     "DISABLEOUTPUT DISABLEOUTTIME INERTIALF INERTIALF_RAMPT ECHO "},
});

/// Nothing for a word that is no option.
std::optional<Use> use_of(const std::string& word) {
    const std::string wanted = " " + upper(word) + " ";
    const auto found = std::ranges::find_if(
        names, [&](const Names& one) { return one.second.find(wanted) != std::string_view::npos; });
    return found == names.end() ? std::nullopt : std::optional(found->first);
}

/// Value and name in this order: of "1025 rho", and also of "rho = 1025" and "rho 1025".
MooringRow option_of(const MooringSections& file, const MooringRow& row) {
    std::string joined = fmt::format("{}", fmt::join(row.words, " "));
    std::ranges::replace(joined, '=', ' ');
    std::vector<std::string> words = words_of(joined);
    if (words.size() < 2) throw file.wrong(row, "is no option: a value and its name");
    if (use_of(words[0]) && !use_of(words[1])) std::swap(words[0], words[1]);
    return {row.line, std::move(words)};
}

/// What of an option is not modelled; nothing where floes has it as the option does.
std::string not_modelled(Use use, const std::optional<double>& value) {
    constexpr double soft = 1e5;  // Pa/m: a chain of 0.2 m that weighs 3000 N/m sinks in by 0.15 m
    const std::string still = "lines hang in still water";
    switch (use) {
        case Use::depth:
            return value ? "" : "the bottom is taken as flat at each anchor";
        case Use::seafloor:
            return "the bottom is taken as flat at each anchor";
        case Use::sideways_friction:
            return value == 0 ? "" : "lines hang in planes, without friction across them";
        case Use::bottom:
            return value >= soft ? "" : "the bottom is taken as hard";
        case Use::static_friction:
            return value == 1 ? "" : "one friction is taken, that of motion";
        case Use::waves:
        case Use::currents:
            return value == 0 ? "" : still;
        default:
            return "";
    }
}

}  // namespace

MooringFileOptions mooring_options(const MooringSections& file, double density, double gravity,
                                   std::vector<std::string>& remarks) {
    MooringFileOptions found{density, gravity};
    GivenOnce<Use, std::pair<std::optional<double>, std::string>> once;
    for (const MooringSection* section : file.all("options")) {
        for (const MooringRow& row : section->rows) {
            const MooringRow option = option_of(file, row);
            const std::string& word = option.words[0];
            const std::string& name = option.words[1];
            const std::optional<double> value = number_of(word);
            const Use use = use_of(name).value_or(Use::none);
            if (!use_of(name))
                remarks.push_back(fmt::format("{}:{}: {} is no option that floes knows, and is left out", file.file(),
                                              row.line, name));
            if (use == Use::none) continue;
            if (const auto other = once.other_line(use, {value, value ? "" : word}, row.line))
                throw file.wrong(row, "gives {} another value than line {}", name, *other);
            if (use == Use::density) found.density = file.number(option, 0, "density");
            if (use == Use::gravity) found.gravity = file.number(option, 0, "gravity");
            if (use == Use::friction) found.friction = file.number(option, 0, "friction");
            if (use == Use::depth && value) found.depth = file.number(option, 0, "depth");
            if (const std::string what = not_modelled(use, value); !what.empty())
                remarks.push_back(
                    fmt::format("{}:{}: {} {} is not modelled: {}", file.file(), row.line, name, word, what));
        }
    }
    return found;
}

}  // namespace floes
