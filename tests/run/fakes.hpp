#pragma once
// Member functions that replace the physics: fast, slow, broken. Their results depend on the member alone.

#include <algorithm>
#include <chrono>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>

#include "run/link.hpp"
#include "run/run_campaign.hpp"
#include "support/synthetic.hpp"
#include "support/temporary_folder.hpp"

namespace floes::fake {

inline MemberResult compute(const Campaign& campaign, int number, std::stop_token) {
    return synthetic::record(campaign, number).result;
}

/// As a real member, what it gives depends on its case and arrangement, not on its number in the campaign.
inline MemberResult compute_by_identity(const Campaign& campaign, int number, std::stop_token) {
    const MemberKey key = member_key(campaign, number);
    const std::string& name = campaign.cases[static_cast<std::size_t>(key.case_index)].name;
    const Campaign whole = synthetic::campaign(key.arrangement + 1);
    const auto same = std::ranges::find(whole.cases, name, &Case::name);
    const int place =
        key.arrangement * static_cast<int>(whole.cases.size()) + static_cast<int>(same - whole.cases.begin());
    return synthetic::record(whole, place).result;
}

/// Takes a while, a different one for each member, so that members finish in another order than they begin.
inline MemberResult compute_out_of_order(const Campaign& campaign, int number, std::stop_token stop) {
    std::this_thread::sleep_for(std::chrono::milliseconds((number * 7) % 11));
    return compute(campaign, number, std::move(stop));
}

/// Never ends by itself.
inline MemberResult wait_for_stop(const Campaign&, int, std::stop_token stop) {
    while (!stop.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    throw std::runtime_error("stopped");
}

/// A campaign run alone in a folder of its own, with everything it said.
class Run {
  public:
    explicit Run(std::filesystem::path campaign_file, Campaign what = synthetic::campaign())
        : campaign(std::move(what)), file(std::move(campaign_file)) {}

    int operator()(const MemberFunction& compute, Existing existing = Existing::refuse, int threads = 2) {
        LocalLink link;
        return on(link, compute, existing, threads);
    }

    int on(Link& link, const MemberFunction& compute, Existing existing = Existing::refuse, int threads = 2,
           Helper* helper = nullptr) {
        std::ostringstream out;
        const RunOptions options{
            .places = {.campaign_file = file, .existing = existing, .part = part, .keep_journal = keep_journal},
            .threads = threads,
            .writers = writers,
            .resume_command = "RESUME COMMAND",
            .walltime = walltime,
            .patience = patience};
        try {
            Progress progress(out, Progress::Style::plain);
            const int status = run_campaign(campaign, options, link, compute, progress, helper);
            said = out.str();
            return status;
        } catch (...) {
            said = out.str();
            throw;
        }
    }

    /// The result that counts of each member, as bytes without provenance; empty where there is none.
    std::vector<Bytes> results() const {
        const JournalContents contents = read_journal(journal_path(file));
        std::vector<Bytes> all;
        const StoredMembers members = stored_members(contents, journal_path(file));
        for (const auto& record : match_records(campaign, contents.members)) {
            if (!record) {
                all.emplace_back();
                continue;
            }
            MemberRecord bare;
            bare.result = members.read(*record).result;
            bare.result.wall_time = 0;
            bare.result.cpu_time = 0;
            all.push_back(encode(bare));
        }
        return all;
    }

    Campaign campaign;
    std::filesystem::path file;
    std::string said;
    CampaignPart part;
    int writers = 0;
    bool keep_journal = true;
    Walltime walltime;
    SilenceLimits patience;
};

/// The same in a folder of its own, into a.h5.
class RunAside : public TemporaryFolder, public Run {
  public:
    explicit RunAside(Campaign what = synthetic::campaign()) : Run(*this / "a.h5", std::move(what)) {}
};

}  // namespace floes::fake
