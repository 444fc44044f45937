// Extremes as a table, JSON and CSV.

#include "findings/extremes_text.hpp"

#include <array>

#include "findings/columns.hpp"
#include "findings/figures.hpp"
#include "findings/json.hpp"

namespace floes {

namespace {

const std::string& name_of(const Summary& summary, const CaseExtremes& one) {
    return summary.cases.at(one.case_index).about.name;
}

std::array<const FittedExtreme*, 2> fits_of(const CaseExtremes& one) {
    return {&one.gumbel, &one.gev};
}

const char* kind_name(const FittedExtreme& fitted) {
    return fitted.kind == ExtremeKind::gumbel ? "Gumbel" : "GEV";
}

std::string hours(double seconds) {
    return seconds < 3600 ? fmt::format("{:.3g} min", seconds / 60) : fmt::format("{:.3g} h", seconds / 3600);
}

std::vector<std::string> line(const CaseExtremes& one, const FittedExtreme& fitted) {
    const int decimals = decimals_for(std::abs(fitted.fit.location));
    std::vector<std::string> cells{fmt::format("  {}", kind_name(fitted)), fixed(fitted.fit.location, decimals),
                                   fixed(fitted.fit.scale, decimals),
                                   one.gumbel.fit.valid() && &fitted == &one.gev ? fixed(fitted.fit.shape, 2) : "",
                                   p_text(fitted.goodness.anderson_darling_p)};
    for (const ReturnLevel& level : fitted.levels) {
        cells.push_back(fmt::format("{} {}", fixed(level.level, decimals), bracket(level.interval, decimals)));
    }
    return cells;
}

Json fit_json(const FittedExtreme& fitted) {
    Json levels = Json::array();
    for (const ReturnLevel& level : fitted.levels) {
        levels.push_back({{"segments", level.segments},
                          {"level_N", json_number(level.level)},
                          {"interval", json_limits(level.interval)}});
    }
    return {{"location_N", json_number(fitted.fit.location)},
            {"location_interval", json_limits(fitted.location)},
            {"scale_N", json_number(fitted.fit.scale)},
            {"scale_interval", json_limits(fitted.scale)},
            {"shape", json_number(fitted.fit.shape)},
            {"shape_interval", json_limits(fitted.shape)},
            {"log_likelihood", json_number(fitted.fit.log_likelihood)},
            {"anderson_darling", json_number(fitted.goodness.found.anderson_darling)},
            {"anderson_darling_p", json_number(fitted.goodness.anderson_darling_p)},
            {"kolmogorov_smirnov", json_number(fitted.goodness.found.kolmogorov_smirnov)},
            {"kolmogorov_smirnov_p", json_number(fitted.goodness.kolmogorov_smirnov_p)},
            {"return_levels", levels}};
}

}  // namespace

std::string extremes_table(const Summary& summary, const std::vector<CaseExtremes>& extremes, int width) {
    std::vector<std::vector<std::string>> lines{{"segment maxima, N", "location", "scale", "ξ", "p A²"}};
    for (const double period : return_periods) {
        lines.front().push_back(fmt::format("1 in {:g}", period));
    }
    std::string lengths;
    for (const CaseExtremes& one : extremes) {
        lines.push_back(std::vector<std::string>(lines.front().size()));
        lines.back().front() = fmt::format("{}, {} maxima", name_of(summary, one), one.maxima);
        if (!one.gumbel.fit.valid()) {
            lines.back().front() += ": too few to fit";
            continue;
        }
        for (const FittedExtreme* fitted : fits_of(one)) lines.push_back(line(one, *fitted));
        if (lengths.empty()) {
            lengths =
                fmt::format(" (a segment: {:g} s; 1 in 1000: once in {})", one.segment, hours(1000 * one.segment));
        }
    }
    return "Extremes\n\n" + columns(lines, width) +
           fmt::format(
               "\nMaximum likelihood; 1 in N: the load that one segment in N exceeds{}, interval by bootstrap over\n"
               "arrangements. ξ: shape, below 0 with an upper end. p A²: Anderson-Darling; small: the distribution "
               "does "
               "not suit.\nBeyond the longest exposure that was run a return level is an extrapolation.\n",
               lengths);
}

std::string extremes_csv(const Summary& summary, const std::vector<CaseExtremes>& extremes) {
    std::string text =
        "case,distribution,segment_s,maxima,location_N,location_low,location_high,scale_N,scale_low,scale_high,shape,"
        "shape_low,shape_high,log_likelihood,anderson_darling,anderson_darling_p,kolmogorov_smirnov,"
        "kolmogorov_smirnov_p";
    for (const double period : return_periods)
        text += fmt::format(",level_{0:g}_N,level_{0:g}_low,level_{0:g}_high", period);
    text += "\n";
    for (const CaseExtremes& one : extremes) {
        for (const FittedExtreme* fitted : fits_of(one)) {
            text += fmt::format("{},{},{},{}", name_of(summary, one), kind_name(*fitted), one.segment, one.maxima);
            std::vector<double> values{fitted->fit.location,
                                       fitted->location.low,
                                       fitted->location.high,
                                       fitted->fit.scale,
                                       fitted->scale.low,
                                       fitted->scale.high,
                                       fitted->fit.shape,
                                       fitted->shape.low,
                                       fitted->shape.high,
                                       fitted->fit.log_likelihood,
                                       fitted->goodness.found.anderson_darling,
                                       fitted->goodness.anderson_darling_p,
                                       fitted->goodness.found.kolmogorov_smirnov,
                                       fitted->goodness.kolmogorov_smirnov_p};
            for (const ReturnLevel& level : fitted->levels) {
                values.insert(values.end(), {level.level, level.interval.low, level.interval.high});
            }
            for (const double value : values) text += "," + csv_number(value);
            text += "\n";
        }
    }
    return text;
}

std::string exceedance_csv(const Summary& summary, const std::vector<CaseExtremes>& extremes) {
    std::string text = "case,load_N,empirical,gumbel,gev\n";
    for (const CaseExtremes& one : extremes) {
        const auto beyond = [](const ExtremeFit& fit, double load) {
            return fit.valid() ? csv_number(1 - extreme_cdf(fit, load)) : std::string{};
        };
        for (const ExceedancePoint& point : one.exceedance) {
            text += fmt::format("{},{},{},{},{}\n", name_of(summary, one), point.load, point.probability,
                                beyond(one.gumbel.fit, point.load), beyond(one.gev.fit, point.load));
        }
    }
    return text;
}

Json extremes_as_json(const Summary& summary, const std::vector<CaseExtremes>& extremes, bool exceedance) {
    Json all = Json::array();
    for (const CaseExtremes& one : extremes) {
        Json json{{"case", name_of(summary, one)},
                  {"segment_s", one.segment},
                  {"maxima", one.maxima},
                  {"gumbel", fit_json(one.gumbel)},
                  {"gev", fit_json(one.gev)}};
        if (exceedance) {
            Json& curve = json["exceedance"] = Json::array();
            for (const ExceedancePoint& point : one.exceedance) {
                curve.push_back({{"load_N", point.load}, {"probability", point.probability}});
            }
        }
        all.push_back(std::move(json));
    }
    return all;
}

}  // namespace floes
