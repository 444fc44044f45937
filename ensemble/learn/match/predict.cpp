#include "match/predict.hpp"

#include <fmt/format.h>

#include <limits>

#include "core/error.hpp"

namespace floes {

Target to_predict(const std::string& quantity, const std::string& case_name) {
    const std::optional<Quantity> known = any_quantity(quantity);
    if (!known)
        throw InputError(fmt::format(
            "--predict {} is no quantity of a member; floes summarize --format json names them.", quantity));
    Target target;
    target.quantity = *known;
    target.case_name = case_name;
    target.value = std::numeric_limits<double>::quiet_NaN();
    target.held_out = true;
    return target;
}

Predicted predict(const OverLeft& left, const EmulatedTarget& quantity) {
    const AtPoints mean = left.emulated(quantity);
    AtPoints run = mean;
    for (std::size_t k = 0; k < run.variance.size(); ++k)
        run.variance[k] += quantity.scatter(left.points().row(static_cast<Eigen::Index>(k)).transpose());
    const Quantity& about = quantity.target().quantity;
    return {about,
            quantity.target().case_name,
            left.even(mean, about.least, about.most),
            left.weighed(mean, about.least, about.most),
            left.weighed(run, about.least, about.most),
            left.effective()};
}

Cell range_cell(const PredictedRange& range, double factor) {
    return {fmt::format("{:.4g}", factor * range.mean),
            fmt::format("[{:.4g}, {:.4g}]", factor * range.low, factor * range.high)};
}

Section predicted_section(const std::vector<Predicted>& predicted) {
    Section section{.title = "Predicted over what is not ruled out"};
    section.table = {{"quantity", "mean of runs", "weighed", "a single run"}};
    for (const Predicted& one : predicted) {
        const double factor = one.quantity.factor();
        section.table.push_back(
            {fmt::format("{}{}{}", one.case_name, one.case_name.empty() ? "" : " ", one.quantity.label),
             range_cell(one.mean, factor), range_cell(one.weighted, factor), range_cell(one.run, factor)});
    }
    section.after =
        "\nIn brackets 95 %. Mean of runs: every combination of inputs that is left counts the same; weighed: by the "
        "likelihood of the targets, normal and independent of each other. A single run adds the scatter.\n";
    const auto of = [](PredictedRange Predicted::*range, double PredictedRange::*field) {
        return [range, field](const Predicted& one) { return one.*range.*field; };
    };
    section.records = {
        make_rows<Predicted>("match/predicted", predicted,
                             {{"quantity", [](const Predicted& one) { return std::string(one.quantity.key.view()); }},
                              {"case", &Predicted::case_name},
                              {"mean", of(&Predicted::mean, &PredictedRange::mean)},
                              {"mean_low", of(&Predicted::mean, &PredictedRange::low)},
                              {"mean_high", of(&Predicted::mean, &PredictedRange::high)},
                              {"weighted", of(&Predicted::weighted, &PredictedRange::mean)},
                              {"weighted_low", of(&Predicted::weighted, &PredictedRange::low)},
                              {"weighted_high", of(&Predicted::weighted, &PredictedRange::high)},
                              {"run_low", of(&Predicted::run, &PredictedRange::low)},
                              {"run_high", of(&Predicted::run, &PredictedRange::high)},
                              {"effective_points", &Predicted::effective}})};
    return section;
}

}  // namespace floes
