// The verb `array`: how many parts it makes, and what it writes. What the scripts do: tests/slurm/array_scripts.sh.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "cli/verb_output.hpp"
#include "support/file_bytes.hpp"
#include "support/refusal.hpp"
#include "support/temporary_folder.hpp"

namespace floes {
namespace array_test {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

const std::string config = FLOES_SOURCE_DIR "/configs/table3.toml";  // 50 arrangements of 3 cases

class Array : public testing::Test {
  protected:
    Array() { fs::current_path(folder_ / "."); }
    ~Array() override { fs::current_path(before_); }

    /// The script that `floes array CONFIG arguments…` writes.
    static std::string script(const std::string& arguments) {
        std::string name = verb_output(add_array, "array " + config + " " + arguments);
        name.pop_back();
        const std::string text = file_text(name);
        fs::remove(name);
        return text;
    }

    static int parts_of(const std::string& text) {
        std::smatch found;
        EXPECT_TRUE(std::regex_search(text, found, std::regex("--array=1-([0-9]+)"))) << text;
        return std::stoi(found[1]);
    }

    TemporaryFolder folder_;
    fs::path before_ = fs::current_path();
};

TEST_F(Array, MakesPartsOfHalfAnHourByItself) {
    const auto plan = nlohmann::json::parse(verb_output(add_plan, "plan " + config + " --format json"));
    const double core_seconds = plan.at("members").get<int>() * plan.at("mean_run_time_s").get<double>();
    const auto wanted = [&](int cores) {
        return std::clamp(static_cast<int>(std::round(core_seconds / 1800 / cores)), 1, 50);
    };
    EXPECT_EQ(parts_of(script("--for slurm")), wanted(4));
    EXPECT_EQ(parts_of(script("--for slurm --cores 1")), wanted(1));
    EXPECT_GT(wanted(1), 1);
    EXPECT_EQ(parts_of(script("--for slurm --cores 1 --set campaign.arrangements=2 --set general.time_step_s=0.0002")),
              2)
        << "not more than there are arrangements";
}

TEST_F(Array, WritesWhatTheCommandLineSays) {
    const std::string text = script("--for slurm --parts 10 --cores 3 --hours 7 --set campaign.seed=5 -o res/my.h5");
    EXPECT_THAT(text, HasSubstr("#SBATCH --array=1-10\n"));
    EXPECT_THAT(text, HasSubstr("#SBATCH --cpus-per-task=3\n"));
    EXPECT_THAT(text, HasSubstr("#SBATCH --time=7:00:00\n"));
    EXPECT_THAT(text, HasSubstr("--part \"$part/10\" -o res/my\".part$part.h5\""));
    EXPECT_THAT(text, HasSubstr("--isolation process --threads 3 --set campaign.seed=5"));
    EXPECT_THAT(text, HasSubstr("floes merge res/my.part*.h5 -o res/my.h5"));
    EXPECT_THROW(script("--for slurm -o res/my"), InputError) << "which floes merge would refuse at the end";
    for (const char* system : {"slurm", "gridengine", "pbs", "lsf", "flux", "hyperqueue", "parallel"})
        EXPECT_THAT(script(std::string("--parts 10 --for ") + system), Not(testing::ContainsRegex("@[A-Z_]+@")));
    EXPECT_THAT(script("--parts 1 --for pbs"), Not(HasSubstr("#PBS -J"))) << "an array has two tasks at least";
    EXPECT_THAT(script("--parts 10 --for parallel"), Not(HasSubstr("--threads")));
}

TEST_F(Array, RefusesWhatIsNoNumberOfParts) {
    for (const std::string parts : {"0", "51", "-1", "2x", "many"})
        EXPECT_THAT(refusal([&] { script("--for slurm --parts=" + parts); }),
                    HasSubstr("is neither auto nor a number from 1 to the campaign's 50 arrangements"));
    std::ofstream("table3.slurm.sh") << "mine\n";
    EXPECT_THAT(refusal([] { script("--for slurm"); }), HasSubstr("table3.slurm.sh exists already"));
}

}  // namespace array_test
}  // namespace floes
