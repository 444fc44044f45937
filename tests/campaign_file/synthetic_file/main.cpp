// synthetic_file FILE.h5 [none | pieces | N]: publishes a made-up campaign, of which the readers are tested; "none":
// without members and calibration; "pieces": with its rows in three pieces; N: of so many arrangements of three cases,
// with loads and histories alone.

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>

#include "campaign_file/publish.hpp"
#include "core/random.hpp"
#include "support/in_pieces.hpp"
#include "support/synthetic.hpp"

namespace {

/// Members that scatter, for pages of many.
std::vector<floes::MemberRecord> many_records(const floes::Campaign& campaign) {
    std::vector<floes::MemberRecord> records;
    for (int number = 0; number < member_count(campaign); ++number) {
        floes::MemberRecord one = floes::synthetic::record(campaign, number % 6);
        const floes::MemberKey key = member_key(campaign, number);
        one.case_key = case_fingerprint(campaign, key.case_index);
        one.arrangement = key.arrangement;
        floes::RandomStream random{5, static_cast<std::uint32_t>(number), floes::StreamId::bootstrap, 0};
        const double factor = random.uniform(0.2, 1) * random.uniform(0.2, 1);
        one.result.load.mean = 100 * factor * (1 + key.case_index);
        one.result.load.mean_maximum = one.result.load.mean * random.uniform(2, 4);
        one.result.failure_ratio = factor * random.uniform(0, 1);
        for (double& load : one.result.history.surge) load *= factor * random.uniform(0.5, 1);
        one.result.load_map = {};
        one.result.breaks.clear();
        one.result.piece_areas.clear();
        records.push_back(std::move(one));
    }
    return records;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return 2;
    try {
        const std::string_view word = argc > 2 ? argv[2] : "";
        const int arrangements = argc > 2 ? std::atoi(argv[2]) : 0;
        const floes::Campaign campaign =
            arrangements > 0 ? floes::synthetic::campaign(arrangements) : floes::synthetic::campaign();
        auto records = arrangements > 0 ? many_records(campaign) : floes::synthetic::records(campaign);
        std::vector<floes::CalibrationRecord> calibrations{floes::synthetic::calibration(campaign)};
        if (word == "none") {
            records.clear();
            calibrations.clear();
        }
        const std::vector<floes::Session> sessions{floes::synthetic::session(0), floes::describe_session(1, 2, {})};
        if (word == "pieces")
            floes::publish_in_pieces(argv[1], campaign, records, 3, sessions, calibrations);
        else
            floes::publish(argv[1], campaign, records, sessions, calibrations);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
