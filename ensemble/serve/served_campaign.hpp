#pragma once
// Answers questions by campaigns: the configuration at a point, computed as floes run does, on cores that the questions
// under way share.

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "run/attempt.hpp"
#include "run/core_pool.hpp"
#include "serve/served_model.hpp"

namespace floes {

/// The configuration with "key=value" pairs applied last, its [design] left out. Throws InputError.
using ReadCampaign = std::function<Campaign(const std::vector<std::string>& overrides)>;

/// What computes the members of a question.
struct ServingCores {
    MemberFunction compute;
    CorePool& pool;
    std::int64_t turn = 0;     ///< in the pool: members of the lowest one go first
    Helper* helper = nullptr;  ///< as run_campaign() takes it; of this question alone
    std::ostream& progress;    ///< of this question alone
    bool alone = true;         ///< no other question is under way meanwhile, so that progress may be a live line
};

/// Lets one question after the other use a file.
class FilesInUse {
  public:
    /// Holds a file from its construction, which waits until nobody else does, to its destruction.
    class Hold {
      public:
        Hold(FilesInUse& files, std::filesystem::path file);
        Hold(const Hold&) = delete;
        Hold& operator=(const Hold&) = delete;
        ~Hold();

      private:
        FilesInUse& files_;
        std::filesystem::path file_;
    };

    std::mutex reading_or_writing;  ///< held meanwhile: HDF5 need not be thread-safe

  private:
    std::mutex mutex_;
    std::condition_variable left_;
    std::set<std::filesystem::path> files_;
};

class ServedCampaign {
  public:
    struct Options {
        std::string case_name;         ///< of the [[case]] that is computed; empty: the only one
        std::filesystem::path folder;  ///< keeps a campaign file for each point
    };

    /// `whole`: what the configuration gives with its design. Throws InputError where there is no such case, and where
    /// the configuration is refused at the middle of the inputs' axes.
    ServedCampaign(ReadCampaign read, const Campaign& whole, std::vector<ModelInput> inputs, Options options);

    /// The campaign of a question: one case. Throws InputError, as the configuration does with these numbers.
    Campaign at(const ModelQuestion& question) const;

    /// The configuration at the middle of the inputs' axes; inputs without an axis as it has them.
    Campaign in_the_middle() const;

    /// Where the campaign is kept: one file for all numbers of arrangements.
    std::filesystem::path file_of(const Campaign& campaign) const;

    /// Means of these outputs over the arrangements, from the file where it has them all, otherwise computed: the same
    /// whatever was kept. Where there are none, why. What a signal stops is kept and unavailable. May be called from
    /// several threads at once, within StopSignals of the process.
    ModelAnswer answer(const ModelQuestion& question, const std::vector<std::string>& outputs,
                       const ServingCores& cores) const;

  private:
    ModelAnswer answer_from(const std::filesystem::path& file, Campaign& campaign,
                            const std::vector<std::string>& outputs, const ServingCores& cores) const;
    Campaign campaign_with(std::vector<std::string> overrides) const;
    std::string set(const ModelInput& input, double value) const;

    ReadCampaign read_;
    std::vector<ModelInput> inputs_;
    Options options_;
    mutable FilesInUse files_;
};

}  // namespace floes
