#include <limits>

#include <fmt/format.h>

#include "campaign/write.hpp"
#include "campaign_file/campaign_content.hpp"

namespace floes {
namespace {

using hdf5::Handle;
using hdf5::Scale;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Of members, in member order.
void write_member_provenance(hid_t group, const CampaignContent& content) {
    // Not the root's scale: a scale refers to what it is attached to, and comparing two files follows the reference.
    const Scale member = hdf5::write_index_scale(group, "member", "member", content.records.size());
    std::vector<double> wall_time;
    std::vector<double> cpu_time;
    std::vector<double> peak_memory;
    std::vector<std::int32_t> rank;
    std::vector<std::string> host;
    for (const MemberRecord* record : content.records) {
        wall_time.push_back(record != nullptr ? record->result.wall_time : nan);
        cpu_time.push_back(record != nullptr ? record->result.cpu_time : nan);
        peak_memory.push_back(record != nullptr ? static_cast<double>(record->peak_memory) : nan);
        rank.push_back(record != nullptr ? record->rank : -1);
        host.push_back(record != nullptr ? record->host : "");
    }
    const hdf5::Dimensions one{member};
    hdf5::write_values(group, {"wall_time", "s", "wall time of the member"}, one, wall_time);
    hdf5::write_values(group, {"cpu_time", "s", "processor time of the member"}, one, cpu_time);
    hdf5::write_values(group, {"peak_memory", "byte", "largest resident set of the process by the member's end"}, one,
                       peak_memory);
    hdf5::write_values(group, {"rank", "1", "rank that computed the member"}, one, rank, -1);
    hdf5::write_values(group, {"host", "1", "host that computed the member"}, one, host);
    hdf5::write_values(group, {"attempts", "1", "attempts at the member"}, one, content.attempts);
}

void write_sessions(hid_t group, std::span<const Session> sessions) {
    const Scale scale =
        hdf5::write_index_scale(group, "session", "start of the program on the campaign", sessions.size());
    const auto texts = [&](const char* name, const char* long_name, auto function) {
        std::vector<std::string> values;
        for (const Session& session : sessions) values.push_back(function(session));
        hdf5::write_values(group, {name, "1", long_name}, {scale}, values);
    };
    const auto counts = [&](const char* name, const char* long_name, int Session::*field) {
        std::vector<std::int32_t> values;
        for (const Session& session : sessions) values.push_back(session.*field);
        hdf5::write_values(group, {name, "1", long_name}, {scale}, values);
    };
    texts("session_started", "begin of the session, UTC", [](const Session& s) { return s.started; });
    texts("session_ended", "end of the session, UTC; empty when killed or at work",
          [](const Session& s) { return s.ended; });
    texts("session_outcome", "how the session ended", [](const Session& s) { return s.outcome; });
    texts("session_host", "host of rank 0", [](const Session& s) { return s.host; });
    texts("session_machine", "system and processor of rank 0", [](const Session& s) { return s.machine; });
    texts("session_job", "batch job", [](const Session& s) { return s.job; });
    texts("session_software", "software and versions", [](const Session& s) {
        std::string text;
        for (const Software& software : s.software)
            text += fmt::format("{}{} {}", text.empty() ? "" : "; ", software.name, software.version);
        return text;
    });
    counts("session_ranks", "ranks of the session", &Session::ranks);
    counts("session_threads", "threads over all ranks of the session", &Session::threads);
    counts("session_reused", "members that had their result, or stood aside, before the session", &Session::reused);
    counts("session_retried", "members that failed or were lost before and were tried again", &Session::retried);
    counts("session_computed", "members done in the session", &Session::computed);
    counts("session_set_aside", "members given up in the session", &Session::set_aside);
}

std::string lower_case(std::string text) {
    for (char& letter : text)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    return text;
}

}  // namespace

void write_provenance(hid_t file, const CampaignContent& content, std::span<const Session> sessions) {
    const Handle group = hdf5::create_group(file, "provenance");
    const hid_t id = group.id();
    hdf5::write_attribute(id, "date", utc_now());
    hdf5::write_attribute(id, "seed", content.campaign.seed);
    if (!sessions.empty()) {
        hdf5::write_attribute(id, "machine", sessions.back().machine);
        for (const Software& software : sessions.back().software)
            hdf5::write_attribute(id, lower_case(software.name), software.version);
    }
    hdf5::write_text(id, {"configuration", "1", "resolved configuration, TOML"}, write_campaign(content.campaign));
    write_member_provenance(id, content);
    write_sessions(id, sessions);
}

}  // namespace floes
