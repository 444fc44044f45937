// FMUs of floes, opened as a host opens them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <thread>

#include "campaign/campaign.hpp"
#include "campaign/read.hpp"
#include "campaign/write.hpp"
#include "fmu/fmu_file.hpp"
#include "fmu/fmu_host.hpp"
#include "fmu/variables.hpp"
#include "member/run_member.hpp"
#include "support/file_bytes.hpp"
#include "support/refusal.hpp"

namespace floes {
namespace fmu_test {

namespace ref = fmu_reference;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// Half of the smoke channel's floes for 2.5 s, of which the hull meets ice in all.
constexpr const char* channel = R"(
[campaign]
seed = 3
arrangements = 2
[field]
floes = 12
begin_m = 2.0
half_width_m = 1.25
sheet_width_m = 1.0
[structure]
profile_m = [[-0.443, 0.43], [0.0, 0.614], [0.122, 0.736]]
start_m = 1.375
speed_m_s = 0.125
[general]
time_step_s = 0.015625
[analysis]
steady_start_s = 0.5
window_s = 2.0
segments = 1
averaging_s = [0.25]
[[case]]
name = "towed"
[[case]]
name = "slow"
structure.speed_m_s = 0.0625
[[case]]
name = "surging"
moorings.mass_t = 0.6
moorings.free = ["surge"]
moorings.surge_kN_m = 2.0
[[case]]
name = "moored"
moorings.mass_t = 0.6
moorings.gyration_m = 0.4
moorings.surge_kN_m = 2.0
moorings.sway_kN_m = 2.0
moorings.yaw_kN_m_rad = 0.3
moorings.damping_percent = 10.0
[[case]]
name = "floating"
moorings.mass_t = 0.38
moorings.free = ["surge", "sway", "yaw", "heave", "pitch", "roll"]
moorings.centre_m = -0.15
moorings.gyration_m = 0.4
moorings.gyration_pitch_m = 0.3
moorings.gyration_roll_m = 0.3
moorings.surge_kN_m = 2.0
moorings.sway_kN_m = 2.0
moorings.yaw_kN_m_rad = 0.3
)";
constexpr double dt = 0.015625;

Campaign campaign() {
    return read_campaign({.text = channel, .file = "channel.toml", .overrides = {}, .from_user = true}, nullptr);
}

int index_of(const Campaign& of, const std::string& name) {
    return static_cast<int>(&chosen_case(of, name) - of.cases.data());
}

std::string made_fmu(const std::string& case_name, HullMover mover, int version) {
    const Campaign of = campaign();
    const Scenario& scenario = chosen_case(of, case_name).scenario;
    return fmu_file({.description = {.model_name = "channel",
                                     .token = {},
                                     .program = "floes",
                                     .case_name = case_name,
                                     .arrangement = 1,
                                     .time_step = scenario.general.time_step,
                                     .stop_time = scenario.general.time_step * scenario.step_count(),
                                     .can_be_saved = true,
                                     .mover = mover},
                     .configuration = write_campaign(of),
                     .library = file_text(FLOES_FMU_LIBRARY),
                     .libraries = {},
                     .licences = {{"license.txt", "ours"}}},
                    version == 2 ? FmiVersion::two : FmiVersion::three);
}

/// The same, made once.
const std::string& fmu_of(const std::string& case_name, HullMover mover, int version) {
    static std::map<std::tuple<std::string, HullMover, int>, std::string> made;
    std::string& archive = made[{case_name, mover, version}];
    if (archive.empty()) archive = made_fmu(case_name, mover, version);
    return archive;
}

std::string description_in(const std::string& archive) {
    return unzipped(archive).at("modelDescription.xml").bytes;
}

std::string token_in(const std::string& archive) {
    std::smatch found;
    const std::string text = description_in(archive);
    if (!std::regex_search(text, found, std::regex("(guid|instantiationToken)=\"([^\"]*)\""))) return {};
    return found[2];
}

/// An FMU with one instance.
struct Hosted {
    std::string archive;
    OpenFmu fmu;
    HostedInstance one;

    Hosted(const std::string& case_name, HullMover mover, int version)
        : archive(fmu_of(case_name, mover, version)), fmu(archive, version), one(fmu, token_in(archive)) {}
};

MemberResult run_of(const std::string& case_name, std::uint32_t arrangement = 1) {
    const Campaign of = campaign();
    const int index = index_of(of, case_name);
    return run_member(of.cases[static_cast<std::size_t>(index)].scenario, arrangement_seed(of, index), arrangement);
}

/// The force along X step by step, up to a time, in steps of so many time steps.
std::vector<double> forces(HostedInstance& one, int steps, int each = 1, int from = 0) {
    std::vector<double> found;
    for (int k = from; k < from + steps; k += each) {
        if (one.step(k * dt, each * dt) != HostStatus::ok) throw std::runtime_error(one.said());
        found.push_back(one.real(ref::ice_load));
    }
    return found;
}

class Fmu : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Version, Fmu, testing::Values(2, 3), testing::PrintToStringParamName());

TEST_P(Fmu, MovesItsHullAsARunDoesToTheBit) {
    const MemberResult run = run_of("surging");
    Hosted hosted("surging", HullMover::inside, GetParam());
    ASSERT_TRUE(hosted.one.is_there());
    ASSERT_EQ(hosted.one.initialize(), HostStatus::ok) << hosted.one.said();
    double largest = 0;
    for (std::size_t k = 0; k < run.history.surge.size(); ++k) {
        ASSERT_EQ(hosted.one.step(static_cast<double>(k) * dt, dt), HostStatus::ok) << hosted.one.said();
        ASSERT_EQ(hosted.one.real(ref::ice_load), -run.history.surge[k]) << k;
        ASSERT_EQ(hosted.one.real(ref::ice_load + 1), -run.history.sway[k]) << k;
        ASSERT_EQ(hosted.one.real(ref::ice_load + 2), run.history.heave[k]) << k;
        ASSERT_EQ(hosted.one.real(ref::ice_load + 5), run.motion.yaw_load[k]) << k;
        ASSERT_EQ(hosted.one.real(ref::motion), -run.motion.surge_offset[k]) << k;
        ASSERT_EQ(hosted.one.real(ref::mooring_load), run.motion.surge_mooring[k]) << k;
        largest = std::max(largest, run.history.surge[k]);
    }
    EXPECT_GT(largest, 10);
    EXPECT_EQ(hosted.one.integer(ref::failed_joints), std::ssize(run.breaks));
    EXPECT_EQ(hosted.one.integer(ref::floes_met), static_cast<int>(run.floes_met));
}

TEST_P(Fmu, GivesTheMeanLoadOfAStep) {
    Hosted fine("moored", HullMover::inside, GetParam());
    Hosted coarse("moored", HullMover::inside, GetParam());
    fine.one.initialize(100);
    coarse.one.initialize(100);
    for (int k = 0; k < 10; ++k) {
        double sum = 0;
        for (int j = 0; j < 4; ++j) {
            ASSERT_EQ(fine.one.step(100 + (4 * k + j) * dt, dt), HostStatus::ok) << fine.one.said();
            sum += fine.one.real(ref::ice_load);
        }
        ASSERT_EQ(coarse.one.step(100 + 4 * k * dt + 1e-9, 4 * dt - 1e-9), HostStatus::ok) << coarse.one.said();
        ASSERT_EQ(coarse.one.real(ref::ice_load), sum / 4) << k;
        ASSERT_EQ(coarse.one.real(ref::motion + 5), fine.one.real(ref::motion + 5)) << k;
    }
}

// What others do before there is ice moves a hull on its springs as their equation says.
TEST_P(Fmu, FollowsTheClosedFormOfAMassOnASpring) {
    Hosted hosted("surging", HullMover::inside, GetParam());
    hosted.one.set(ref::settings, std::string("field.begin_m=2.14"));
    ASSERT_EQ(hosted.one.initialize(), HostStatus::ok) << hosted.one.said();
    const double omega = std::sqrt(2000.0 / 600);
    for (int k = 1; k <= 64; ++k) {  // until it meets the ice
        hosted.one.set(ref::force_in, -50.0);
        ASSERT_EQ(hosted.one.step((k - 1) * dt, dt), HostStatus::ok) << hosted.one.said();
        ASSERT_EQ(hosted.one.real(ref::ice_load), 0);
        EXPECT_NEAR(hosted.one.real(ref::motion), -50.0 / 2000 * (1 - std::cos(omega * k * dt)), 1e-12);
        EXPECT_NEAR(hosted.one.real(ref::velocity), -50.0 / 2000 * omega * std::sin(omega * k * dt), 1e-12);
    }
}

// Each force and moment of others moves the hull along or about its own axis, to the same side.
TEST_P(Fmu, PushesAlongItsAxes) {
    for (unsigned k = 0; k < 6; ++k) {
        Hosted hosted("floating", HullMover::inside, GetParam());
        hosted.one.set(ref::settings, std::string("field.begin_m=2.14"));
        ASSERT_EQ(hosted.one.initialize(), HostStatus::ok) << hosted.one.said();
        hosted.one.set(ref::force_in + k, 20.0);
        ASSERT_EQ(hosted.one.step(0, 4 * dt), HostStatus::ok) << hosted.one.said();
        unsigned most = 0;
        for (unsigned j = 0; j < 6; ++j)
            if (std::abs(hosted.one.real(ref::velocity + j)) > std::abs(hosted.one.real(ref::velocity + most)))
                most = j;
        EXPECT_GT(hosted.one.real(ref::motion + k), 0) << k;
        EXPECT_TRUE(most == k || k < 2) << most;  // along X and Y it turns as well: its mass lies low
    }
}

TEST(FmuVariables, AxesAndBack) {
    const Vec6 six = (Vec6() << 1, 2, 3, 4, 5, 6).finished();
    EXPECT_EQ(from_fmu_motion(to_fmu_motion(six)), six);
    EXPECT_EQ(from_fmu_axes(to_fmu_axes(Vec3(1, 2, 3))), Vec3(1, 2, 3));
    EXPECT_EQ(to_fmu_axes(Vec3(0, 1, 0)), Vec3(0, 0, 1));   // up
    EXPECT_EQ(to_fmu_axes(Vec3(0, 0, 1)), Vec3(0, -1, 0));  // to starboard
}

TEST_P(Fmu, LedAlongTheTowHasTheTowedLoadToTheBit) {
    const MemberResult run = run_of("towed");
    Hosted still("towed", HullMover::outside, GetParam());
    Hosted led("slow", HullMover::outside, GetParam());  // at half the speed; its host makes up for the rest
    ASSERT_EQ(still.one.initialize(), HostStatus::ok) << still.one.said();
    ASSERT_EQ(led.one.initialize(), HostStatus::ok) << led.one.said();
    led.one.set(ref::velocity, 0.0625);
    for (int k = 0; k < 120; ++k) {
        led.one.set(ref::motion, 0.0625 * k * dt);
        ASSERT_EQ(still.one.step(k * dt, dt), HostStatus::ok) << still.one.said();
        ASSERT_EQ(led.one.step(k * dt, dt), HostStatus::ok) << led.one.said();
        ASSERT_EQ(still.one.real(ref::ice_load), -run.history.surge[static_cast<std::size_t>(k)]) << k;
        ASSERT_EQ(led.one.real(ref::ice_load), -run.history.surge[static_cast<std::size_t>(k)]) << k;
    }
}

TEST_P(Fmu, MakesUpForTheInertiaThatItsHostAdds) {
    std::array<double, 2> loads{};
    for (const double mass : {0.0, 7.0}) {
        Hosted hosted("towed", HullMover::outside, GetParam());
        hosted.one.set(ref::added_mass, mass);
        hosted.one.initialize();
        hosted.one.set(ref::velocity, 0.25);
        hosted.one.step(0, 2 * dt);
        hosted.one.set(ref::velocity, 0.5);
        ASSERT_EQ(hosted.one.step(2 * dt, 2 * dt), HostStatus::ok) << hosted.one.said();
        loads.at(mass > 0) = hosted.one.real(ref::ice_load);
    }
    EXPECT_DOUBLE_EQ(loads[1] - loads[0], 7.0 * 0.25 / (2 * dt));
}

TEST_P(Fmu, IsSavedAndSetToTheBit) {
    for (const HullMover mover : {HullMover::inside, HullMover::outside}) {
        Hosted hosted("moored", mover, GetParam());
        hosted.one.initialize();
        forces(hosted.one, 60);
        const std::vector<char> saved = hosted.one.saved();
        const double load = hosted.one.real(ref::ice_load);
        const std::vector<double> once = forces(hosted.one, 60, 1, 60);
        ASSERT_EQ(hosted.one.set_saved(saved), HostStatus::ok) << hosted.one.said();
        EXPECT_EQ(hosted.one.real(ref::ice_load), load);
        EXPECT_EQ(forces(hosted.one, 60, 1, 60), once);
        HostedInstance other(hosted.fmu, token_in(hosted.archive));
        ASSERT_EQ(other.set_saved(saved), HostStatus::ok) << other.said();
        EXPECT_EQ(forces(other, 60, 1, 60), once);
        EXPECT_GT(*std::ranges::max_element(once, {}, [](double force) { return -force; }) * -1, 0);
        EXPECT_EQ(other.set_saved({'n', 'o'}), HostStatus::error);
    }
}

TEST_P(Fmu, IsAsNewAfterAReset) {
    Hosted hosted("moored", HullMover::inside, GetParam());
    hosted.one.set(ref::arrangement, 0);
    hosted.one.initialize();
    const std::vector<double> first = forces(hosted.one, 40);
    ASSERT_EQ(hosted.one.call("Reset"), HostStatus::ok);
    EXPECT_EQ(hosted.one.integer(ref::arrangement), 1);
    hosted.one.initialize();
    EXPECT_NE(forces(hosted.one, 40), first);
    hosted.one.call("Terminate");
    hosted.one.call("Reset");
    hosted.one.set(ref::arrangement, 0);
    hosted.one.initialize();
    EXPECT_EQ(forces(hosted.one, 40), first);
}

TEST_P(Fmu, TwoInstancesInTwoThreadsDoNotMeet) {
    Hosted hosted("moored", HullMover::inside, GetParam());
    HostedInstance other(hosted.fmu, token_in(hosted.archive));
    other.set(ref::arrangement, 0);
    hosted.one.initialize();
    other.initialize();
    std::vector<double> here;
    std::vector<double> there;
    {
        const std::jthread first([&] { here = forces(hosted.one, 60); });
        const std::jthread second([&] { there = forces(other, 60); });
    }
    HostedInstance alone(hosted.fmu, token_in(hosted.archive));
    alone.initialize();
    EXPECT_EQ(forces(alone, 60), here);
    EXPECT_NE(here, there);
}

TEST_P(Fmu, RefusesWhatIsOutOfOrder) {
    Hosted hosted("moored", HullMover::inside, GetParam());
    HostedInstance& one = hosted.one;
    EXPECT_EQ(one.step(0, dt), HostStatus::error);
    EXPECT_EQ(one.said(), "A step is out of order: the instance is instantiated.");
    EXPECT_EQ(one.call("ExitInitializationMode"), HostStatus::error);
    EXPECT_EQ(one.enter(), HostStatus::ok);
    EXPECT_EQ(one.enter(), HostStatus::error);
    EXPECT_EQ(one.set(ref::arrangement, 0), HostStatus::ok);
    EXPECT_EQ(one.call("ExitInitializationMode"), HostStatus::ok) << one.said();
    EXPECT_EQ(one.set(ref::arrangement, 1), HostStatus::error);
    EXPECT_EQ(one.said(), "arrangement is a fixed parameter; it is set before the initialization mode ends.");
    EXPECT_EQ(one.step(dt, dt), HostStatus::error);
    EXPECT_THAT(one.said(), HasSubstr("the last one ended at 0 s"));
    EXPECT_EQ(one.step(0, 1.5 * dt), HostStatus::error);
    EXPECT_THAT(one.said(), HasSubstr("is no whole number of time steps of 0.015625 s"));
    EXPECT_EQ(one.step(0, 0), HostStatus::error);
    EXPECT_EQ(one.step(0, NAN), HostStatus::error);
    EXPECT_EQ(one.step(0, dt), HostStatus::ok) << one.said();
    EXPECT_EQ(one.call("Terminate"), HostStatus::ok);
    EXPECT_EQ(one.step(dt, dt), HostStatus::error);
    EXPECT_EQ(one.call(GetParam() == 2 ? "CancelStep" : "EnterEventMode"), HostStatus::error);
    EXPECT_THAT(one.said(), HasSubstr("has no such thing"));
    if (GetParam() == 2) {
        EXPECT_EQ(one.call("GetStatus"), HostStatus::discard);
    }
}

TEST_P(Fmu, RefusesWrongReferences) {
    Hosted hosted("moored", HullMover::inside, GetParam());
    double value = 0;
    EXPECT_EQ(hosted.one.get(0, value), GetParam() == 3 ? HostStatus::ok : HostStatus::error);  // the time
    EXPECT_EQ(hosted.one.get(999, value), HostStatus::error);
    EXPECT_EQ(hosted.one.said(), "There is no real variable with the value reference 999.");
    EXPECT_EQ(hosted.one.get(ref::arrangement, value), HostStatus::error);
    EXPECT_EQ(hosted.one.set(ref::ice_load, 1.0), HostStatus::error);
    EXPECT_EQ(hosted.one.said(), "ice_force_x is an output; it cannot be set.");
    EXPECT_EQ(hosted.one.set(ref::force_in, INFINITY), HostStatus::error);
    EXPECT_EQ(hosted.one.set(ref::arrangement, -1), HostStatus::error);
}

TEST_P(Fmu, EndsWithTheRunAndAtTheStopTime) {
    Hosted hosted("moored", HullMover::inside, GetParam());
    hosted.one.set(ref::settings, std::string("analysis.window_s=0.25;analysis.steady_start_s=0.25"));
    ASSERT_EQ(hosted.one.initialize(), HostStatus::ok) << hosted.one.said();
    EXPECT_EQ(hosted.one.step(0, 31 * dt), HostStatus::ok) << hosted.one.said();
    EXPECT_EQ(hosted.one.step(31 * dt, 2 * dt), HostStatus::discard);
    EXPECT_TRUE(hosted.one.is_over());
    EXPECT_EQ(hosted.one.last_time(), 31 * dt);
    EXPECT_EQ(hosted.one.step(31 * dt, dt), HostStatus::ok) << hosted.one.said();
    hosted.one.call("Reset");
    ASSERT_EQ(hosted.one.initialize(0, 10 * dt), HostStatus::ok) << hosted.one.said();
    EXPECT_EQ(hosted.one.step(0, 10 * dt), HostStatus::ok) << hosted.one.said();
    EXPECT_EQ(hosted.one.step(10 * dt, dt), HostStatus::error);
    EXPECT_THAT(hosted.one.said(), HasSubstr("ends after the stop time"));
}

std::string refusal_of(const std::string& override) {
    return refusal_or("", [&] {
        read_campaign({.text = write_campaign(campaign()), .file = "configuration.toml", .overrides = {override}},
                      nullptr);
    });
}

TEST_P(Fmu, SaysOfSettingsWhatTheProgramSays) {
    Hosted hosted("moored", HullMover::inside, GetParam());
    for (const std::string wrong : {"ice.thicknes_m=1", "ice.thickness_m=-1", "analysis.window_s=0.001"}) {
        hosted.one.set(ref::settings, wrong);
        EXPECT_EQ(hosted.one.initialize(), HostStatus::error);
        EXPECT_EQ(hosted.one.said(), refusal_of(wrong));
        EXPECT_THAT(hosted.one.said(), HasSubstr(wrong.substr(0, wrong.find('='))));
        hosted.one.call("Reset");
    }
    hosted.one.set(ref::settings, std::string("arrangement.method=\"file\"; arrangement.file=\"poses.csv\""));
    EXPECT_EQ(hosted.one.initialize(), HostStatus::error);
    EXPECT_THAT(hosted.one.said(), HasSubstr("poses.csv: an FMU reads no other file"));
    hosted.one.call("Reset");
    hosted.one.set(ref::case_name, std::string("none"));
    EXPECT_EQ(hosted.one.initialize(), HostStatus::error);
    EXPECT_EQ(hosted.one.said(), "there is no case none; the cases are towed, slow, surging, moored, floating");
    hosted.one.call("Reset");
    hosted.one.set(ref::case_name, std::string("towed"));
    EXPECT_EQ(hosted.one.initialize(), HostStatus::error);
    EXPECT_THAT(hosted.one.said(), HasSubstr("moorings.mass_t"));
}

TEST_P(Fmu, AStepThatFailsBreaksItsInstanceAlone) {
    Hosted hosted("towed", HullMover::outside, GetParam());
    hosted.one.initialize();
    hosted.one.step(0, dt);
    const std::vector<char> saved = hosted.one.saved();
    hosted.one.set(ref::motion, -100.0);
    hosted.one.set(ref::motion + 1, 3.0);
    EXPECT_EQ(hosted.one.step(dt, 10 * dt), HostStatus::error);
    EXPECT_THAT(hosted.one.said(), HasSubstr("t = "));
    EXPECT_EQ(hosted.one.step(2 * dt, dt), HostStatus::error);
    EXPECT_THAT(hosted.one.said(), HasSubstr("broken by a step that failed"));
    EXPECT_EQ(hosted.one.set_saved(saved), HostStatus::ok) << hosted.one.said();
    EXPECT_EQ(hosted.one.step(dt, dt), HostStatus::ok) << hosted.one.said();
}

TEST_P(Fmu, IsFoundByEveryFormOfItsPlace) {
    const std::string archive = fmu_of("moored", HullMover::inside, GetParam());
    const OpenFmu fmu(archive, GetParam());
    std::vector<std::string> forms{fmu.resources()};
    if (GetParam() == 2) {
        std::string escaped = fmu.resources();
        escaped.replace(escaped.rfind("resources"), 1, "%72");
        forms = {"file://" + fmu.resources(), "file:" + fmu.resources(), "file://localhost" + fmu.resources(),
                 "file://" + escaped, "file://" + fmu.resources() + "/"};
    }
    for (const std::string& form : forms) EXPECT_TRUE(HostedInstance(fmu, token_in(archive), form).is_there()) << form;
    const HostedInstance stranger(fmu, "0123");
    EXPECT_FALSE(stranger.is_there());
    EXPECT_THAT(stranger.said(), HasSubstr("is of another FMU"));
    const HostedInstance lost(fmu, token_in(archive), "file:///nowhere");
    EXPECT_FALSE(lost.is_there());
    EXPECT_THAT(lost.said(), HasSubstr("resources has to be unpacked"));
}

// The archive and the description, as the standards ask.

TEST_P(Fmu, IsAnArchiveThatImportersTake) {
    const std::map<std::string, ZippedFile> files = unzipped(fmu_of("moored", HullMover::inside, GetParam()));
    for (const auto& [name, file] : files) {
        EXPECT_EQ(file.method, 8u) << name;
        EXPECT_LE(file.version, 20u) << name;
        EXPECT_THAT(name, testing::Not(StartsWith("."))) << name;
    }
    const std::string binaries = GetParam() == 2 ? "binaries/linux64/" : "binaries/x86_64-linux/";
    for (const std::string& name :
         {std::string("modelDescription.xml"), std::string("resources/configuration.toml"), binaries + "floes.so",
          std::string("documentation/index.html"), std::string("documentation/licenses/license.txt")})
        EXPECT_TRUE(files.contains(name)) << name;
}

TEST_P(Fmu, PutsItsNameIntoMarkup) {
    FmuParts parts;
    parts.description.model_name = "ice <2 m> & \"wind\"";
    const auto files = unzipped(fmu_file(parts, GetParam() == 2 ? FmiVersion::two : FmiVersion::three));
    const std::string name = "ice &lt;2 m&gt; &amp; &quot;wind&quot;";
    EXPECT_THAT(files.at("documentation/index.html").bytes, HasSubstr("<h1>" + name + "</h1>"));
    EXPECT_THAT(files.at("modelDescription.xml").bytes, HasSubstr("modelName=\"" + name + "\""));
}

/// Of every element of that name, its attributes.
std::vector<std::map<std::string, std::string>> elements(const std::string& text, const std::string& name) {
    std::vector<std::map<std::string, std::string>> found;
    const std::regex element("<" + name + "((?: [^>]*?)?)/?>");
    const std::regex attribute("(\\w+)=\"([^\"]*)\"");
    for (auto one = std::sregex_iterator(text.begin(), text.end(), element); one != std::sregex_iterator(); ++one) {
        const std::string inside = (*one)[1];
        auto& attributes = found.emplace_back();
        for (auto a = std::sregex_iterator(inside.begin(), inside.end(), attribute); a != std::sregex_iterator(); ++a)
            attributes[(*a)[1]] = (*a)[2];
    }
    return found;
}

/// All variables, with start and unit among their attributes.
std::vector<std::map<std::string, std::string>> variables_in(const std::string& text, int version) {
    if (version == 3) {
        auto all = elements(text, "(?:Float64|Int32)");
        for (auto& one : elements(text, "String")) {
            one["start"] = "in a child";
            all.push_back(one);
        }
        return all;
    }
    auto all = elements(text, "ScalarVariable");
    const auto types = elements(text, "(?:Real|Integer|String)");
    EXPECT_EQ(types.size(), all.size());
    for (std::size_t k = 0; k < all.size(); ++k) all[k].insert(types[k].begin(), types[k].end());
    return all;
}

TEST_P(Fmu, DescribesItselfAsTheStandardAsks) {
    for (const HullMover mover : {HullMover::inside, HullMover::outside}) {
        const std::string text = description_in(fmu_of("moored", mover, GetParam()));
        std::size_t last = 0;
        for (const char* name : {"<CoSimulation", "<UnitDefinitions", "<LogCategories", "<DefaultExperiment",
                                 "<ModelVariables", "<ModelStructure"}) {
            ASSERT_GT(text.find(name), last) << name;
            last = text.find(name);
        }
        const auto variables = variables_in(text, GetParam());
        ASSERT_GT(variables.size(), 20u);
        std::set<std::string> names, references, outputs, units;
        for (auto& unit : elements(text, "Unit")) units.insert(unit["name"]);
        int index = 0;
        for (auto one : variables) {
            ++index;
            EXPECT_TRUE(names.insert(one["name"]).second) << one["name"];
            EXPECT_TRUE(references.insert(one["valueReference"]).second) << one["name"];
            const std::string causality = one["causality"];
            EXPECT_EQ(one.contains("start"), causality == "input" || causality == "parameter") << one["name"];
            EXPECT_EQ(one.contains("initial"), false);
            EXPECT_TRUE(!one.contains("unit") || units.contains(one["unit"])) << one["unit"];
            EXPECT_TRUE(causality != "parameter" || one["variability"] == "fixed") << one["name"];
            if (causality == "output") outputs.insert(GetParam() == 2 ? std::to_string(index) : one["valueReference"]);
        }
        EXPECT_EQ(references.contains("0"), GetParam() == 3);  // the independent variable
        std::multiset<std::string> listed;
        for (auto& one : elements(text, GetParam() == 2 ? "Unknown" : "(?:Output|InitialUnknown)")) {
            listed.insert(one[GetParam() == 2 ? "index" : "valueReference"]);
            EXPECT_TRUE(one.contains("dependencies"));
        }
        EXPECT_EQ(listed.size(), 2 * outputs.size());
        for (const std::string& one : outputs) EXPECT_EQ(listed.count(one), 2u) << one;
    }
}

// The library as a file.

std::string output_of(const std::string& command) {
    std::string text;
    FILE* pipe = popen(command.c_str(), "r");
    std::array<char, 4096> some{};
    while (std::fgets(some.data(), some.size(), pipe) != nullptr) text += some.data();
    EXPECT_EQ(pclose(pipe), 0) << command;
    return text;
}

TEST(FmuLibrary, ExportsTheFunctionsOfTheStandardsAlone) {
    const std::string symbols = output_of("objdump -T " FLOES_FMU_LIBRARY);
    std::map<std::string, int> found;
    const std::regex defined("^[0-9a-f]+ (.).{6}\\s+\\.?[*\\w.]+\\s+[0-9a-f]+\\s+(\\S+ )?\\s*(\\S+)$");
    std::istringstream lines(symbols);
    for (std::string line; std::getline(lines, line);) {
        std::smatch parts;
        if (!std::regex_match(line, parts, defined) || line.find("*UND*") != std::string::npos) continue;
        ++found[std::string(parts[3]).substr(0, 4)];
    }
    EXPECT_EQ(found, (std::map<std::string, int>{{"fmi2", 34}, {"fmi3", 75}}));
    EXPECT_THAT(symbols, testing::Not(HasSubstr("GLIBCXX")));
}

TEST(FmuLibrary, NeedsTheLibraryOfCThatThePageSays) {
    const std::string symbols = output_of("objdump -T " FLOES_FMU_LIBRARY);
    std::pair<int, int> newest;
    const std::regex version("GLIBC_(\\d+)\\.(\\d+)");
    for (auto one = std::sregex_iterator(symbols.begin(), symbols.end(), version); one != std::sregex_iterator(); ++one)
        newest = std::max(newest, std::pair(std::stoi((*one)[1]), std::stoi((*one)[2])));
    std::printf("the library of FMUs needs glibc %d.%d\n", newest.first, newest.second);
    EXPECT_LE(newest, std::pair(2, 36)) << symbols;
    EXPECT_THAT(file_text(FLOES_SOURCE_DIR "/docs/coupling.md"),
                HasSubstr("glibc " + std::to_string(newest.first) + "." + std::to_string(newest.second)));
    const std::string needed = output_of("objdump -p " FLOES_FMU_LIBRARY " | grep NEEDED");
    for (const char* strange : {"libstdc++", "libfmt", "libxxhash", "libz", "hdf5", "mpi", "tbb"})
        EXPECT_THAT(needed, testing::Not(HasSubstr(strange)));
}

}  // namespace fmu_test
}  // namespace floes
