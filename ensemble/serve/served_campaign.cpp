#include "serve/served_campaign.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "campaign_file/read.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "keys/key.hpp"
#include "member/quantity.hpp"
#include "run/calibrate.hpp"
#include "run/link.hpp"
#include "run/run_campaign.hpp"
#include "statistics/load_statistics.hpp"
#include "store/journal.hpp"

namespace floes {

namespace {

constexpr std::size_t digits_of_a_name = 16;

ModelError failed(const std::string& sentence) {
    return {ModelError::Kind::invalid_output, sentence};
}

ModelError invalid_point(const InputError& error) {
    return {ModelError::Kind::invalid_input, error.what()};
}

double middle(const ModelInput& input) {
    const double half = input.from + (input.to - input.from) / 2;
    return input.whole ? std::floor(half) : half;
}

/// Arrangements of the campaign that the file's journal belongs to; 0 where there is none.
int kept_arrangements(const std::filesystem::path& file) {
    const std::filesystem::path journal = journal_path(file);
    if (!std::filesystem::exists(journal)) return 0;
    try {
        return read_stored_campaign(read_journal(journal), journal).arrangements;
    } catch (const std::exception&) {
        return 0;  // whether the run can go on from it is decided when it is opened
    }
}

/// The members of the first `arrangements`; none where the file does not say how all of them ended.
std::optional<std::vector<MemberRow>> kept_members(const std::filesystem::path& file, int arrangements) {
    if (!std::filesystem::exists(file)) return std::nullopt;
    std::vector<MemberRow> rows = read_campaign_file(CampaignFile(file)).members;
    const auto count = static_cast<std::size_t>(arrangements);
    if (rows.size() < count) return std::nullopt;
    rows.resize(count);
    const bool all = std::ranges::none_of(rows, [](const MemberRow& row) { return row.status == RowStatus::missing; });
    return all ? std::optional(std::move(rows)) : std::nullopt;
}

/// Of one case: a row an arrangement.
std::vector<MemberRow> members_of(const std::filesystem::path& file, int arrangements) {
    std::vector<MemberRow> rows = read_campaign_file(CampaignFile(file)).members;
    rows.resize(std::min(rows.size(), static_cast<std::size_t>(arrangements)));  // a stop rule may have ended it sooner
    return rows;
}

ModelAnswer means(const std::vector<MemberRow>& rows, const std::vector<std::string>& outputs,
                  const std::filesystem::path& file) {
    const auto bad = std::ranges::find_if(rows, [](const MemberRow& row) { return !row.done(); });
    if (bad != rows.end())
        return failed(
            fmt::format("{} of {} failed, the first with: {} floes status {} shows all reasons; remove that "
                        "file, and its journal, to have them computed again",
                        std::ranges::count_if(rows, [](const MemberRow& row) { return !row.done(); }),
                        counted(std::ssize(rows), "member"), bad->reason, shell_word(file.string())));
    ModelValues answer;
    for (const std::string& output : outputs) {
        const Quantity quantity = any_quantity(output).value();
        std::vector<double> values;
        for (const MemberRow& row : rows) values.push_back(row.value(quantity));
        const double mean = mean_of(values);
        if (!std::isfinite(mean))
            return failed(fmt::format("{} was not measured in every member of {}", output, file.string()));
        answer.means.push_back(mean);
        answer.standard_errors.push_back(population_sd(values, mean) / std::sqrt(static_cast<double>(rows.size()) - 1));
    }
    return answer;
}

/// The names of the [[case]]s; of a design without any there are none.
std::vector<std::string> given_cases_of(const Campaign& campaign) {
    std::vector<std::string> names;
    for (const Case& one : campaign.cases) {
        const std::string& name = campaign.design.active() ? one.base : one.name;
        if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
    return names;
}

/// Returns the exit status of the run. Throws ModelError where the ice of the point cannot be calibrated.
int compute(Campaign& campaign, const std::filesystem::path& file, const ServingCores& cores, std::mutex& publishing) {
    std::filesystem::create_directories(file.parent_path());
    LocalLink link;
    RunOptions options{.places = {.campaign_file = file, .existing = Existing::resume, .publishing = &publishing},
                       .threads = cores.pool.threads(),
                       .resume_command = "ask again",
                       .cores = {&cores.pool, cores.turn}};
    Progress progress(cores.progress, cores.alone ? style_of_standard_error() : Progress::Style::plain,
                      cores.alone ? "floes" : fmt::format("floes: {}", file.stem().string()));
    const std::vector<CalibrationRecord> kept = kept_calibrations(options.places);
    try {
        cores.pool.execute(cores.turn, [&] {
            options.places.calibrations = calibrate_campaign(campaign, kept, 1, progress);
            settle_moduli(campaign, 1, progress);
        });
    } catch (const InputError& error) {
        throw invalid_point(error);
    }
    return run_campaign(campaign, options, link, cores.compute, progress, cores.helper);
}

}  // namespace

FilesInUse::Hold::Hold(FilesInUse& files, std::filesystem::path file) : files_(files), file_(std::move(file)) {
    std::unique_lock lock(files_.mutex_);
    files_.left_.wait(lock, [&] { return !files_.files_.contains(file_); });
    files_.files_.insert(file_);
}

FilesInUse::Hold::~Hold() {
    const std::scoped_lock lock(files_.mutex_);
    files_.files_.erase(file_);
    files_.left_.notify_all();
}

ServedCampaign::ServedCampaign(ReadCampaign read, const Campaign& whole, std::vector<ModelInput> inputs,
                               Options options)
    : read_(std::move(read)), inputs_(std::move(inputs)), options_(std::move(options)) {
    const std::vector<std::string> names = given_cases_of(whole);
    if (options_.case_name.empty() && names.size() > 1)
        throw InputError(fmt::format("one case is served, and this campaign has several; name it with --case: {}",
                                     name_list(names)));
    if (options_.case_name.empty() && !names.empty()) options_.case_name = names.front();
    if (!options_.case_name.empty() && std::ranges::find(names, options_.case_name) == names.end())
        throw InputError(
            names.empty() ? fmt::format("there is no case {}; the campaign has no [[case]], so leave --case out",
                                        options_.case_name)
                          : fmt::format("there is no case {}; the cases are {}", options_.case_name, name_list(names)));
    stop_rule_of(in_the_middle());
}

/// For the case alone, since another one may set the same key itself.
std::string ServedCampaign::set(const ModelInput& input, double value) const {
    constexpr double exact = 1LL << 53;  // beyond it no case has a key; it is refused as it was given
    const std::string number = input.whole && std::abs(value) <= exact
                                   ? fmt::format("{}", static_cast<std::int64_t>(value))
                                   : number_literal(value);
    const std::string of_case = options_.case_name.empty() ? "" : fmt::format("case.{}.", options_.case_name);
    return fmt::format("{}{}={}", of_case, input.key, number);
}

Campaign ServedCampaign::campaign_with(std::vector<std::string> overrides) const {
    Campaign campaign = read_(overrides);
    if (!options_.case_name.empty())
        std::erase_if(campaign.cases, [&](const Case& one) { return one.name != options_.case_name; });
    if (campaign.cases.size() != 1)
        throw InputError(
            "the cases of this configuration are the points of a design, written out; serve the configuration that has "
            "the [[design.axis]] blocks");
    campaign.run.base_case.clear();  // there is nothing left to compare with
    return campaign;
}

Campaign ServedCampaign::in_the_middle() const {
    std::vector<std::string> overrides;
    for (const ModelInput& input : inputs_)
        if (input.bounded()) overrides.push_back(set(input, middle(input)));
    return campaign_with(std::move(overrides));
}

Campaign ServedCampaign::at(const ModelQuestion& question) const {
    std::vector<std::string> overrides;
    for (std::size_t i = 0; i < inputs_.size(); ++i) overrides.push_back(set(inputs_[i], question.values.at(i)));
    if (question.arrangements) overrides.push_back(fmt::format("campaign.arrangements={}", *question.arrangements));
    if (question.seed) overrides.push_back(fmt::format("campaign.seed={}", *question.seed));
    return campaign_with(std::move(overrides));
}

std::filesystem::path ServedCampaign::file_of(const Campaign& campaign) const {
    Campaign one = campaign;
    one.arrangements = 1;
    return options_.folder /
           fmt::format("{}-{}.h5", in_a_file_name(campaign.name), fingerprint(one).substr(0, digits_of_a_name));
}

/// Throws what reading and computing throw.
ModelAnswer ServedCampaign::answer_from(const std::filesystem::path& file, Campaign& campaign,
                                        const std::vector<std::string>& outputs, const ServingCores& cores) const {
    const FilesInUse::Hold hold(files_, file);  // another number of arrangements has the same file
    const int asked = campaign.arrangements;
    const auto alone = [&](const auto& read) {
        const std::scoped_lock lock(files_.reading_or_writing);
        return read();
    };
    if (const auto rows = alone([&] { return kept_members(file, asked); })) return means(*rows, outputs, file);
    // What is kept is never made less: a campaign that has more is finished, and its first arrangements are taken.
    campaign.arrangements = std::max(asked, kept_arrangements(file));
    if (compute(campaign, file, cores, files_.reading_or_writing) == exit_stopped)
        return ModelError(ModelError::Kind::unavailable, "The server was stopped; what it has computed is kept");
    return means(alone([&] { return members_of(file, asked); }), outputs, file);
}

ModelAnswer ServedCampaign::answer(const ModelQuestion& question, const std::vector<std::string>& outputs,
                                   const ServingCores& cores) const {
    std::filesystem::path file;
    try {
        Campaign campaign = at(question);
        file = file_of(campaign);
        return answer_from(file, campaign, outputs, cores);
    } catch (const ModelError& error) {
        return error;
    } catch (const InputError& error) {
        if (file.empty()) return invalid_point(error);
        return failed(error.what());
    } catch (const std::exception& error) {
        return failed(error.what());
    }
}

}  // namespace floes
