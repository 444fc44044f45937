// floes report: a complete or incomplete campaign as one HTML page.

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "cli/report_moments.hpp"
#include "cli/write_page.hpp"
#include "driver/measure_curve.hpp"
#include "page/page.hpp"

namespace floes {
namespace {

struct ReportOptions {
    std::string file;
    std::string output;
    bool skip_plate_tests = false;
    std::string pictures = "worst";
};

void report(const ReportOptions& options) {
    const std::filesystem::path file = options.file;
    const std::filesystem::path output = options.output.empty() ? file.stem().string() + ".html" : options.output;
    ReportData data{read_evidence(file), {}, ""};
    const Scenario& first = data.evidence.campaign.cases.front().scenario;
    const bool follows_cfm = first.joint.model == JointModel::cfm;  // else there is no curve: E is what it says
    if (!options.skip_plate_tests && follows_cfm) data.evidence.plate_tests = measure_curve(curve_plans(first));
    if (options.pictures != "none") add_moments(file, options.pictures == "all", data);
    data.command = fmt::format("./floes run {0}.toml -o {0}.h5", data.evidence.summary.title);
    write_page(output, report_page(std::move(data)));
    std::printf("%s\n", output.string().c_str());
}

}  // namespace

void add_report(CommandLine& line) {
    auto options = std::make_shared<ReportOptions>();
    Verb verb = line.verb("report", "Write one self-contained HTML page with the tables and figures of a campaign");
    verb.option("campaign", options->file, "The campaign file (CAMPAIGN.h5)").required();
    verb.option("-o,--output", options->output, "The page; default: CAMPAIGN.html in this folder");
    verb.flag("--no-plate-tests", options->skip_plate_tests,
              "Omit the E-Σ curve of this ice, whose plate tests take some seconds");
    verb.option("--pictures", options->pictures,
                "Pictures of the member with the largest load, which is computed again for them: worst, the one "
                "of the campaign; all, that of each case; none")
        .one_of({"none", "worst", "all"})
        .shows_default();
    verb.runs([options] {
        report(*options);
        return 0;
    });
}

}  // namespace floes
