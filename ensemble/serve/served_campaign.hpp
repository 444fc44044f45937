#pragma once
// Answers a question by a campaign: the configuration at a point, computed on this machine's cores as floes run does.

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "run/attempt.hpp"
#include "serve/served_model.hpp"

namespace floes {

/// The configuration with "key=value" pairs applied last, its [design] left out. Throws InputError.
using ReadCampaign = std::function<Campaign(const std::vector<std::string>& overrides)>;

/// What computes the members of a question.
struct ServingCores {
    MemberFunction compute;
    int threads = 0;           ///< members at a time; 0: the cores
    Helper* helper = nullptr;  ///< as run_campaign() takes it
    std::ostream& progress;
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
    /// whatever was kept. Where there are none, why. What a signal stops is kept and unavailable.
    ModelAnswer answer(const ModelQuestion& question, const std::vector<std::string>& outputs,
                       const ServingCores& cores) const;

  private:
    Campaign campaign_with(std::vector<std::string> overrides) const;
    std::string set(const ModelInput& input, double value) const;

    ReadCampaign read_;
    std::vector<ModelInput> inputs_;
    Options options_;
};

}  // namespace floes
