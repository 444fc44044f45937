// The verb `design`, from a campaign file on the disk to standard output.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "cli/given.hpp"
#include "cli/verb_output.hpp"
#include "core/error.hpp"
#include "findings/evidence.hpp"
#include "findings/moored.hpp"
#include "simulation/record.hpp"
#include "support/published.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace design_test {

using testing::HasSubstr;

/// The file of a campaign in whose first two cases a hull of 0.5 s can swing; `histories`: it has those.
void publish_long(const std::filesystem::path& file, bool histories) {
    Campaign campaign = synthetic::campaign();
    for (Case& one : campaign.cases) one.scenario.analysis.keep_history = histories;
    for (const std::size_t index : {0u, 1u}) {
        campaign.cases[index].scenario.structure.speed = 1.1;  // or the hull meets the field's end
        campaign.cases[index].scenario.analysis.window = 3;
    }
    std::vector<MemberRecord> records = synthetic::records(campaign);
    if (!histories)
        for (MemberRecord& record : records) record.result.history = {};
    synthetic::publish(file, campaign, records);
}

constexpr int no_load = 1;  ///< exit status where no case has a design load

class Design : public testing::Test {
  protected:
    Design() { synthetic::publish(file_); }

    std::string design(const std::string& arguments, int status = 0) {
        const auto [output, ended] = verb_answer(add_design, words_of("design " + file_.string() + " " + arguments));
        EXPECT_EQ(ended, status) << arguments;
        return output;
    }

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "synthetic.h5";
};

// Members of the synthetic campaign have one to three peaks.
TEST_F(Design, SaysWhereThereAreTooFewPeaks) {
    EXPECT_THAT(design("--averaging-s 0.4", no_load), HasSubstr("open: too few peaks ("));
    EXPECT_THAT(design("--averaging-s 0.4", no_load), HasSubstr(" arrangements would do."));
    EXPECT_THAT(design("--averaging-s 0.4", no_load), testing::StartsWith("! 1 of 12 members failed"));
    EXPECT_THAT(design("--averaging-s 0.4", no_load), testing::Not(HasSubstr("nan")));
}

// Whoever reads the answer by a program finds a row for what was asked, not none.
TEST_F(Design, GivesProgramsTheReasonInThePlaceOfALoad) {
    const std::string asked = "--averaging-s 0.4 --quantile 0.5,0.9 --format ";
    const auto rows = nlohmann::json::parse(design(asked + "json", no_load)).at("design").at("loads");
    EXPECT_EQ(rows.size(), 3u * 3);  // cases; expected load and two quantiles
    for (const auto& row : rows) {
        EXPECT_TRUE(row.at("load").is_null()) << row;
        EXPECT_THAT(row.at("reason").get<std::string>(),
                    HasSubstr(row.at("case") == "stiff" ? "2 of the 4 arrangements" : "too few peaks ("));
    }
    EXPECT_THAT(design(asked + "csv", no_load), HasSubstr(",,,,too few peaks ("));
}

TEST_F(Design, RefusesWhatItCannotAnswer) {
    EXPECT_THAT(refusal([&] { design("--averaging-s 33"); }),
                HasSubstr("The members did not average the load over 33 s"));
    EXPECT_THROW(design("--exposure-h -1"), CommandLineEnd);
    EXPECT_THROW(design("--quantile 1"), CommandLineEnd);
    EXPECT_THROW(design("--scale 0.5"), CommandLineEnd);
}

// 0.5 s: 25 values, and a sixth of the window of two cases; that of the third is too short.
constexpr const char* hull = "--mooring-kN-m 1000 --mass-t 6.333 --damping-percent 30 ";

TEST_F(Design, MovesAMooredHull) {
    publish_long(file_, true);
    const std::string told = design(hull, no_load);
    EXPECT_THAT(told, HasSubstr("Design mooring force: the largest k x in 3 h"));
    EXPECT_THAT(told, HasSubstr("Moored hull: 1000 kN/m, 6.333 t, 30 % of the critical damping; natural period 0.5 s"));
    EXPECT_THAT(told,
                HasSubstr("open: not answered: the natural period of 0.5 s is longer than a third of the window"));
    const nlohmann::json json = nlohmann::json::parse(design(std::string(hull) + "--format json", no_load));
    const nlohmann::json& soft = json.at("moored").at("cases").at(0);
    EXPECT_EQ(soft.at("case"), "soft");
    EXPECT_EQ(soft.at("runs"), 4);
    EXPECT_GT(soft.at("largest_force"), 0);
    EXPECT_EQ(json.at("moored").at("cases").size(), 2u);
}

TEST_F(Design, RefusesAHullThatItCannotMove) {
    EXPECT_THROW(design("--mooring-kN-m 1000"), CommandLineEnd);
    EXPECT_THROW(design("--mass-t 3 --damping-percent 20"), CommandLineEnd);
    EXPECT_THROW(design(std::string(hull) + "--regimes year.toml"), CommandLineEnd);
    EXPECT_THAT(refusal([&] { design("--mooring-kN-m 0 --mass-t 2 --damping-percent 20"); }), HasSubstr("above 0"));
    EXPECT_THAT(refusal([&] { design("--mooring-kN-m 1 --mass-t 2280 --damping-percent 20"); }),
                HasSubstr("longer than a third of the window"));
}

TEST_F(Design, SaysWhichKeyStoresTheHistoriesThatAHullNeeds) {
    publish_long(file_, false);
    EXPECT_THAT(refusal([&] { design(hull); }), HasSubstr("analysis.history_steps"));
}

/// The first case on springs of a period of 1 s, whose members swing by 10, 20, … N about 100 N; with a line that
/// broke in the first member.
void publish_moored(const std::filesystem::path& file, double sideways = 0, double turret = 0, bool responses = true) {
    Campaign campaign = synthetic::campaign();
    campaign.cases.resize(1);
    Scenario& scenario = campaign.cases.front().scenario;
    scenario.structure.speed = 0.55;
    scenario.analysis.window = 6;
    scenario.analysis.peak_separation = 0.1;
    const double k = 1e5 * 4 * std::numbers::pi * std::numbers::pi;
    scenario.moorings = {.mass = 1e5, .gyration = 0.4, .surge = k, .sway = k, .yaw = 0.16 * k};
    if (turret != 0) {
        scenario.moorings.surge = scenario.moorings.sway = 0.9 * k;
        scenario.moorings.yaw = 0.144 * k;
        scenario.moorings.turret.curve = {{0, 0}, {10, 1e-6 * k}};
        scenario.moorings.turret.ahead = turret;
    }
    std::vector<MemberRecord> records = synthetic::records(campaign);
    double swing = 0;
    for (MemberRecord& record : records) {
        swing += 10;
        MotionHistory& motion = record.result.motion;
        for (int step = 0; step < scenario.step_count(); ++step) {
            for (const auto& one : motion_histories) (motion.*one.values).push_back(0);
            const double time = (step + 0.5) * scenario.general.time_step;
            const double phase = std::sin(2 * std::numbers::pi * time);
            motion.surge_mooring.back() = 100 + swing * phase;
            motion.surge_offset.back() = 0.5 + 1e-3 * swing * phase;
            motion.yaw.back() = -1e-3 * swing * std::abs(phase);
            motion.sway_mooring.back() = -sideways * motion.surge_mooring.back();
            motion.sway_offset.back() = sideways * motion.surge_offset.back();
        }
        if (responses) record.result.responses = responses_of(scenario, motion);
    }
    records.front().result.moored.broken_lines = 1;
    synthetic::publish(file, campaign, records);
}

// A hull whose swings are a period apart has a peak in each, six in 6 s, the ends apart.
TEST_F(Design, ExtrapolatesTheMooringForceOfAHullThatGivesWay) {
    publish_moored(file_);
    const Evidence evidence = read_evidence(CampaignFile(file_));
    const std::vector<CasePeaks> peaks = simulated_peaks(evidence, design_ofs.at(1));
    ASSERT_EQ(peaks.size(), 1u);
    EXPECT_NEAR(peaks[0].measured.separation, 1, 1e-12);
    EXPECT_NEAR(peaks[0].measured.mean, 100, 0.2);
    ASSERT_EQ(peaks[0].rows.size(), evidence.table.members.size());
    for (std::size_t row = 0; row < peaks[0].rows.size(); ++row) {
        const std::vector<double>& found = peaks[0].rows[row].peaks;
        EXPECT_GE(found.size(), 5u);
        EXPECT_LE(found.size(), 6u);
        EXPECT_NEAR(found.front(), 100 + 10 * static_cast<double>(row + 1), 0.01 * 10 * static_cast<double>(row + 1));
    }
    const std::string told = design("--of mooring_force", no_load);
    EXPECT_THAT(
        told, HasSubstr("Design mooring force: the largest horizontal resultant of springs, lines and turret in 3 h"));
    EXPECT_THAT(told, HasSubstr("! soft: lines broke in 1 of 4 members"));
    EXPECT_THAT(told, HasSubstr("Structures that give way in the simulation"));
}

// Three along and four across are five; a hull that turns about its turret takes its axis aside, not the turret.
TEST_F(Design, TakesTheResultantAndThePlaceOfTheTurret) {
    const auto largest = [&](std::string_view word) {
        const Evidence evidence = read_evidence(CampaignFile(file_));
        return simulated_peaks(evidence, *find_design_of(word)).at(0).rows.at(1).peaks.front();
    };
    publish_moored(file_, 4.0 / 3);
    EXPECT_NEAR(largest("mooring_force"), 5.0 / 3 * largest("surge_mooring"), 1e-6);
    EXPECT_NEAR(largest("sway_mooring"), 4.0 / 3 * largest("surge_mooring"), 1e-6);
    EXPECT_NEAR(largest("offset"), 5.0 / 3 * largest("surge_offset"), 1e-9);
    EXPECT_THAT(design("--of mooring_force", no_load), HasSubstr("the same, horizontal resultant"));
    std::filesystem::remove(file_);
    publish_moored(file_, 0, 100);  // yaws by 0.02 at the largest offset of 0.52, to port: the turret goes 2 m aside
    EXPECT_NEAR(largest("surge_offset"), 0.52, 1e-3);
    EXPECT_NEAR(largest("offset"), std::hypot(0.52 + 100 * (1 - std::cos(0.02)), 100 * std::sin(0.02)), 5e-3);
}

// Offsets are lengths, which grow with the scale; angles are turned either way, told in degrees and stored in radians.
TEST_F(Design, ExtrapolatesMotionsInTheirOwnUnits) {
    publish_moored(file_);
    const Evidence evidence = read_evidence(CampaignFile(file_));
    const auto peaks_of = [&](std::string_view word) { return simulated_peaks(evidence, *find_design_of(word)).at(0); };
    EXPECT_NEAR(peaks_of("surge_offset").measured.mean, 0.5, 1e-3);
    EXPECT_NEAR(peaks_of("surge_offset").rows.at(1).peaks.front(), 0.52, 1e-3);
    EXPECT_NEAR(peaks_of("yaw").rows.at(1).peaks.front(), 0.02, 1e-3);
    EXPECT_THAT(
        design("--of surge_offset --scale 9", no_load),
        HasSubstr("Design offset along the tow: the largest offset of the hull's axis along the surge load in 3 h"));
    DesignLoadRequest request{.scale = 9};
    for (const auto& [word, factor] : {std::pair("load", 729.0), {"surge_offset", 9.0}, {"yaw", 1.0}}) {
        request.of = *find_design_of(word);
        EXPECT_DOUBLE_EQ(request.factor(), factor) << word;
    }
    const std::string told = design("--of yaw --format json", no_load);
    const auto rows = nlohmann::json::parse(told).at("design").at("loads");
    EXPECT_TRUE(rows.at(0).at("yaw").is_null());  // four members of six peaks are too few to fit
    EXPECT_THAT(refusal([&] { design("--of yaw --averaging-s 3"); }), HasSubstr("--averaging-s is of the load"));
    EXPECT_THAT(refusal([&] { design("--of heave"); }),
                testing::AllOf(HasSubstr("Design heave: no case gives way in heave"), HasSubstr("moorings.free")));
}

TEST_F(Design, WritesEveryAnswerAsAPageOrAWorkbook) {
    publish_moored(file_);
    const std::string page = file_.string() + ".html";
    design("--of surge_offset -o " + page, no_load);
    EXPECT_THAT(read_text(page), testing::AllOf(HasSubstr("Design values"), HasSubstr("--of surge_offset"),
                                                HasSubstr("axis along the surge load")));
    const std::string book = file_.string() + ".xlsx";
    design("--averaging-s 0.4 -o " + book, no_load);
    EXPECT_GT(std::filesystem::file_size(book), 1000u);
    EXPECT_THAT(refusal([&] { design("-o curve.svg"); }), HasSubstr("with --regimes"));
}

// Measured anew from the histories, in the last third of the window.
TEST_F(Design, MeasuresResponsesInAnotherWindow) {
    publish_moored(file_);
    const CampaignFile file(file_);
    CampaignTable table = read_campaign_file(file);
    std::vector<Analysis> windows;
    for (const CaseRow& one : table.cases) windows.push_back(one.analysis);
    for (Analysis& one : windows) {
        one.steady_start += one.window * 2 / 3;
        one.window /= 3;
        one.segments = 1;
    }
    const DesignOf& force = *find_design_of("mooring_force");
    const auto peaks = [&](const CampaignTable& of) { return response_of(of.members.front(), force)->peaks; };
    const CampaignTable anew = measured_anew(file, table, windows);
    EXPECT_GE(peaks(table).size(), 5u);
    EXPECT_LE(peaks(anew).size(), 3u);
    EXPECT_NEAR(peaks(anew).front(), peaks(table).front(), 1e-9);
    EXPECT_EQ(response_of(anew.members.front(), force)->segment_maximum.size(), 1u);
    const MooredResponse& moored = anew.members.front().moored;  // two whole swings; the table has none of it
    EXPECT_NEAR(moored.surge_offset.mean, 0.5, 1e-6);
    EXPECT_NEAR(moored.surge_mooring.sd, 10 / std::numbers::sqrt2, 1e-6);
    EXPECT_NEAR(moored.mean_maximum, 110, 0.1);
    EXPECT_EQ(moored.broken_lines, 1);
}

TEST_F(Design, SaysThatOldFilesHaveNoResponses) {
    publish_moored(file_, 0, 0, false);
    EXPECT_THAT(refusal([&] { design("--of offset"); }),
                testing::AllOf(HasSubstr("Design offset: no member has it"), HasSubstr("run them again")));
}

TEST_F(Design, RefusesTheMooringForceOfAFixedHull) {
    EXPECT_THAT(refusal([&] { design("--of mooring_force"); }), HasSubstr("moorings.mass_t"));
    EXPECT_THROW(design(std::string(hull) + "--of mooring_force"), CommandLineEnd);
    EXPECT_THAT(refusal([&] { design("--of mooring_force --regimes year.toml"); }),
                HasSubstr("are of the ice load alone, and --of mooring_force is not"));
}

}  // namespace design_test
}  // namespace floes
