#include <fcntl.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "core/error.hpp"
#include "store/arrangement_rows.hpp"
#include "store/build_info.hpp"
#include "store/campaign_columns.hpp"
#include "store/campaign_file.hpp"
#include "store/file_descriptor.hpp"
#include "store/hdf5_write.hpp"

namespace floes {
namespace {

using hdf5::Handle;
using hdf5::Label;
using hdf5::Scale;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<std::int32_t> indices(std::size_t count) {
    std::vector<std::int32_t> values(count);
    std::iota(values.begin(), values.end(), 0);
    return values;
}

Scale index_scale(hid_t file, const char* name, const char* long_name, std::size_t count) {
    return hdf5::write_scale(file, Label{name, "1", long_name}, indices(count));
}

// Everything that the parts of the file are made of.
struct Content {
    const Campaign& campaign;
    const std::vector<const MemberRecord*> records;  // by member; nullptr where there is none
    CampaignTable table;
    const ArrangementRows arrangement_rows;

    // The result of a done member, else nullptr: of a failed one nothing stands in the file but that it failed.
    const MemberResult* done(std::size_t member) const {
        const MemberRecord* record = records[member];
        return record != nullptr && record->result.status == MemberStatus::done ? &record->result : nullptr;
    }
};

template <class Value, class Function>
std::vector<Value> of_cases(const Content& content, Function function) {
    std::vector<Value> values;
    for (const Case& one : content.campaign.cases) values.push_back(function(one.scenario));
    return values;
}

template <class Value, class Function>
std::vector<Value> of_members(Content& content, Function function) {
    std::vector<Value> values;
    for (MemberRow& row : content.table.members) values.push_back(function(row));
    return values;
}

template <class Function>
std::size_t largest(const Content& content, Function function) {
    std::size_t value = 0;
    for (const Case& one : content.campaign.cases)
        value = std::max(value, static_cast<std::size_t>(function(one.scenario)));
    return value;
}

// Ends of steps where all cases step alike, else the numbers of the steps.
Scale time_scale(hid_t file, const Content& content) {
    const std::set<double> steps = [&content] {
        std::set<double> found;
        for (const Case& one : content.campaign.cases) found.insert(one.scenario.general.time_step);
        return found;
    }();
    const bool alike = steps.size() == 1;
    std::vector<double> times(largest(content, [](const Scenario& s) { return s.step_count(); }));
    for (std::size_t k = 0; k < times.size(); ++k)
        times[k] = static_cast<double>(k + 1) * (alike ? *steps.begin() : 1.0);
    if (alike) return hdf5::write_scale(file, Label{"time", "s", "end of the time step"}, times);
    return hdf5::write_scale(file, Label{"time", "1", "number of the time step from 1; times /cases/time_step"}, times);
}

// All dimensions stand at the root: only then do netCDF readers find them from every group.
struct Scales {
    Scale member;
    Scale case_;
    Scale arrangement;
    Scale segment;
    Scale floe;
    Scale time;
    Scale coordinate;
    Scale profile_point;
    Scale break_;
};

std::size_t break_count(const Content& content) {
    std::size_t count = 0;
    for (std::size_t member = 0; member < content.records.size(); ++member)
        if (const MemberResult* result = content.done(member)) count += result->breaks.size();
    return count;
}

Scales write_scales(hid_t file, const Content& content) {
    const std::vector<std::string> coordinates{"x", "z", "yaw"};
    return {index_scale(file, "member", "member: arrangement number times cases plus case", content.records.size()),
            index_scale(file, "case", "case, a row of /cases", content.campaign.cases.size()),
            index_scale(file, "arrangement", "arrangement, a row of /arrangements",
                        static_cast<std::size_t>(content.arrangement_rows.count())),
            index_scale(file, "segment", "equal part of the analysis window",
                        largest(content, [](const Scenario& s) { return s.analysis.segments; })),
            index_scale(file, "floe", "floe of an arrangement",
                        largest(content, [](const Scenario& s) { return s.field.floes; })),
            time_scale(file, content),
            hdf5::write_scale(file, Label{"coordinate", "1", "coordinate of a floe's pose"}, coordinates),
            index_scale(file, "profile_point", "point of the structure's profile, from below",
                        largest(content, [](const Scenario& s) { return s.structure.profile.size(); })),
            index_scale(file, "break", "failed joint, a row of /breaks", break_count(content))};
}

void write_root(hid_t file, const Campaign& campaign) {
    const std::vector<std::int32_t> version(campaign_file_version.begin(), campaign_file_version.end());
    hdf5::write_attribute(file, "title", campaign.name);
    hdf5::write_attribute(file, "Conventions", std::string("CF-1.8"));
    hdf5::write_attribute(file, "filetype", std::string(campaign_filetype));
    hdf5::write_attribute(file, "version", version);
    hdf5::write_attribute(file, "software", std::string("floes"));
    hdf5::write_attribute(file, "softwareVersion", floes_version());
    hdf5::write_attribute(file, "git_sha1", git_revision());
    hdf5::write_attribute(file, "fingerprint", fingerprint(campaign));
}

void write_members(hid_t file, Content& content, const Scales& scales) {
    const Handle group = hdf5::create_group(file, "members");
    const hid_t id = group.id();
    const hdf5::Dimensions member{scales.member};
    hdf5::write_values(id, {"case", "1", "case of the member, a row of /cases"}, member,
                       of_members<std::int32_t>(content, [](const MemberRow& row) { return row.case_index; }));
    hdf5::write_values(id, {"arrangement", "1", "arrangement of the member, a row of /arrangements"}, member,
                       of_members<std::int32_t>(content, [](const MemberRow& row) { return row.arrangement; }));
    hdf5::write_values(
        id, {"status", "1", "whether the member was computed"}, member,
        of_members<std::int8_t>(content, [](const MemberRow& row) { return static_cast<std::int8_t>(row.status); }),
        hdf5::Flags{{-1, 0, 1}, "missing done failed"});
    for (const RealColumn& column : real_columns)
        hdf5::write_values(id, {column.name, column.unit, column.long_name}, member,
                           of_members<double>(content, column.field));
    for (const CountColumn& column : count_columns)
        hdf5::write_values(id, {column.name, "1", column.long_name}, member,
                           of_members<double>(content, [&column](const MemberRow& row) {
                               return row.status == RowStatus::done ? row.*column.field : nan;
                           }));
    hdf5::write_values(
        id, {"steady", "1", "whether the trend of the surge load does not differ from zero"}, member,
        of_members<std::int8_t>(content,
                                [](const MemberRow& row) {
                                    return static_cast<std::int8_t>(row.status == RowStatus::done ? row.steady : -1);
                                }),
        hdf5::Flags{{0, 1}, "not_steady steady", -1});
    hdf5::write_rows(id, {"segment_maximum", "N", "largest surge load in each segment of the window"}, scales.member,
                     scales.segment, [&content](std::size_t member_index) {
                         return std::span<const double>(content.table.members[member_index].segment_maximum);
                     });
    hdf5::write_values(id, {"reason", "1", "why the member failed; empty unless it did"}, member,
                       of_members<std::string>(content, [](const MemberRow& row) { return row.reason; }));
}

void write_cases(hid_t file, const Content& content, const Scales& scales) {
    const Handle group = hdf5::create_group(file, "cases");
    const hid_t id = group.id();
    const hdf5::Dimensions one{scales.case_};
    std::vector<std::string> names;
    for (const CaseRow& row : content.table.cases) names.push_back(row.name);
    hdf5::write_values(id, {"name", "1", "name of the case"}, one, names);
    const auto real = [&](const char* name, const char* unit, const char* long_name, auto function) {
        hdf5::write_values(id, {name, unit, long_name}, one, of_cases<double>(content, function));
    };
    real("cfm", "1", "constraint force mixing of the joints (Sigma)", [](const Scenario& s) { return s.joint.cfm; });
    real("elastic_modulus", "Pa", "elastic modulus that the case stands for",
         [](const Scenario& s) { return s.ice.elastic_modulus; });
    real("contact_erp", "1", "error reduction parameter of contacts (Gamma)",
         [](const Scenario& s) { return s.contact.erp; });
    real("time_step", "s", "time step", [](const Scenario& s) { return s.general.time_step; });
    real("steady_start", "s", "begin of the analysis window",
         [](const Scenario& s) { return s.analysis.steady_start; });
    real("window", "s", "length of the analysis window", [](const Scenario& s) { return s.analysis.window; });
    hdf5::write_values(id, {"segments", "1", "equal parts of the analysis window"}, one,
                       of_cases<std::int32_t>(content, [](const Scenario& s) { return s.analysis.segments; }));
    hdf5::write_values(
        id, {"far_end", "1", "what stands behind the ice field"}, one,
        of_cases<std::int8_t>(content, [](const Scenario& s) { return static_cast<std::int8_t>(s.field.far_end); }),
        hdf5::Flags{{static_cast<std::int8_t>(FarEnd::ice_sheet), static_cast<std::int8_t>(FarEnd::open)},
                    "ice_sheet open"});
    const auto profile = [&](const char* name, const char* long_name, double ProfilePoint::*field) {
        std::vector<double> values(scales.case_.size() * scales.profile_point.size(), nan);
        for (std::size_t k = 0; k < content.table.cases.size(); ++k)
            for (std::size_t p = 0; p < content.table.cases[k].profile.size(); ++p)
                values[k * scales.profile_point.size() + p] = content.table.cases[k].profile[p].*field;
        hdf5::write_values(id, {name, "m", long_name}, {scales.case_, scales.profile_point}, values);
    };
    profile("profile_height", "height of a profile point above the waterline", &ProfilePoint::height);
    profile("profile_radius", "radius of the structure at a profile point", &ProfilePoint::radius);
}

void write_arrangements(hid_t file, const Content& content, const Scales& scales) {
    const Handle group = hdf5::create_group(file, "arrangements");
    const std::size_t floes = scales.floe.size();
    std::vector<double> poses(scales.arrangement.size() * floes * 3, nan);
    std::vector<double> psi4(scales.arrangement.size(), nan);
    std::vector<std::int32_t> numbers;
    for (int row = 0; row < content.arrangement_rows.count(); ++row)
        numbers.push_back(content.arrangement_rows.number(row));
    for (std::size_t member = 0; member < content.records.size(); ++member) {
        if (content.records[member] == nullptr || content.records[member]->result.arrangement.empty()) continue;
        const MemberResult& result = content.records[member]->result;
        const auto row = static_cast<std::size_t>(content.table.members[member].arrangement);
        psi4[row] = result.psi4;
        for (std::size_t floe = 0; floe < std::min(floes, result.arrangement.size()); ++floe) {
            double* pose = &poses[(row * floes + floe) * 3];
            pose[0] = result.arrangement[floe].x;
            pose[1] = result.arrangement[floe].z;
            pose[2] = result.arrangement[floe].yaw;
        }
    }
    hdf5::write_values(group.id(), {"number", "1", "arrangement number"}, {scales.arrangement}, numbers);
    hdf5::write_values(group.id(), {"pose", "m, m, rad", "pose of each floe at the start: x, z, yaw"},
                       {scales.arrangement, scales.floe, scales.coordinate}, poses);
    hdf5::write_values(group.id(), {"psi4", "1", "fourfold orientational order of the arrangement"},
                       {scales.arrangement}, psi4);
}

void write_history(hid_t file, const Content& content, const Scales& scales) {
    const Handle group = hdf5::create_group(file, "history");
    const auto write = [&](const char* name, const char* long_name, std::vector<double> LoadHistory::*field) {
        hdf5::write_rows(
            group.id(), {name, "N", long_name}, scales.member, scales.time, [&content, field](std::size_t member) {
                const MemberResult* result = content.done(member);
                return result != nullptr ? std::span<const double>(result->history.*field) : std::span<const double>();
            });
    };
    write("surge_load", "contact force on the structure against the tow", &LoadHistory::surge);
    write("sway_load", "contact force on the structure towards +z", &LoadHistory::sway);
    write("heave_load", "contact force on the structure upwards", &LoadHistory::heave);
}

void write_breaks(hid_t file, const Content& content, const Scales& scales) {
    std::vector<std::int32_t> members;
    std::vector<double> times;
    std::vector<std::int32_t> floes;
    std::vector<std::int32_t> joints;
    std::vector<std::int8_t> modes;
    for (std::size_t member = 0; member < content.records.size(); ++member) {
        const MemberResult* result = content.done(member);
        if (result == nullptr) continue;
        for (const BreakEvent& event : result->breaks) {
            members.push_back(static_cast<std::int32_t>(member));
            times.push_back(event.time);
            floes.push_back(event.floe);
            joints.push_back(event.joint);
            modes.push_back(static_cast<std::int8_t>(event.mode));
        }
    }
    hdf5::Flags flags;
    for (std::size_t mode = 0; mode < failure_mode_names.size(); ++mode) {
        flags.values.push_back(static_cast<std::int8_t>(mode));
        flags.meanings += (mode == 0 ? "" : " ") + std::string(failure_mode_names[mode]);
    }
    const Handle group = hdf5::create_group(file, "breaks");
    const hdf5::Dimensions one{scales.break_};
    hdf5::write_values(group.id(), {"member", "1", "member in which the joint failed"}, one, members);
    hdf5::write_values(group.id(), {"time", "s", "end of the step in which the joint failed"}, one, times);
    hdf5::write_values(group.id(), {"floe", "1", "floe of the joint"}, one, floes);
    hdf5::write_values(group.id(), {"joint", "1", "joint within its floe"}, one, joints);
    hdf5::write_values(group.id(), {"mode", "1", "how the joint failed"}, one, modes, flags);
}

// Of members, in member order.
void write_member_provenance(hid_t group, const Content& content, std::vector<int> attempts) {
    // Not the root's scale: a scale refers to what it is attached to, and comparing two files follows the reference.
    const Scale member = index_scale(group, "member", "member", content.records.size());
    std::vector<double> wall_time;
    std::vector<double> peak_memory;
    std::vector<std::int32_t> rank;
    std::vector<std::string> host;
    for (const MemberRecord* record : content.records) {
        wall_time.push_back(record != nullptr ? record->result.wall_time : nan);
        peak_memory.push_back(record != nullptr ? static_cast<double>(record->peak_memory) : nan);
        rank.push_back(record != nullptr ? record->rank : -1);
        host.push_back(record != nullptr ? record->host : "");
    }
    const hdf5::Dimensions one{member};
    hdf5::write_values(group, {"wall_time", "s", "wall time of the member"}, one, wall_time);
    hdf5::write_values(group, {"peak_memory", "byte", "largest resident set of the process by the member's end"}, one,
                       peak_memory);
    hdf5::write_values(group, {"rank", "1", "rank that computed the member"}, one, rank, -1);
    hdf5::write_values(group, {"host", "1", "host that computed the member"}, one, host);
    hdf5::write_values(group, {"attempts", "1", "attempts at the member"}, one, attempts);
}

void write_sessions(hid_t group, std::span<const Session> sessions) {
    const Scale scale = index_scale(group, "session", "start of the program on the campaign", sessions.size());
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
}

void write_provenance(hid_t file, const Content& content, std::span<const Session> sessions,
                      std::vector<int> attempts) {
    const Handle group = hdf5::create_group(file, "provenance");
    const hid_t id = group.id();
    hdf5::write_attribute(id, "date", utc_now());
    hdf5::write_attribute(id, "seed", content.campaign.seed);
    if (!sessions.empty()) {
        hdf5::write_attribute(id, "machine", sessions.back().machine);
        for (const Software& software : sessions.back().software)
            hdf5::write_attribute(id, software.name, software.version);
    }
    hdf5::write_text(id, {"configuration", "1", "resolved configuration, TOML"}, write_campaign(content.campaign));
    write_member_provenance(id, content, std::move(attempts));
    write_sessions(id, sessions);
}

void write_file(const std::filesystem::path& path, Content& content, std::span<const Session> sessions,
                std::vector<int> attempts) {
    const hdf5::QuietErrors quiet;
    Handle file = hdf5::create_file(path);
    {
        write_root(file.id(), content.campaign);
        const Scales scales = write_scales(file.id(), content);
        write_members(file.id(), content, scales);
        write_cases(file.id(), content, scales);
        write_arrangements(file.id(), content, scales);
        write_history(file.id(), content, scales);
        write_breaks(file.id(), content, scales);
        write_provenance(file.id(), content, sessions, std::move(attempts));
    }
    file.close("H5Fclose", path.string());
}

}  // namespace

void publish(const std::filesystem::path& path, const Campaign& campaign, std::span<const MemberRecord> records,
             std::span<const Session> sessions) {
    Content content{campaign, match_records(campaign, records), campaign_table(campaign, records),
                    ArrangementRows(campaign)};
    const std::filesystem::path aside = path.string() + ".tmp";
    write_file(aside, content, sessions, last_attempts(campaign, records));
    sync_data(open_file(aside, O_RDWR), aside);
    std::error_code error;
    std::filesystem::rename(aside, path, error);
    if (error)
        throw RunError(fmt::format("renaming {} to {} failed: {}", aside.string(), path.string(), error.message()));
    sync_folder_of(path);
}

}  // namespace floes
