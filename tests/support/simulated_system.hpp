#pragma once
// A machine that is simulated from a seed, for the driver behind its door (store/system.hpp): a disk with a page cache,
// on which nothing that was not synced is sure, processes that can be killed at any call, and time that passes only
// when somebody waits. One thread; what happens is told by the seed alone.
//
// What the disk promises, and nothing more: what a process wrote, everybody reads, also after its end. A power cut
// leaves of a file what was synced, and of what was written since then any part, in any order and torn anywhere, with
// zeros where a later part was kept and an earlier one not. A name that was made, renamed or removed is so after a
// power cut if the folder was synced since; otherwise it may be, in any combination, but a rename happens whole or not
// at all. A sync that fails may leave what it should have written for ever unwritten while everybody still reads it.

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <queue>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/bytes.hpp"
#include "store/system.hpp"

namespace floes::simulated {

class Dice {
  public:
    explicit Dice(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15u + 0x1234567u) {}

    /// SplitMix64 (Steele, Lea and Flood 2014).
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }
    /// 0 … n - 1.
    int below(int n) { return static_cast<int>(next() % static_cast<std::uint64_t>(n)); }
    int between(int least, int most) { return least + below(most - least + 1); }
    bool one_in(int n) { return below(n) == 0; }

  private:
    std::uint64_t state_;
};

/// Ways in which a driver could be wrong, played by the disk.
struct Mutant {
    bool sync_left_out = false;     ///< files are never synced
    bool rename_too_early = false;  ///< what is renamed is synced after that, with the next call
    bool append_too_late = false;   ///< what is written is written with the next call: what is told of it is too early
    bool folder_not_synced = false;
};

/// A file or its page cache.
struct DiskFile {
    struct Change {
        std::uint64_t offset = 0;
        Bytes bytes{};
        bool truncates = false;  ///< to `offset`
    };

    int number = 0;
    Bytes now{};                     ///< as everybody reads it
    Bytes kept{};                    ///< after a power cut
    std::vector<Change> unsynced{};  ///< between the two
    double modified = 0;
    int lock = -1;  ///< descriptor that has it

    static void apply(Bytes& bytes, const Change& change) {
        if (change.truncates) return bytes.resize(change.offset);
        bytes.resize(std::max<std::size_t>(bytes.size(), change.offset + change.bytes.size()));
        std::ranges::copy(change.bytes, bytes.begin() + static_cast<std::ptrdiff_t>(change.offset));
    }
    void change(Change one) {
        apply(now, one);
        unsynced.push_back(std::move(one));
    }
    void sync() {
        for (const Change& one : unsynced) apply(kept, one);
        unsynced.clear();
    }
};

/// One folder, whatever the path says.
class Disk {
  public:
    using Names = std::map<std::string, std::shared_ptr<DiskFile>>;

    Disk(Dice& dice, const Mutant& mutant) : mutant(mutant), dice_(dice) {}

    std::shared_ptr<DiskFile> find(const std::string& name) const {
        const auto found = names_.find(name);
        return found == names_.end() ? nullptr : found->second;
    }
    std::shared_ptr<DiskFile> create(const std::string& name) {
        auto file = std::make_shared<DiskFile>();
        file->number = ++files_;
        note({name, file});
        return file;
    }
    int rename(const std::string& from, const std::string& to) {
        const auto file = find(from);
        if (!file) return -ENOENT;
        note({to, file, from});
        return 0;
    }
    int remove(const std::string& name) {
        if (!find(name)) return -ENOENT;
        note({name, nullptr});
        return 0;
    }
    const Names& names() const { return names_; }
    void sync_names() {
        for (const NameChange& one : unsynced_) apply(kept_names_, one);
        unsynced_.clear();
    }

    void power_cut() {
        keep_some(unsynced_, [&](const NameChange& one) { apply(kept_names_, one); });
        unsynced_.clear();
        names_ = kept_names_;
        for (auto& [name, file] : names_) {
            keep_some_of(*file);
            file->now = file->kept;
            file->unsynced.clear();
            file->lock = -1;
        }
    }

    int next_process() { return ++processes_; }

    const Mutant mutant;
    bool full = false;
    bool has_lost = false;  ///< what a sync that failed should have written

  private:
    struct NameChange {
        std::string name{};
        std::shared_ptr<DiskFile> file{};  ///< that has it now; none: it was removed
        std::string before{};              ///< its name before, of a rename
    };

    static void apply(Names& names, const NameChange& one) {
        if (!one.before.empty()) names.erase(one.before);
        if (one.file)
            names[one.name] = one.file;
        else
            names.erase(one.name);
    }
    void note(NameChange one) {
        apply(names_, one);
        unsynced_.push_back(std::move(one));
    }

    /// All, none, the first ones or any.
    template <class Changes, class Use>
    void keep_some(const Changes& changes, const Use& use) {
        const int way = dice_.below(4);
        const auto first = static_cast<std::size_t>(dice_.below(static_cast<int>(changes.size()) + 1));
        for (std::size_t k = 0; k < changes.size(); ++k)
            if (way == 0 || (way == 1 && k < first) || (way == 2 && dice_.one_in(2))) use(changes[k]);
    }

    /// What was written after a truncation that was not kept is not kept either.
    void keep_some_of(DiskFile& file) {
        bool lost = false;
        const bool tears = dice_.one_in(2);
        const std::vector<DiskFile::Change> changes = std::exchange(file.unsynced, {});
        std::vector<const DiskFile::Change*> chosen;
        keep_some(changes, [&](const DiskFile::Change& one) { chosen.push_back(&one); });
        for (const DiskFile::Change& one : changes) {
            const bool kept = std::ranges::find(chosen, &one) != chosen.end();
            lost = lost || (one.truncates && !kept);
            if (!kept || lost) continue;
            if (tears && !one.truncates)
                tear(file.kept, one);
            else
                DiskFile::apply(file.kept, one);
        }
    }

    void tear(Bytes& bytes, const DiskFile::Change& change) {
        constexpr std::array<std::size_t, 4> sizes{1, 16, 64, 512};
        const std::size_t sector = sizes[static_cast<std::size_t>(dice_.below(4))];
        if (dice_.one_in(2)) bytes.resize(std::max<std::size_t>(bytes.size(), change.offset + change.bytes.size()));
        const bool from_the_front = dice_.one_in(2);
        for (std::size_t at = 0; at < change.bytes.size(); at += sector) {
            if (dice_.one_in(from_the_front ? 4 : 2)) {
                if (from_the_front) return;
                continue;
            }
            const std::size_t end = std::min(at + sector, change.bytes.size());
            const auto begin = change.bytes.begin();
            DiskFile::apply(
                bytes,
                {change.offset + at,
                 Bytes(begin + static_cast<std::ptrdiff_t>(at), begin + static_cast<std::ptrdiff_t>(end)), false});
        }
    }

    Dice& dice_;
    int files_ = 0;
    int processes_ = 0;
    Names names_, kept_names_;
    std::vector<NameChange> unsynced_;
};

/// The process is dead. Thrown where it waits; its calls before that do nothing and say EIO.
struct Killed : std::exception {
    const char* what() const noexcept override { return "killed"; }
};

/// What happens, in the order of time, us.
class Timeline {
  public:
    std::int64_t now() const { return now_; }
    void at(std::int64_t when, std::function<void()> what) {
        events_.push({std::max(when, now_), ++count_, std::move(what)});
    }
    void in(std::int64_t delay, std::function<void()> what) { at(now_ + delay, std::move(what)); }
    std::uint64_t events() const { return count_; }

    /// Until `when` or until `is_over`.
    template <class IsOver>
    void pass(std::int64_t when, const IsOver& is_over) {
        while (!is_over() && !events_.empty() && events_.top().when <= when) {
            now_ = events_.top().when;
            const std::function<void()> what = std::move(const_cast<Event&>(events_.top()).what);
            events_.pop();
            what();
        }
        if (!is_over()) now_ = std::max(now_, when);
    }
    /// Of the next event; `otherwise` if there is none.
    std::int64_t next(std::int64_t otherwise) const { return events_.empty() ? otherwise : events_.top().when; }

  private:
    struct Event {
        std::int64_t when;
        std::uint64_t order;
        std::function<void()> what;
        bool operator<(const Event& other) const { return std::pair(when, order) > std::pair(other.when, other.order); }
    };
    std::int64_t now_ = 0;
    std::uint64_t count_ = 0;
    std::priority_queue<Event> events_;
};

/// What goes wrong in a process, by the number of the call.
struct Plan {
    static constexpr int never = -1;
    int dies = never;
    std::function<void()> power_cut = {};
    int cut = never;     ///< power_cut happens
    int error = never;   ///< the first call from here on that can have one fails
    int full = never;    ///< the disk is full from here
    int room = never;    ///< to here
    int pauses = never;  ///< of a wait: it takes two seconds longer
};

class Process final : public System {
  public:
    Process(Disk& disk, Timeline& time, Dice& dice)
        : disk_(disk), time_(time), dice_(dice), identity_(disk.next_process()) {}
    ~Process() override { kill(); }

    mutable Plan plan;
    double clock_ahead = 0;              ///< s
    std::function<void()> run_all = {};  ///< all that it computes ends at once
    mutable std::int64_t awake = 0;      ///< us, without those for which it was stopped, or waited for long

    bool alive() const { return alive_; }
    void kill() {
        if (!std::exchange(alive_, false)) return;
        for (const auto& [number, open] : open_) unlock(number, *open.file);
        open_.clear();
    }

    int open(const std::filesystem::path& path, int flags) const override {
        const std::string name = path.filename().string();
        const bool makes = (flags & O_CREAT) != 0;
        if (const int error = step(makes); error != 0) return error;
        auto file = disk_.find(name);
        if (file && makes && (flags & O_EXCL) != 0) return -EEXIST;
        if (!file && !makes) return -ENOENT;
        if (!file) file = disk_.create(name);
        if ((flags & O_TRUNC) != 0 && !file->now.empty()) file->change({0, {}, true});
        open_.emplace(++descriptors_, Open{std::move(file), (flags & O_APPEND) != 0, 0});
        return descriptors_;
    }
    void close(int number) const override {
        const auto found = open_.find(number);
        if (found == open_.end()) return;
        flush(found->second);
        unlock(number, *found->second.file);
        open_.erase(found);
    }
    std::int64_t read(int number, std::uint64_t offset, std::span<std::byte> bytes) const override {
        if (const int error = step(); error != 0) return error;
        Open& open = open_.at(number);
        flush(open);
        const Bytes& from = open.file->now;
        if (offset >= from.size()) return 0;
        std::size_t count = std::min<std::size_t>(bytes.size(), from.size() - offset);
        if (count > 1 && dice_.one_in(16)) count = 1 + static_cast<std::size_t>(dice_.below(static_cast<int>(count)));
        std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(offset), count, bytes.begin());
        return static_cast<std::int64_t>(count);
    }
    std::int64_t write(int number, std::span<const std::byte> bytes) const override {
        const bool dies = plan.dies == calls_ + 1 || plan.cut == calls_ + 1;
        if (dies && alive_) put(open_.at(number), bytes.first(some_of(bytes.size())));
        if (const int error = step(); error != 0) return error;
        Open& open = open_.at(number);
        if (disk_.full) {
            const std::size_t room = dice_.one_in(2) ? some_of(bytes.size()) : 0;
            put(open, bytes.first(room));
            return room > 0 ? static_cast<std::int64_t>(room) : -ENOSPC;
        }
        if (dice_.one_in(40)) return -EINTR;
        if (bytes.size() > 1 && dice_.one_in(20)) bytes = bytes.first(1 + some_of(bytes.size() - 1));
        put(open, bytes);
        return static_cast<std::int64_t>(bytes.size());
    }
    int truncate(int number, std::uint64_t size) const override {
        if (const int error = step(); error != 0) return error;
        Open& open = open_.at(number);
        flush(open);
        if (size != open.file->now.size()) open.file->change({size, {}, true});
        return 0;
    }
    int sync(int number) const override {
        DiskFile* file = alive_ && open_.contains(number) ? open_.at(number).file.get() : nullptr;
        if (const int error = step(); error != 0) {
            if (alive_ && file != nullptr && !file->unsynced.empty() && dice_.one_in(2)) {
                file->unsynced.clear();
                disk_.has_lost = true;
            }
            return error;
        }
        flush(open_.at(number));
        if (disk_.mutant.sync_left_out) return 0;
        if (disk_.mutant.rename_too_early && is_aside(*file)) {
            late_ = open_.at(number).file;
            return 0;
        }
        file->sync();
        return 0;
    }
    void forget_cached(int number) const override {
        if (!alive_) return;
        DiskFile& file = *open_.at(number).file;
        const std::size_t size = file.now.size();
        file.now = file.kept;
        for (const DiskFile::Change& one : file.unsynced) DiskFile::apply(file.now, one);
        file.now.resize(size);
    }
    int sync_folder(const std::filesystem::path&) const override {
        if (const int error = step(); error != 0) return error;
        if (!disk_.mutant.folder_not_synced) disk_.sync_names();
        return 0;
    }
    int facts(int number, FileFacts& facts) const override {
        if (const int error = step(); error != 0) return error;
        flush(open_.at(number));
        facts = facts_of(*open_.at(number).file);
        return 0;
    }
    int facts(const std::filesystem::path& path, FileFacts& facts) const override {
        if (const int error = step(); error != 0) return error;
        const auto file = disk_.find(path.filename().string());
        if (file) facts = facts_of(*file);
        return file ? 0 : -ENOENT;
    }
    int rename(const std::filesystem::path& from, const std::filesystem::path& to) const override {
        const std::shared_ptr<DiskFile> late = std::exchange(late_, nullptr);
        if (const int error = step(); error != 0) return error;
        const int result = disk_.rename(from.filename().string(), to.filename().string());
        late_ = late;
        return result;
    }
    int remove(const std::filesystem::path& path) const override {
        if (const int error = step(); error != 0) return error;
        return disk_.remove(path.filename().string());
    }
    std::vector<std::string> names_in(const std::filesystem::path&) const override {
        std::vector<std::string> names;
        if (step(false, false) != 0) return names;
        for (const auto& [name, file] : disk_.names()) names.push_back(name);
        return names;
    }
    int may_write_in(const std::filesystem::path&) const override { return step(); }

    int lock(int number) const override {
        if (!alive_) return -EIO;
        DiskFile& file = *open_.at(number).file;
        if (file.lock >= 0 && file.lock != key(number)) return -EAGAIN;
        file.lock = key(number);
        return 0;
    }
    bool is_locked(int number) const override {
        const auto found = open_.find(number);
        return found != open_.end() && found->second.file->lock >= 0 && found->second.file->lock != key(number);
    }

    System::Time now() const override { return System::Time(std::chrono::microseconds(time_.now())); }
    double seconds_since_1970() const override { return 1.8e9 + 1e-6 * static_cast<double>(time_.now()) + clock_ahead; }
    void sleep(std::chrono::microseconds time) const override {
        pass(time.count(), [] { return false; });
    }
    void wait(std::condition_variable&, std::unique_lock<std::mutex>& lock, std::chrono::microseconds longest,
              const std::function<bool()>& is_over) const override {
        lock.unlock();
        pass(longest.count(), is_over);
        lock.lock();
    }

    int calls() const { return calls_; }

  private:
    struct Open {
        std::shared_ptr<DiskFile> file;
        bool appends = false;
        std::uint64_t at = 0;
        Bytes late{};  ///< of a mutant: not written yet
    };

    /// Where nobody else has the number of a descriptor.
    int key(int number) const { return number + 1000 * identity_; }
    void unlock(int number, DiskFile& file) const {
        if (file.lock == key(number)) file.lock = -1;
    }

    std::size_t some_of(std::size_t size) const {
        return static_cast<std::size_t>(dice_.below(static_cast<int>(size) + 1));
    }

    /// Before each call. Not 0: the call does not happen.
    int step(bool can_fail = true, bool counts = true) const {
        if (!alive_) return -EIO;
        if (!counts) return 0;
        ++calls_;
        if (calls_ == plan.dies || calls_ == plan.cut) {
            if (calls_ == plan.cut && plan.power_cut) plan.power_cut();
            const_cast<Process*>(this)->kill();
            return -EIO;
        }
        if (late_) std::exchange(late_, nullptr)->sync();
        if (calls_ == plan.full) disk_.full = true;
        if (calls_ == plan.room) disk_.full = false;
        if (plan.error != Plan::never && calls_ >= plan.error && can_fail) {
            plan.error = Plan::never;
            return dice_.one_in(2) ? -EIO : -ENOSPC;
        }
        return 0;
    }

    bool is_aside(const DiskFile& file) const {
        return std::ranges::any_of(
            disk_.names(), [&](const auto& one) { return one.second.get() == &file && one.first.ends_with(".tmp"); });
    }

    void put(Open& open, std::span<const std::byte> bytes) const {
        flush(open);
        if (disk_.mutant.append_too_late && open.appends) {
            open.late.assign(bytes.begin(), bytes.end());
            return;
        }
        write_now(open, bytes);
    }
    void flush(Open& open) const {
        if (open.late.empty()) return;
        const Bytes late = std::exchange(open.late, {});
        write_now(open, late);
    }
    void write_now(Open& open, std::span<const std::byte> bytes) const {
        if (bytes.empty()) return;
        if (open.appends) open.at = open.file->now.size();
        open.file->change({open.at, Bytes(bytes.begin(), bytes.end()), false});
        open.file->modified = 1.8e9 + 1e-6 * static_cast<double>(time_.now());
        open.at += bytes.size();
    }
    static FileFacts facts_of(const DiskFile& file) {
        return {file.now.size(), file.modified, 1, static_cast<std::uint64_t>(file.number)};
    }

    /// A sleeper wakes when the system likes, a little late.
    template <class IsOver>
    void pass(std::int64_t longest, const IsOver& is_over) const {
        if (!alive_) {
            if (run_all) run_all();
            if (std::uncaught_exceptions() == 0) throw Killed();
            return;
        }
        constexpr std::int64_t latest = 80'000;
        constexpr std::int64_t stopped = 2'000'000;
        const std::int64_t begin = time_.now();
        std::int64_t until = std::max(begin + longest, std::min(time_.next(begin + latest), begin + latest));
        ++waits_;
        const bool is_stopped = waits_ == plan.pauses;
        if (is_stopped) until += stopped;
        time_.pass(until, [&] { return !is_stopped && (is_over() || !alive_); });
        if (longest <= latest) awake += std::min(time_.now() - begin, 2 * latest);
        if (!alive_ && std::uncaught_exceptions() == 0) {
            if (run_all) run_all();
            throw Killed();
        }
    }

    Disk& disk_;
    Timeline& time_;
    Dice& dice_;
    mutable std::map<int, Open> open_;
    mutable std::shared_ptr<DiskFile> late_;
    mutable int descriptors_ = 2;
    mutable int calls_ = 0;
    mutable int waits_ = 0;
    bool alive_ = true;
    int identity_;
};

}  // namespace floes::simulated
