// Pairs as a table, JSON and CSV.

#include "findings/pairs_text.hpp"

#include <algorithm>

#include "core/units.hpp"
#include "findings/columns.hpp"
#include "findings/figures.hpp"
#include "findings/json.hpp"

namespace floes {

namespace {

const std::string& name_of(const Summary& summary, std::size_t index) {
    return summary.cases.at(index).about.name;
}

std::string needed_text(int arrangements) {
    return arrangements == 0 ? "–" : arrangements >= 1'000'000 ? ">10⁶" : fmt::format("{}", arrangements);
}

std::string percent(double part) {
    // 0.0 added: no "-0".
    return std::isfinite(part) ? fmt::format("{:.0f} %", std::round(part / unit::percent) + 0.0) : "–";
}

/// Three of Table 3's quantities say most; JSON and CSV have all.
bool in_table(std::size_t quantity) {
    const auto of = quantities[quantity].interval;
    return of == &CaseSummary::mean || of == &CaseSummary::mean_maximum || of == &CaseSummary::failure_ratio;
}

std::vector<std::string> line(const Summary& summary, const PairRow& row) {
    const bool ratio = quantities[row.quantity].interval == &CaseSummary::failure_ratio;
    const double factor = ratio ? 1 / unit::percent : 1;
    const int decimals = ratio ? 1 : decimals_for(std::abs(row.first_mean));
    const PairedComparison& found = row.found;
    return {fmt::format("  {} - {}", name_of(summary, row.second), name_of(summary, row.first)),
            fmt::format("{}", found.arrangements),
            fixed(found.difference * factor, decimals),
            bracket(found.t_interval, decimals, factor),
            percent(found.difference / row.first_mean),
            p_text(row.t_p_holm),
            p_text(row.wilcoxon_p_holm),
            percent(found.variance_saved),
            needed_text(row.to_resolve_observed),
            needed_text(row.to_resolve_wished)};
}

std::size_t all_pairs(const Summary& summary) {
    return summary.cases.size() * (summary.cases.size() - 1) / 2;
}

}  // namespace

std::string left_out_text(const Summary& summary, const std::vector<PairRow>& rows) {
    const std::size_t all = all_pairs(summary);
    const std::size_t left_out = all - rows.size() / table3_quantities.size();
    if (left_out == 0) return "";
    return fmt::format(
        "{} not compared: cases are paired over arrangements that both have done and begin from with the same floes, "
        "and {} no two of these (campaign.common_arrangements = false, or fields of another geometry).",
        left_out == all ? (all == 1 ? "The pair is" : "Pairs are") : fmt::format("{} of {} pairs are", left_out, all),
        left_out == 1 ? "it has" : "they have");
}

std::string unasked_text(const Summary& summary) {
    return fmt::format(
        "The {} pairs of these {} cases, and the extremes of each: floes summarize --parts pairs,extremes.",
        all_pairs(summary), summary.cases.size());
}

std::string pairs_table(const Summary& summary, const std::vector<PairRow>& rows, const PairOptions& options,
                        int width) {
    if (rows.empty() && summary.cases.size() < 2) return "Pairs: there is but one case.\n";
    if (rows.empty()) return left_out_text(summary, rows) + "\n";
    const std::string left_out = left_out_text(summary, rows);
    std::vector<std::vector<std::string>> lines{{"pair", "n", "difference", "95 %", "of first", "p t", "p Wilcoxon",
                                                 "saved", "n for it",
                                                 fmt::format("n for {:g} %", options.resolve / unit::percent)}};
    std::size_t last_quantity = quantities.size();
    for (const PairRow& row : rows) {
        if (!in_table(row.quantity)) continue;
        if (row.quantity != last_quantity) {
            lines.push_back(std::vector<std::string>(lines.front().size()));
            lines.back().front() = std::string{quantities[row.quantity].label};
            last_quantity = row.quantity;
        }
        lines.push_back(line(summary, row));
    }
    return "Pairs over the same arrangements\n\n" + columns(lines, width) +
           fmt::format(
               "\np: two-sided, paired t and Wilcoxon's signed ranks, Holm over the {} of a quantity. Saved: variance "
               "of the difference that\npairing took away. n for it: arrangements with which a true difference as "
               "large as the one seen, or of {:g} % of the first\ncase, is found with a probability of {:g} %.\nThe "
               "other quantities of Table 3: --format csv --parts pairs.\n",
               rows.size() / table3_quantities.size() == 1
                   ? std::string{"one pair"}
                   : fmt::format("{} pairs", rows.size() / table3_quantities.size()),
               options.resolve / unit::percent, options.power / unit::percent) +
           (left_out.empty() ? "" : left_out + "\n");
}

std::string pairs_csv(const Summary& summary, const std::vector<PairRow>& rows) {
    std::string text =
        "quantity,first,second,arrangements,difference,low,high,bca_low,bca_high,sd,t,t_p,t_p_holm,rank_sum,wilcoxon_p,"
        "wilcoxon_p_holm,wilcoxon_exact,variance_saved,to_resolve_observed,to_resolve_wished\n";
    for (const PairRow& row : rows) {
        const PairedComparison& found = row.found;
        text += fmt::format("{},{},{},{}", quantities[row.quantity].key, name_of(summary, row.first),
                            name_of(summary, row.second), found.arrangements);
        for (const double value :
             {found.difference, found.t_interval.low, found.t_interval.high, found.bca.low, found.bca.high, found.sd,
              found.t, found.t_p, row.t_p_holm, found.rank_sum, found.wilcoxon_p, row.wilcoxon_p_holm}) {
            text += "," + csv_number(value);
        }
        text += fmt::format(",{},{},{},{}\n", found.wilcoxon_exact ? 1 : 0, csv_number(found.variance_saved),
                            row.to_resolve_observed, row.to_resolve_wished);
    }
    return text;
}

Json pairs_as_json(const Summary& summary, const std::vector<PairRow>& rows, const PairOptions& options) {
    Json all = Json::array();
    for (const PairRow& row : rows) {
        const PairedComparison& found = row.found;
        const auto needed = [](int count) { return count == 0 ? Json(nullptr) : Json(count); };
        all.push_back({{"quantity", quantities[row.quantity].key},
                       {"first", name_of(summary, row.first)},
                       {"second", name_of(summary, row.second)},
                       {"arrangements", found.arrangements},
                       {"first_mean", json_number(row.first_mean)},
                       {"difference", json_number(found.difference)},
                       {"sd", json_number(found.sd)},
                       {"t_interval", json_limits(found.t_interval)},
                       {"bca", json_limits(found.bca)},
                       {"t", json_number(found.t)},
                       {"t_p", json_number(found.t_p)},
                       {"t_p_holm", json_number(row.t_p_holm)},
                       {"rank_sum", json_number(found.rank_sum)},
                       {"wilcoxon_p", json_number(found.wilcoxon_p)},
                       {"wilcoxon_p_holm", json_number(row.wilcoxon_p_holm)},
                       {"wilcoxon_exact", found.wilcoxon_exact},
                       {"variance_saved", json_number(found.variance_saved)},
                       {"power", options.power},
                       {"arrangements_for_observed", needed(row.to_resolve_observed)},
                       {"resolve", options.resolve},
                       {"arrangements_for_resolve", needed(row.to_resolve_wished)}});
    }
    return all;
}

}  // namespace floes
