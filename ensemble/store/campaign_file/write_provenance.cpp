#include <fmt/format.h>

#include "campaign/write.hpp"
#include "campaign_file/campaign_content.hpp"

namespace floes {
namespace {

using hdf5::Handle;
using hdf5::Scale;

// Not the root's scale: a scale refers to what it is attached to, and comparing two files follows the reference.
void add_members(hid_t group, const CampaignContent& content, MemberTables& tables) {
    const Scale member = hdf5::write_index_scale(group, "member", "member", content.records.size());
    const hdf5::Dimensions one{member};
    const auto reals = [&](const char* name, const char* unit, const char* long_name, auto of) {
        tables.add_numbers<double>(group, {name, unit, long_name}, one, nan, [of](const FiledMember& m) {
            return m.record != nullptr ? static_cast<double>(of(*m.record)) : nan;
        });
    };
    reals("wall_time", "s", "wall time of the member", [](const MemberRecord& r) { return r.result.wall_time; });
    reals("cpu_time", "s", "processor time of the member", [](const MemberRecord& r) { return r.result.cpu_time; });
    reals("peak_memory", "byte", "largest resident set of the process by the member's end",
          [](const MemberRecord& r) { return r.peak_memory; });
    tables.add_numbers<std::int32_t>(group, {"rank", "1", "rank that computed the member"}, one, std::int32_t{-1},
                                     [](const FiledMember& m) { return m.record != nullptr ? m.record->rank : -1; });
    tables.add_texts(group, {"host", "1", "host that computed the member"}, one,
                     [](const FiledMember& m) { return m.record != nullptr ? m.record->host : ""; });
    tables.add_numbers<std::int32_t>(group, {"attempts", "1", "attempts at the member"}, one, std::nullopt,
                                     [&content](const FiledMember& m) { return content.attempts[m.number]; });
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

void add_provenance(hid_t file, const CampaignContent& content, std::span<const Session> sessions,
                    MemberTables& tables) {
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
    add_members(id, content, tables);
    write_sessions(id, sessions);
}

}  // namespace floes
