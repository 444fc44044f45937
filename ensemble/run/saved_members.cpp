#include "run/saved_members.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "campaign/campaign.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "member/run_member.hpp"
#include "store/file_calls.hpp"

namespace floes {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view magic = "floes saved member 1";
constexpr std::string_view ending = ".saved";
constexpr std::size_t digest_bytes = 32;

std::string_view text_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Bytes bytes_of(const fs::path& path, const System& system) {
    const OpenFile file = open_file(path, O_RDONLY, system);
    Bytes bytes(file_size(file));
    if (!read_at(file, 0, bytes)) throw RunError("its end is missing");
    return bytes;
}

/// "a." of `a.h5`, with which the names of all files begin.
std::string beginning_of_names(const fs::path& campaign_file) {
    return campaign_file.stem().string() + ".";
}

struct SavedFile {
    fs::path path;
    MemberIdentity member;
    bool whole = true;  ///< or what a killed process left of one
};

std::vector<SavedFile> saved_files(const fs::path& campaign_file, const System& system) {
    const fs::path folder = folder_of(campaign_file);
    const std::string begins = beginning_of_names(campaign_file);
    std::vector<SavedFile> found;
    for (const std::string& name : system.names_in(folder)) {
        const std::size_t end = name.find(ending);
        if (!name.starts_with(begins) || end == std::string::npos) continue;
        const std::string member = name.substr(begins.size(), end - begins.size());
        const std::size_t dash = member.rfind('-');
        if (dash == std::string::npos || member.find('.') != std::string::npos) continue;  // of another campaign
        SavedFile file{folder / name, {member.substr(0, dash), 0}, name.size() == end + ending.size()};
        char rest = 0;
        if (std::sscanf(member.c_str() + dash + 1, "%9d%c", &file.member.second, &rest) == 1) found.push_back(file);
    }
    return found;
}

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

/// One attempt at a member that may be long.
class LongMember {
  public:
    LongMember(const Campaign& campaign, int number, const Attempting& attempting, const fs::path& campaign_file,
               double interval)
        : campaign_(campaign),
          number_(number),
          key_(member_key(campaign, number)),
          attempting_(attempting),
          path_(saved_path(campaign_file, {case_fingerprint(campaign, key_.case_index), key_.arrangement})),
          interval_(interval) {}

    MemberResult compute() {
        if (interval_ > 0) take_up();
        try {
            return run();
        } catch (const SavedOtherwise&) {
            begin_anew("it does not fit the member");
        }
        return run();
    }

  private:
    void say(const std::string& sentence) const { fmt::print(stderr, "floes: member {} {}\n", number_, sentence); }

    /// Made once: it reads the whole program.
    const std::string& stamp() {
        if (stamp_.empty()) stamp_ = saved_stamp(campaign_, number_);
        return stamp_;
    }

    void begin_anew(const std::string& why) {
        say(fmt::format("begins at its start, since {} cannot be used: {}", path_.string(), why));
        before_ = {};
        forget();
    }

    void take_up() {
        if (!fs::exists(path_)) return;
        try {
            before_ = read_saved(path_, stamp()).value_or(SavedMember{});
        } catch (const std::exception& error) {
            begin_anew(error.what());
        }
    }

    void forget() const {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }

    /// What failed is attempted from its start.
    MemberResult run() {
        try {
            MemberResult result = run_member(
                case_of(campaign_, number_).scenario, arrangement_seed(campaign_, key_.case_index),
                static_cast<std::uint32_t>(key_.arrangement), attempting_.stop,
                [this](const Simulation& now) { look(now); }, before_.state);
            result.wall_time += before_.wall_time;
            result.cpu_time += before_.cpu_time;
            if (result.status != MemberStatus::done && interval_ > 0) forget();
            return result;
        } catch (const Interrupted&) {
            throw;
        } catch (const SavedOtherwise&) {
            throw;
        } catch (...) {
            if (interval_ > 0) forget();
            throw;
        }
    }

    /// After each step.
    void look(const Simulation& simulation) {
        const bool put_off = attempting_.is_put_off && attempting_.is_put_off();
        const Clock::time_point now = Clock::now();
        if (now >= next_word_) tell(simulation, now);
        const double since = seconds_between(last_, now);
        if (interval_ > 0 && simulation.can_be_saved() && since >= (put_off ? least() : interval_))
            save(simulation, now);
        if (put_off) throw Interrupted(fmt::format("Member {} was put off.", number_));
    }

    /// s, that are worth a file.
    double least() const { return std::min(interval_, 10.0); }

    void tell(const Simulation& simulation, Clock::time_point now) {
        constexpr std::chrono::seconds interval{2};
        next_word_ = now + interval;
        const Scenario& scenario = case_of(campaign_, number_).scenario;
        if (attempting_.tell)
            attempting_.tell({number_, simulation.time(), scenario.step_count() * scenario.general.time_step});
    }

    /// A disk that is full costs the state, not the member.
    void save(const Simulation& simulation, Clock::time_point now) {
        const double cpu = cpu_seconds_of_this_thread() - cpu_begin_;
        try {
            write_saved(path_, stamp(),
                        {before_.wall_time + seconds_between(begin_, now), before_.cpu_time + cpu, simulation.saved()});
        } catch (const std::exception& error) {
            if (!std::exchange(said_, true)) say(fmt::format("is not saved: {}", error.what()));
        }
        last_ = Clock::now();
    }

    const Campaign& campaign_;
    int number_;
    MemberKey key_;
    const Attempting& attempting_;
    fs::path path_;
    double interval_;
    std::string stamp_;
    SavedMember before_;  // of earlier runs
    Clock::time_point begin_ = Clock::now();
    double cpu_begin_ = cpu_seconds_of_this_thread();
    Clock::time_point last_ = begin_;  // that it was saved
    Clock::time_point next_word_ = begin_ + std::chrono::seconds(2);
    bool said_ = false;
};

}  // namespace

fs::path saved_path(const fs::path& campaign_file, const MemberIdentity& member) {
    return fs::path(campaign_file)
        .replace_filename(
            fmt::format("{}{}-{}{}", beginning_of_names(campaign_file), member.first, member.second, ending));
}

std::string saved_stamp(const Campaign& campaign, int number) {
    const MemberKey key = member_key(campaign, number);
    std::string stamp = fmt::format("case {}\nseed {}\narrangement {}\n", case_fingerprint(campaign, key.case_index),
                                    arrangement_seed(campaign, key.case_index), key.arrangement);
    for (const Software& one : describe_session(1, 1, {}).software)
        stamp += fmt::format("{} {}\n", one.name, one.version);
    return stamp + fmt::format("program {}\n", digest_hex(text_of(bytes_of("/proc/self/exe", this_system()))));
}

void write_saved(const fs::path& path, const std::string& stamp, const SavedMember& member, const System& system) {
    ByteWriter out;
    out.text(magic);
    out.text(stamp);
    out.f64(member.wall_time);
    out.f64(member.cpu_time);
    out.blob(member.state);
    Bytes bytes = out.take();
    const std::string digest = digest_hex(text_of(bytes));
    const auto last = std::as_bytes(std::span(digest));
    bytes.insert(bytes.end(), last.begin(), last.end());
    const auto write = [&](const fs::path& aside) {
        write_all(open_file(aside, O_WRONLY | O_CREAT | O_TRUNC, system), bytes);
    };
    replace_file(path, fmt::format("{}.{}.{}.tmp", path.string(), host_name(), ::getpid()), write, system);
}

std::optional<SavedMember> read_saved(const fs::path& path, const std::string& stamp, const System& system) {
    if (!is_there(path, system)) return {};
    const Bytes bytes = bytes_of(path, system);
    if (bytes.size() < digest_bytes) throw RunError("its end is missing");
    const auto content = std::span(bytes).first(bytes.size() - digest_bytes);
    if (digest_hex(text_of(content)) != text_of(std::span(bytes).last(digest_bytes)))
        throw RunError("it is damaged or its end is missing");
    ByteReader in(content);
    if (in.text() != magic) throw RunError("it is of another version of floes");
    if (in.text() != stamp) throw RunError("it is of another program, processor or campaign");
    SavedMember member;
    member.wall_time = in.f64();
    member.cpu_time = in.f64();
    member.state = in.blob();
    return member;
}

void remove_saved(const fs::path& campaign_file, const std::function<bool(const MemberIdentity&)>& wanted,
                  HalfWritten half_written, const System& system) {
    for (const SavedFile& file : saved_files(campaign_file, system))
        if (file.whole ? !wanted(file.member) : half_written == HalfWritten::removed) system.remove(file.path);
}

int count_saved(const Campaign& campaign, const fs::path& campaign_file, const System& system) {
    const std::vector<std::string> keys = case_fingerprints(campaign);
    const std::set<std::string> cases(keys.begin(), keys.end());
    return static_cast<int>(std::ranges::count_if(saved_files(campaign_file, system), [&](const SavedFile& file) {
        return file.whole && cases.contains(file.member.first) && file.member.second < campaign.arrangements;
    }));
}

MemberFunction long_members(fs::path campaign_file, double interval) {
    return [campaign_file = std::move(campaign_file), interval](const Campaign& campaign, int number,
                                                                const Attempting& attempting) {
        return LongMember(campaign, number, attempting, campaign_file, interval).compute();
    };
}

}  // namespace floes
