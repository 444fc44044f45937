#include "serve/served_campaign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <atomic>
#include <condition_variable>
#include <csignal>
#include <fstream>
#include <mutex>
#include <sstream>
#include <thread>

#include "core/error.hpp"
#include "run/signals.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace served_campaign_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

double mean_of(const ModelAnswer& answer) {
    if (const auto* error = std::get_if<ModelError>(&answer)) ADD_FAILURE() << error->what();
    return std::holds_alternative<ModelValues>(answer) ? std::get<ModelValues>(answer).means.at(0) : 0;
}

/// The case "soft" of the synthetic campaign; 2 arrangements of which number k has the mean load 100 (k + 1) + 0.1,
/// more in thicker ice.
class Served {
  public:
    explicit Served(std::filesystem::path kept, std::string case_name = "soft")
        : folder(std::move(kept)),
          campaign([](const auto& overrides) { return read(overrides); }, read({}), {{"ice.thickness_m", 0.02, 0.05}},
                   {std::move(case_name), folder}) {}

    static Campaign read(const std::vector<std::string>& overrides) {
        return read_campaign({write_campaign(synthetic::campaign(2)), "synthetic.toml", overrides}, nullptr);
    }

    MemberResult compute(const Campaign& of, int number, const std::stop_token& stop) {
        ++computed;
        if (stopped_by_a_member) {
            if (!raised_.exchange(true)) std::raise(SIGTERM);
            while (!stop.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        if (meeting > 0) meet();
        if (of.cases.size() != 1) throw std::logic_error("more than one case is computed");
        MemberResult result = synthetic::record(of, number).result;
        result.load.mean += 1000 * (of.cases.front().scenario.floe.thickness - 0.03) + static_cast<double>(of.seed) - 7;
        if (number == failing) throw MemberFailure("an element ran away");
        return result;
    }

    ModelAnswer answer(const ModelQuestion& question, const std::vector<std::string>& outputs = {"mean_load"},
                       std::int64_t turn = 0) {
        std::ostringstream said;
        return campaign.answer(
            question, outputs,
            {[this](const Campaign& of, int number, const std::stop_token& stop) { return compute(of, number, stop); },
             pool, turn, nullptr, said});
    }

    /// Each in a thread of its own.
    std::vector<ModelAnswer> answer_at_once(const std::vector<ModelQuestion>& questions) {
        std::vector<ModelAnswer> answers(questions.size());
        std::vector<std::jthread> threads;
        for (std::size_t k = 0; k < questions.size(); ++k)
            threads.emplace_back(
                [&, k] { answers[k] = answer(questions[k], {"mean_load"}, static_cast<std::int64_t>(k)); });
        threads.clear();
        return answers;
    }

    double mean(const ModelQuestion& question) { return mean_of(answer(question)); }

    ModelError refusal(const ModelQuestion& question) { return std::get<ModelError>(answer(question)); }

    std::filesystem::path folder;
    ServedCampaign campaign;
    CorePool pool{2};
    std::atomic<int> computed = 0;
    int failing = -1;
    int meeting = 0;  ///< of members, each of which waits until so many are being computed; 0: none waits
    bool stopped_by_a_member = false;  ///< the first raises SIGTERM, and all end once they are told to stop

  private:
    void meet() {
        std::unique_lock lock(mutex_);
        ++came_;
        changed_.notify_all();
        if (!changed_.wait_for(lock, std::chrono::seconds(20), [this] { return came_ >= meeting; }))
            throw MemberFailure("nobody else came");
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    int came_ = 0;
    std::atomic<bool> raised_ = false;
};

/// The same in a folder of its own.
class ServedAside : public TemporaryFolder, public Served {
  public:
    ServedAside() : Served(*this / "kept") {}
};

TEST(ServedCampaign, AnswersWithMeansAndTheirStandardErrors) {
    ServedAside served;
    const auto values = std::get<ModelValues>(served.answer({{0.04}, 3}, {"mean_load", "mean_maximum_0.4s"}));
    EXPECT_DOUBLE_EQ(values.means.at(0), 200.1 + 10);                      // of 100.1, 200.1 and 300.1
    EXPECT_DOUBLE_EQ(values.standard_errors.at(0), 100 / std::sqrt(3.0));  // their sample deviation is 100
    EXPECT_EQ(values.means.size(), 2u);
    EXPECT_EQ(values.standard_errors.size(), 2u);
    EXPECT_TRUE(std::isnan(std::get<ModelValues>(served.answer({{0.04}, 1})).standard_errors.at(0)));
}

TEST(ServedCampaign, RefusesAWholeNumberThatNoKeyHoldsAsItWasGiven) {
    const ServedCampaign campaign([](const auto& overrides) { return Served::read(overrides); }, Served::read({}),
                                  {{.key = "general.iterations", .whole = true}}, {"soft", "kept"});
    EXPECT_EQ(campaign.at({{8}}).cases.front().scenario.general.iterations, 8);
    for (const auto& [value, words] : {std::pair{1e300, "1e+300"}, {-1e300, "-1e+300"}})
        EXPECT_THAT([&] { campaign.at({{value}}); },
                    ThrowsMessage<InputError>(HasSubstr(fmt::format("general.iterations = {}", words))));
}

TEST(ServedCampaign, TakesTheConfigurationsOwnWhereNothingElseIsAsked) {
    ServedAside served;
    EXPECT_DOUBLE_EQ(served.mean({{0.03}}), 150.1);
    EXPECT_EQ(served.computed, 2);
    EXPECT_DOUBLE_EQ(served.mean({{0.03}, {}, 9}), 152.1);  // two for the seed
    EXPECT_EQ(served.campaign.at({{0.035}, 5, 11}).arrangements, 5);
    EXPECT_EQ(served.campaign.at({{0.035}, 5, 11}).seed, 11u);
    EXPECT_EQ(served.campaign.in_the_middle().cases.front().scenario.floe.thickness, 0.035);
}

TEST(ServedCampaign, ComputesNothingTwice) {
    ServedAside served;
    served.mean({{0.03}, 3});
    EXPECT_EQ(served.computed, 3);
    served.mean({{0.03}, 3});
    EXPECT_EQ(served.computed, 3);
    EXPECT_DOUBLE_EQ(served.mean({{0.03}, 5}), 300.1);
    EXPECT_EQ(served.computed, 5);                      // two more
    EXPECT_DOUBLE_EQ(served.mean({{0.03}, 2}), 150.1);  // of the first two
    EXPECT_EQ(served.computed, 5);
    served.mean({{0.04}, 2});
    EXPECT_EQ(served.computed, 7);

    Served again(served / "kept");  // another day
    EXPECT_DOUBLE_EQ(again.mean({{0.03}, 4}), 250.1);
    EXPECT_EQ(again.computed, 0);
}

TEST(ServedCampaign, GoesOnWithWhatIsKeptOfMore) {
    ServedAside served;
    served.mean({{0.03}, 4});
    const std::filesystem::path file = served.campaign.file_of(served.campaign.at({{0.03}}));
    std::filesystem::remove(file);  // as if the run had been stopped before it was written
    EXPECT_DOUBLE_EQ(served.mean({{0.03}, 2}), 150.1);
    EXPECT_EQ(served.computed, 4);
    EXPECT_TRUE(std::filesystem::exists(file));
}

// As a full disk leaves it.
TEST(ServedCampaign, BeginsAPointAnewWhoseJournalIsEmpty) {
    ServedAside served;
    const std::filesystem::path file = served.campaign.file_of(served.campaign.at({{0.03}}));
    std::ofstream(std::filesystem::path(file).replace_extension(".journal")).close();
    EXPECT_DOUBLE_EQ(served.mean({{0.03}, 2}), 150.1);
}

TEST(ServedCampaign, KeepsEachPointInAFile) {
    const ServedAside served;
    const auto file = [&](const ModelQuestion& of) { return served.campaign.file_of(served.campaign.at(of)); };
    EXPECT_EQ(file({{0.03}, 2}), file({{0.03}, 9}));
    EXPECT_NE(file({{0.03}}), file({{0.03}, {}, 8}));
    EXPECT_NE(file({{0.03}}), file({{0.030000000000000002}}));
    EXPECT_THAT(file({{0.03}}).filename().string(), testing::StartsWith("synthetic-"));
}

TEST(ServedCampaign, SaysWhichMembersFailed) {
    ServedAside served;
    served.failing = 1;
    const ModelError error = served.refusal({{0.03}, 3});
    EXPECT_EQ(error.kind(), ModelError::Kind::invalid_output);
    EXPECT_THAT(error.what(), HasSubstr("1 of 3 members failed, the first with: an element ran away"));
    served.failing = -1;
    EXPECT_STREQ(served.refusal({{0.03}, 3}).what(), error.what()) << "the same question has another answer";
    EXPECT_DOUBLE_EQ(served.mean({{0.03}, 1}), 100.1);  // which does not need that member
}

TEST(ServedCampaign, SaysWhatTheConfigurationRefuses) {
    ServedAside served;
    const ModelError error = served.refusal({{-0.03}});
    EXPECT_EQ(error.kind(), ModelError::Kind::invalid_input);
    EXPECT_THAT(error.what(), HasSubstr("ice.thickness_m = -0.03"));
    EXPECT_EQ(served.refusal({{0.03}, 4'000'000'000}).kind(), ModelError::Kind::invalid_input);
    EXPECT_EQ(served.computed, 0);
}

TEST(ServedCampaign, SaysWhatIsWrongWithAFile) {
    ServedAside served;
    served.mean({{0.03}});
    std::filesystem::resize_file(served.campaign.file_of(served.campaign.at({{0.03}})), 100);
    EXPECT_EQ(served.refusal({{0.03}}).kind(), ModelError::Kind::invalid_output);
    EXPECT_NEAR(served.mean({{0.031}}), 151.1, 1e-9) << "and answers others";
}

TEST(ServedCampaign, IsUnavailableWhereASignalStopsIt) {
    ServedAside served;
    {
        const StopSignals signals;  // of the server
        std::raise(SIGTERM);
        EXPECT_EQ(served.refusal({{0.03}}).kind(), ModelError::Kind::unavailable);
        EXPECT_EQ(signals.received(), SIGTERM);
    }
    EXPECT_DOUBLE_EQ(served.mean({{0.03}}), 150.1);
}

TEST(ServedCampaign, AnswersManyAtOnceAsOneByOne) {
    const TemporaryFolder folder;
    std::vector<ModelQuestion> questions;
    for (int k = 0; k < 8; ++k) questions.push_back({{0.03 + 0.001 * k}, 1 + k % 3});
    const StopSignals signals;  // of the server
    Served together(folder / "together");
    const std::vector<ModelAnswer> answers = together.answer_at_once(questions);
    Served alone(folder / "alone");
    for (std::size_t k = 0; k < questions.size(); ++k) EXPECT_EQ(mean_of(answers[k]), alone.mean(questions[k])) << k;
    EXPECT_EQ(together.computed, 15);
    EXPECT_EQ(alone.computed, 15);
}

TEST(ServedCampaign, GivesACoreOfOnePointToAnother) {
    ServedAside served;
    served.meeting = 2;  // cores, and a point has one member
    const StopSignals signals;
    for (const ModelAnswer& answer : served.answer_at_once({{{0.03}, 1}, {{0.04}, 1}})) EXPECT_GT(mean_of(answer), 0);
}

TEST(ServedCampaign, ComputesNothingTwiceAtOnce) {
    ServedAside served;
    const StopSignals signals;
    const std::vector<ModelAnswer> answers =
        served.answer_at_once({{{0.03}, 4}, {{0.03}, 2}, {{0.03}, 4}, {{0.03}, 3}, {{0.03}, 1}});
    std::vector<double> means;
    for (const ModelAnswer& answer : answers) means.push_back(mean_of(answer));
    EXPECT_THAT(means, ElementsAre(testing::DoubleEq(250.1), testing::DoubleEq(150.1), testing::DoubleEq(250.1),
                                   testing::DoubleEq(200.1), testing::DoubleEq(100.1)));
    EXPECT_EQ(served.computed, 4);
}

TEST(ServedCampaign, KeepsAllThatASignalStops) {
    const std::vector<ModelQuestion> questions{{{0.03}, 3}, {{0.04}, 3}, {{0.05}, 3}, {{0.045}, 3}};
    ServedAside served;
    {
        const StopSignals signals;
        served.stopped_by_a_member = true;
        for (const ModelAnswer& answer : served.answer_at_once(questions)) {
            const auto* error = std::get_if<ModelError>(&answer);
            ASSERT_TRUE(error);
            EXPECT_EQ(error->kind(), ModelError::Kind::unavailable) << error->what();
        }
    }
    EXPECT_GT(served.computed, 0);
    served.stopped_by_a_member = false;
    const StopSignals signals;
    for (const ModelAnswer& answer : served.answer_at_once(questions)) EXPECT_GT(mean_of(answer), 200);
    EXPECT_EQ(served.computed, 12) << "a member was lost, or computed twice";
}

TEST(ServedCampaign, IsOfOneCase) {
    const TemporaryFolder folder;
    EXPECT_THAT(
        [&] { Served(folder / "kept", ""); },
        ThrowsMessage<InputError>("one case is served, and this campaign has several; name it with --case: soft, "
                                  "stiff, open"));
    EXPECT_THAT([&] { Served(folder / "kept", "hard"); },
                ThrowsMessage<InputError>("there is no case hard; the cases are soft, stiff, open"));
    EXPECT_EQ(Served(folder / "kept", "open").campaign.in_the_middle().cases.front().name, "open");
}

TEST(ServedCampaign, NeedsNoCaseInADesign) {
    const std::string ice = "structure = {start_m = 5}\nanalysis = {steady_start_s = 20, window_s = 9}\n";
    const std::string design =
        "[design]\nmethod = \"sobol\"\npoints = 4\n[[design.axis]]\nkey = \"ice.elastic_modulus_MPa\"\nfrom = 30\n"
        "to = 200\n";
    const auto served = [&](const std::string& cases, const std::string& name) {
        const std::string text = ice + design + cases;
        const Campaign whole = read_campaign({text, "a.toml", {}, true}, nullptr);
        return ServedCampaign(
            [text](const auto& overrides) {
                return read_campaign({text, "a.toml", overrides, true, true}, nullptr);
            },
            whole, model_inputs(whole.design, {}), {name, "kept"});
    };
    const auto modulus = [](const ServedCampaign& of) {
        return of.at({{50}}).cases.front().scenario.ice.elastic_modulus / 1e6;
    };
    EXPECT_DOUBLE_EQ(modulus(served("", "")), 50);
    EXPECT_THAT([&] { served("", "A"); }, ThrowsMessage<InputError>(HasSubstr("leave --case out")));
    const std::string two = "[[case]]\nname = \"A\"\n[[case]]\nname = \"B\"\nfloe.length_m = 1.2\n";
    EXPECT_THAT([&] { served(two, ""); }, ThrowsMessage<InputError>(HasSubstr("name it with --case: A, B")));
    EXPECT_DOUBLE_EQ(modulus(served(two, "B")), 50);
    EXPECT_EQ(served(two, "B").at({{50}}).cases.front().name, "B");
    const std::string written = "[[case]]\nname = \"A+p0\"\ndesign.base = \"A\"\ndesign.point = 0\n";
    EXPECT_THAT([&] { served(two + written, "A"); }, ThrowsMessage<InputError>(testing::_));
}

}  // namespace served_campaign_test
}  // namespace floes
