// synthetic_file FILE.h5 [none]: publishes a made-up campaign, of which the readers are tested; "none": without
// members and calibration.

#include <cstdio>
#include <exception>
#include <string_view>

#include "campaign_file/publish.hpp"
#include "support/synthetic.hpp"

int main(int argc, char** argv) {
    if (argc < 2) return 2;
    try {
        const floes::Campaign campaign = floes::synthetic::campaign();
        auto records = floes::synthetic::records(campaign);
        std::vector<floes::CalibrationRecord> calibrations{floes::synthetic::calibration(campaign)};
        if (argc > 2 && std::string_view(argv[2]) == "none") {
            records.clear();
            calibrations.clear();
        }
        const std::vector<floes::Session> sessions{floes::synthetic::session(0), floes::describe_session(1, 2, {})};
        floes::publish(argv[1], campaign, records, sessions, calibrations);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
