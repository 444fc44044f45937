#include "faults/history.hpp"

#include <array>
#include <csignal>
#include <deque>
#include <optional>
#include <ostream>
#include <set>
#include <span>
#include <sstream>
#include <streambuf>

#include <fmt/format.h>

#include "campaign_file/publish.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "run/messages.hpp"
#include "run/run_campaign.hpp"
#include "run/saved_members.hpp"
#include "run/writer.hpp"
#include "store/file_calls.hpp"
#include "store/journal.hpp"
#include "support/synthetic.hpp"

namespace floes::simulated {

namespace {

namespace fs = std::filesystem;

constexpr const char* campaign_file = "/simulated/a.h5";
constexpr std::int64_t second = 1'000'000;           // us
constexpr std::int64_t within_a_second = 1'300'000;  // with what a sleeper comes late
constexpr SilenceLimits patience{.sign_of_life = 0.2, .with_a_worker = 0.8, .with_the_master = 2};
constexpr const char* saved_stamp_here = "this program";

double mean_of(const Campaign& campaign, int number) {
    const MemberKey key = member_key(campaign, number);
    return 100.0 * (key.case_index + 1) + key.arrangement + 1.0 / 3;
}

bool always_fails(const Campaign& campaign, int number) {
    return campaign.name == "failing" && member_key(campaign, number).arrangement % 3 == 1;
}

MemberResult result_of(const Campaign& campaign, int number) {
    if (always_fails(campaign, number)) throw MemberFailure("The ice melted.");
    MemberResult result;
    result.load.mean = mean_of(campaign, number);
    result.history.surge = {result.load.mean, 2, 3};
    return result;
}

SavedMember saved_state(const Campaign& campaign, int number) {
    return {
        .wall_time = 1, .cpu_time = 1, .state = Bytes(40 + number, static_cast<std::byte>(mean_of(campaign, number)))};
}

std::string line_of(int number, const MemberRecord* record) {
    if (record == nullptr) return fmt::format("{} missing\n", number);
    if (record->result.status != MemberStatus::done) return fmt::format("{} failed\n", number);
    return fmt::format("{} done {}\n", number, record->result.load.mean);
}

std::string with_digest(const std::string& lines) {
    return lines + digest_hex(lines);
}

constexpr std::size_t digest_length = 32;

bool is_whole(const std::string& content) {
    return content.size() >= digest_length && with_digest(content.substr(0, content.size() - digest_length)) == content;
}

/// As match_records(), which takes the fingerprints of all cases anew, most of the time of a history.
std::vector<std::optional<std::size_t>> records_that_count(const Subject& subject, const MemberNotes& notes) {
    std::vector<std::optional<std::size_t>> kept(static_cast<std::size_t>(member_count(subject.campaign)));
    std::map<int, int> case_of;  // by number of its key
    for (std::size_t k = 0; k < subject.case_keys.size(); ++k)
        if (const auto key = notes.keys().find(subject.case_keys[k]); key != notes.keys().end())
            case_of[key->second] = static_cast<int>(k);
    for (std::size_t k = 0; k < notes.size(); ++k) {
        const int cases = static_cast<int>(subject.case_keys.size());
        auto& known = kept.at(static_cast<std::size_t>(notes[k].arrangement * cases + case_of.at(notes[k].key)));
        if (!known || !notes[*known].done()) known = k;
    }
    return kept;
}

/// Stands for HDF5, as the next does.
void write_text(const System& system, const fs::path& path, const Subject& subject, const StoredMembers& members) {
    std::string lines;
    const auto kept = records_that_count(subject, members.notes());
    for (int number = 0; number < member_count(subject.campaign); ++number) {
        const auto& record = kept[static_cast<std::size_t>(number)];
        const std::optional<MemberRecord> found = record ? std::optional(members.read(*record)) : std::nullopt;
        lines += line_of(number, found ? &*found : nullptr);
    }
    const std::string all = with_digest(lines);
    const auto bytes = std::as_bytes(std::span(all));
    const OpenFile file = open_file(path, O_WRONLY | O_CREAT | O_TRUNC, system);
    write_all(file, bytes.first(bytes.size() / 2));
    write_all(file, bytes.subspan(bytes.size() / 2));
}

FiledCampaign read_text(const Subject& subject, const std::string& text) {
    if (!is_whole(text)) throw RunError("the campaign file is damaged");
    FiledCampaign filed{.campaign = subject.campaign, .notes = {}, .read = {}, .sessions = {}, .calibrations = {}};
    std::vector<MemberRecord> records;
    std::istringstream lines(text);
    int arrangements = 0;
    for (std::string line; std::getline(lines, line);) {
        int number = 0;
        double mean = 0;
        const int found = std::sscanf(line.c_str(), "%d done %lf", &number, &mean);
        if (found < 1 || line.size() == digest_length) continue;
        const MemberKey key = member_key(subject.campaign, number);
        arrangements = key.arrangement + 1;
        if (found < 2) continue;
        MemberRecord& record = records.emplace_back();
        record.case_key = subject.case_keys[static_cast<std::size_t>(key.case_index)];
        record.arrangement = key.arrangement;
        record.result = result_of(subject.campaign, number);
        record.result.load.mean = mean;
        filed.notes.add(record);
    }
    filed.campaign.arrangements = arrangements;
    filed.read = [records = std::move(records)](std::size_t k) { return records.at(k); };
    return filed;
}

std::string text_of(const System& system, const fs::path& path) {
    const OpenFile file = open_file(path, O_RDONLY, system);
    Bytes bytes(file_size(file));
    read_at(file, 0, bytes);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

class Session;

/// What outlives a session.
class World {
  public:
    World(const Subject& of, std::uint64_t seed, const Mutant& mutant)
        : subject(&of),
          keeps_journals(seed % 2 == 1),
          grows(seed % 4 == 2),
          dice(seed),
          disk(dice, mutant),
          reader(disk, time, dice) {}

    std::string run();

    /// The first thing that does not hold counts.
    void fault(std::string what) {
        if (fault_.empty()) fault_ = std::move(what);
    }
    void power_cut();
    /// Somebody was told that so many members have an answer.
    void told(int count, std::int64_t awake, bool at_once) {
        told_.push_back({count, awake});
        most_told_ = std::max(most_told_, count);
        if (count > member_count(subject->campaign)) fault(fmt::format("{} members are counted", count));
        if (at_once) promised_ = std::max(promised_, count);
    }
    void forget_told() {
        told_.clear();
        most_told_ = promised_ = 0;
    }
    /// All that was told is on the disk.
    void promise_all() { promised_ = std::max(promised_, most_told_); }
    /// What was told before then is.
    void promise_until(std::int64_t awake) {
        for (const auto& [count, when] : told_)
            if (when <= awake) promised_ = std::max(promised_, count);
    }
    void end_of_session() { told_.clear(); }

    void read_meanwhile();
    /// For the account, if there is to be one.
    template <class... Words>
    void note(fmt::format_string<Words...> form, Words&&... words) {
        if (account == nullptr) return;
        *account += fmt::format("{:9.6f} s  ", 1e-6 * static_cast<double>(time.now()));
        *account += fmt::format(form, std::forward<Words>(words)...) + "\n";
    }

    const Subject* subject;     ///< later one with more arrangements, where the campaign grows
    const bool keeps_journals;  ///< also of a campaign that is whole in its file
    const bool grows;
    Dice dice;
    Timeline time;
    Disk disk;
    Process reader;
    bool was_cut = false;
    std::vector<std::unique_ptr<Session>> sessions;
    std::string* account = nullptr;

  private:
    bool one_session(bool undisturbed);
    int kept_members();
    void keep_those_of_journal(std::vector<bool>& kept);
    void end_undisturbed();
    void check_kept();
    void check_end();

    std::string fault_;
    std::vector<std::pair<int, std::int64_t>> told_;  // of this session
    int most_told_ = 0;                               // since the last power cut
    int promised_ = 0;                                // to outlast one
    bool has_published_ = false;
};

/// Executes tasks when their time has come.
class SimulatedCores final : public Cores {
  public:
    SimulatedCores(World& world, int threads, bool slow) : world_(world), free_(threads), slow_(slow) {}

    void begin(std::int64_t, std::function<void()> task) override {
        waiting_.push_back(std::move(task));
        begin_next();
    }
    void run_all() {
        while (!under_way_.empty() || !waiting_.empty()) {
            std::map<int, std::function<void()>> tasks = std::exchange(under_way_, {});
            for (auto& [number, task] : tasks) task();
            std::deque<std::function<void()>> rest = std::exchange(waiting_, {});
            for (auto& task : rest) task();
        }
    }

  private:
    void begin_next() {
        if (free_ == 0 || waiting_.empty()) return;
        --free_;
        const int number = ++tasks_;
        under_way_.emplace(number, std::move(waiting_.front()));
        waiting_.pop_front();
        world_.time.in(world_.dice.between(5'000, slow_ ? 900'000 : 150'000), [this, number] {
            auto node = under_way_.extract(number);
            if (node.empty()) return;
            node.mapped()();
            ++free_;
            begin_next();
        });
    }

    World& world_;
    int free_;
    bool slow_;
    int tasks_ = 0;
    std::map<int, std::function<void()>> under_way_;
    std::deque<std::function<void()>> waiting_;
};

class RankLink final : public Link {
  public:
    RankLink(Session& session, int rank, int size, const Process& process)
        : session_(session), rank_(rank), size_(size), process_(process) {}

    int rank() const override { return rank_; }
    int size() const override { return size_; }
    const Topology& topology() const override { return topology_; }
    void send(int to, Tag tag, std::vector<std::byte> bytes) override;
    std::optional<Message> poll() override {
        if (inbox.empty() || !process_.alive()) return std::nullopt;
        Message first = std::move(inbox.front());
        inbox.pop_front();
        return first;
    }
    void abandon(int rank) override { abandoned_.insert(rank); }
    bool moving() const override { return false; }

    std::deque<Message> inbox;

  private:
    Session& session_;
    int rank_;
    int size_;
    const Process& process_;
    Topology topology_{};
    std::set<int> abandoned_;
};

/// A rank other than the master: its messages are played, its Writer is the real one.
class PlayedRank {
  public:
    PlayedRank(Session& session, int rank, int size);

    void take(Message message);
    void tick();
    /// Nothing is said or heard for so long.
    void sleep(std::int64_t time);
    void die();
    bool is_there() const { return process.alive() && !left_; }
    bool is_writer() const { return writer_.has_value(); }

    Process process;
    RankLink link;

  private:
    void obey(const Message& message);
    void open(const std::string& journal);
    void begin_next();
    void finish(const Assignment& assignment);
    void say_farewell();
    void leave();
    template <class Work>
    void in_trouble_if_it_fails(const Work& work);

    Session& session_;
    World& world_;
    int rank_;
    int keeper_ = 0;
    std::string journal_;
    std::optional<Writer> writer_;
    std::deque<Assignment> waiting_;
    bool busy_ = false;
    bool dismissed_ = false;
    bool said_farewell_ = false;
    bool left_ = false;
    std::int64_t asleep_until_ = 0;
    std::int64_t heard_ = 0;
};

/// One start of the program.
class Session {
  public:
    Session(World& world, bool undisturbed);

    /// The exit status; none if it was killed. Throws InputError as run_campaign() does.
    std::optional<int> run();

    void deliver(int from, int to, Message message);
    void kill_all();
    bool is_over() const;
    /// Of what was told until then the master has had the time to sync its own; other writers sync before they tell.
    std::int64_t sure_until() const { return master.awake - within_a_second; }

    World& world;
    Process master;

  private:
    void plan_faults();
    void plan_ranks_faults();
    void somebody_starts_another();
    MemberFunction compute();
    RunOptions options(int writers);

    int size_;
    int threads_;
    bool undisturbed_;
    Existing existing_ = Existing::resume;
    bool saves_;
    SimulatedCores cores_;
    RankLink link_;
    std::vector<std::unique_ptr<PlayedRank>> ranks_;
    std::vector<std::int64_t> last_delivery_;
};

void RankLink::send(int to, Tag tag, std::vector<std::byte> bytes) {
    if (process_.alive() && !abandoned_.contains(to)) session_.deliver(rank_, to, {rank_, tag, std::move(bytes)});
}

// -- a rank

PlayedRank::PlayedRank(Session& session, int rank, int size)
    : process(session.world.disk, session.world.time, session.world.dice),
      link(session, rank, size, process),
      session_(session),
      world_(session.world),
      rank_(rank),
      heard_(session.world.time.now()) {
    world_.time.in(20'000, [this] { tick(); });
}

template <class Work>
void PlayedRank::in_trouble_if_it_fails(const Work& work) {
    try {
        work();
    } catch (const std::exception& error) {
        writer_.reset();
        link.send(master_rank, Tag::trouble, encode(std::string(error.what())));
    }
}

void PlayedRank::take(Message message) {
    if (!is_there()) return;
    if (world_.time.now() < asleep_until_) {
        world_.time.at(asleep_until_, [this, message = std::move(message)]() mutable { take(std::move(message)); });
        return;
    }
    if (message.from == master_rank) heard_ = world_.time.now();
    in_trouble_if_it_fails([&] { obey(message); });
}

void PlayedRank::obey(const Message& message) {
    switch (message.tag) {
        case Tag::post: {
            const Post post = decode<Post>(message.bytes);
            keeper_ = post.writer;
            journal_ = post.journal;
            return;
        }
        case Tag::campaign:
            if (!journal_.empty()) writer_.emplace(link, world_.subject->campaign, journal_, process);
            link.send(master_rank, Tag::hello, encode(Hello{1, "elsewhere", world_.subject->fingerprint, rank_}));
            return;
        case Tag::assign:
            for (const Assignment& one : decode<std::vector<Assignment>>(message.bytes)) waiting_.push_back(one);
            begin_next();
            return;
        case Tag::answer:
            for (const Answer& one : decode<std::vector<Answer>>(message.bytes))
                if (writer_) writer_->keep(message.from, one);
            return;
        case Tag::farewell:
            if (writer_) writer_->farewell(message.from);
            return;
        case Tag::dismiss:
            dismissed_ = true;
            waiting_.clear();
            say_farewell();
            return;
        case Tag::close:
            if (writer_) writer_->sync();
            writer_.reset();
            link.send(master_rank, Tag::closed, {});
            return;
        case Tag::leave:
            leave();
            return;
        default:
            return;
    }
}

void PlayedRank::say_farewell() {
    if (!dismissed_ || busy_ || said_farewell_) return;
    said_farewell_ = true;
    link.send(writer_ ? master_rank : keeper_, Tag::farewell, {});
}

void PlayedRank::begin_next() {
    if (busy_ || waiting_.empty()) return;
    busy_ = true;
    const Assignment next = waiting_.front();
    waiting_.pop_front();
    world_.time.in(world_.dice.between(5'000, 200'000), [this, next] { finish(next); });
}

void PlayedRank::finish(const Assignment& assignment) {
    if (!is_there()) return;
    if (world_.time.now() < asleep_until_) {
        world_.time.at(asleep_until_, [this, assignment] { finish(assignment); });
        return;
    }
    busy_ = false;
    if (dismissed_) return say_farewell();
    MemberRecord record;
    const Campaign& campaign = world_.subject->campaign;
    const MemberKey key = member_key(campaign, assignment.number);
    record.case_key = world_.subject->case_keys[static_cast<std::size_t>(key.case_index)];
    record.arrangement = key.arrangement;
    record.attempt = assignment.attempt;
    record.rank = rank_;
    try {
        record.result = result_of(campaign, assignment.number);
    } catch (const MemberFailure& failure) {
        record.result.status = MemberStatus::failed;
        record.result.reason = failure.what();
    }
    record.result.wall_time = 0.1;
    const bool failed = record.result.status != MemberStatus::done;
    const std::vector<Answer> answer{{assignment.number, record}};
    for (int times = world_.dice.one_in(10) ? 2 : 1; times > 0; --times) {
        if (failed && keeper_ != master_rank)
            link.send(master_rank, Tag::answer, encode(answer));
        else if (writer_)
            in_trouble_if_it_fails([&] { writer_->keep(rank_, answer[0]); });
        else
            link.send(keeper_, Tag::answer, encode(answer));
    }
    begin_next();
}

void PlayedRank::tick() {
    if (!is_there()) return;
    const std::int64_t now = world_.time.now();
    if (now < asleep_until_) {
        world_.time.at(asleep_until_, [this] { tick(); });
        return;
    }
    if (writer_) in_trouble_if_it_fails([&] { writer_->tend(); });
    link.send(master_rank, Tag::alive, {});
    if (static_cast<double>(now - heard_) > patience.with_the_master * second) return leave();
    world_.time.in(60'000, [this] { tick(); });
}

void PlayedRank::sleep(std::int64_t time) {
    world_.note("rank {} sleeps", rank_);
    asleep_until_ = world_.time.now() + time;
    heard_ += time;
}

void PlayedRank::die() {
    process.kill();
    world_.note("rank {} dies", rank_);
}

void PlayedRank::leave() {
    left_ = true;
    writer_.reset();
    process.kill();
}

// -- a session

Session::Session(World& of, bool undisturbed)
    : world(of),
      master(of.disk, of.time, of.dice),
      size_(of.dice.one_in(2) ? 1 : of.dice.between(2, 4)),
      threads_(of.dice.between(1, 2)),
      undisturbed_(undisturbed),
      saves_(of.dice.one_in(4)),
      cores_(of, threads_, of.dice.one_in(4)),
      link_(*this, 0, size_, master),
      last_delivery_(static_cast<std::size_t>(size_ * size_)) {
    master.run_all = [this] { cores_.run_all(); };
}

void Session::deliver(int from, int to, Message message) {
    std::int64_t& last = last_delivery_[static_cast<std::size_t>(from * size_ + to)];
    last = std::max(last + 1, world.time.now() + world.dice.between(20, 2000));
    world.time.at(last, [this, to, message = std::move(message)]() mutable {
        if (to == master_rank) {
            if (master.alive()) link_.inbox.push_back(std::move(message));
        } else {
            ranks_[static_cast<std::size_t>(to - 1)]->take(std::move(message));
        }
    });
}

void Session::kill_all() {
    master.kill();
    for (const auto& rank : ranks_) rank->process.kill();
}

bool Session::is_over() const {
    return std::ranges::none_of(ranks_, [](const auto& rank) { return rank->is_there(); });
}

MemberFunction Session::compute() {
    return [this](const Campaign& campaign, int number, const Attempting&) {
        if (saves_) {
            const fs::path path =
                saved_path(campaign_file,
                           {world.subject->case_keys[static_cast<std::size_t>(member_key(campaign, number).case_index)],
                            member_key(campaign, number).arrangement});
            try {
                const std::optional<SavedMember> before = read_saved(path, saved_stamp_here, master);
                if (before && before->state != saved_state(campaign, number).state)
                    world.fault(fmt::format("member {} went on from another state than was saved", number));
                write_saved(path, saved_stamp_here, saved_state(campaign, number), master);
            } catch (const std::exception& error) {
                const std::string why = error.what();
                if (why.starts_with("it")) world.fault(fmt::format("a saved member cannot be used: {}", why));
            }
        }
        return result_of(campaign, number);
    };
}

RunOptions Session::options(int writers) {
    RunOptions made{
        .places = {.campaign_file = campaign_file,
                   .existing = existing_,
                   .publish_every = std::chrono::seconds(world.dice.one_in(2) ? 60 : world.dice.between(0, 2)),
                   .system = master,
                   .content =
                       [this](const fs::path& path, const Campaign&, const StoredMembers& members,
                              std::span<const floes::Session>, std::span<const CalibrationRecord>) {
                           write_text(master, path, *world.subject, members);
                       },
                   .filed = [this](const fs::path& path) { return read_text(*world.subject, text_of(master, path)); },
                   .keep_journal = world.keeps_journals},
        .threads = threads_,
        .writers = writers,
        .resume_command = "the same",
        .patience = patience,
        .saves_every = saves_ ? 1.0 : 0.0,
        .cores = {&cores_, 0}};
    return made;
}

void Session::plan_faults() {
    Dice& dice = world.dice;
    Plan& plan = master.plan;
    constexpr std::array begins{15, 60, 300};  // most calls of a session are made when it begins
    const int calls = begins[static_cast<std::size_t>(dice.below(3))];
    master.clock_ahead = dice.one_in(4) ? 1e8 * dice.between(-3, 3) : 0;
    switch (dice.below(8)) {
        case 0:
        case 1:
            plan.dies = dice.between(1, calls);
            break;
        case 2:
        case 3:
            plan.cut = dice.between(1, calls);
            break;
        case 4:
            plan.error = dice.between(1, calls);
            break;
        case 5:
            plan.full = dice.between(1, calls);
            plan.room = plan.full + dice.between(1, 80);
            break;
        case 6:
            world.time.in(dice.between(10'000, 1'500'000), [this] {
                if (master.alive()) std::raise(SIGTERM);
            });
            break;
        default:
            world.time.in(dice.between(10'000, 2'000'000), [this] {
                if (!master.alive()) return;
                if (world.dice.one_in(2)) return master.kill();
                world.power_cut();
            });
    }
    plan.power_cut = [this] { world.power_cut(); };
    if (dice.one_in(6)) plan.pauses = dice.between(1, 30);
    if (dice.one_in(4)) world.time.in(dice.between(1'000, 800'000), [this] { somebody_starts_another(); });
    if (dice.one_in(3))
        for (int k = 0; k < 6; ++k)
            world.time.in(dice.between(1'000, 1'200'000), [this] {
                if (master.alive()) world.read_meanwhile();
            });
    plan_ranks_faults();
}

void Session::plan_ranks_faults() {
    Dice& dice = world.dice;
    for (const auto& rank : ranks_) {
        PlayedRank* one = rank.get();
        if (dice.one_in(8)) one->process.plan.dies = dice.between(1, 60);
        if (dice.one_in(16)) one->process.plan.error = dice.between(1, 60);
        if (dice.one_in(16)) {
            one->process.plan.cut = dice.between(1, 60);
            one->process.plan.power_cut = [this] { world.power_cut(); };
        }
        if (dice.one_in(8)) world.time.in(dice.between(5'000, 800'000), [one] { one->die(); });
        const int time = dice.between(100'000, 2'500'000);
        if (dice.one_in(6)) world.time.in(dice.between(5'000, 800'000), [one, time] { one->sleep(time); });
    }
}

void Session::somebody_starts_another() {
    if (!master.alive()) return;
    const Process other(world.disk, world.time, world.dice);
    constexpr std::array ways{Existing::resume, Existing::replace, Existing::refuse};
    try {
        const Recorder recorder(
            world.subject->campaign,
            {.campaign_file = campaign_file,
             .existing = ways[static_cast<std::size_t>(world.dice.below(3))],
             .system = other,
             .filed = [&](const fs::path& path) { return read_text(*world.subject, text_of(other, path)); }});
        world.fault("a second run was let into the file of the first");
    } catch (const InputError&) {
        // as it should be
    }
}

/// Hears what the run tells.
class Ear final : public std::streambuf {
  public:
    Ear(World& world, const Process& process) : world_(world), process_(process) {}

  protected:
    int overflow(int letter) override {
        if (letter == '\n')
            hear();
        else
            line_.push_back(static_cast<char>(letter));
        return letter;
    }
    std::streamsize xsputn(const char* text, std::streamsize count) override {
        for (std::streamsize k = 0; k < count; ++k) overflow(static_cast<unsigned char>(text[k]));
        return count;
    }

  private:
    void hear() {
        const std::string line = std::exchange(line_, {});
        if (!process_.alive()) return;
        world_.note("{}", line);
        int done = 0;
        int total = 0;
        int failed = 0;
        if (std::sscanf(line.c_str(), "floes: %d of %d done, %d failed", &done, &total, &failed) >= 2)
            world_.told(done + failed, process_.awake, false);
        else if (std::sscanf(line.c_str(), "floes: resumed: %d member", &done) == 1)
            world_.told(done, process_.awake, true);
    }

    World& world_;
    const Process& process_;
    std::string line_;
};

std::optional<int> Session::run() {
    for (int rank = 1; rank < size_; ++rank) ranks_.push_back(std::make_unique<PlayedRank>(*this, rank, size_));
    const int writers = world.dice.one_in(2) ? 0 : world.dice.between(1, size_);
    if (!undisturbed_) {
        if (world.dice.one_in(12)) {
            existing_ = Existing::replace;
            world.forget_told();
        }
        plan_faults();
    }
    world.note("a session of {} ranks, {} writers{}; call {} kills, {} cuts the power, {} fails, {} to {} find no room",
               size_, writers, existing_ == Existing::replace ? ", afresh" : "", master.plan.dies, master.plan.cut,
               master.plan.error, master.plan.full, master.plan.room);
    Ear ear(world, master);
    std::ostream out(&ear);
    std::optional<int> status;
    try {
        Progress progress(out, Progress::Style::plain);
        status = run_campaign(world.subject->campaign, options(writers), link_, compute(), progress);
    } catch (const Killed&) {
        // no status
    } catch (const RunError& error) {
        world.note("{}", error.what());
        if (undisturbed_) world.fault(fmt::format("a run that nobody disturbed failed: {}", error.what()));
        status = 1;
    }
    if (!master.alive()) return {};
    for (int rank = 1; rank < size_; ++rank) link_.send(rank, Tag::leave, encode(0));
    return status;
}

// -- the world

void World::power_cut() {
    for (const auto& session : sessions) {
        if (session->master.alive()) promise_until(session->sure_until());
        session->kill_all();
    }
    disk.power_cut();
    was_cut = true;
    note("a power cut");
}

void World::read_meanwhile() {
    try {
        if (is_there(campaign_file, reader)) {
            if (!is_whole(text_of(reader, campaign_file))) fault("a reader found half a campaign file");
        }
        if (is_there(journal_path(campaign_file), reader)) read_journal(journal_path(campaign_file), reader);
    } catch (const InputError& error) {
        if (!std::string_view(error.what()).ends_with("is still empty."))
            fault(fmt::format("a reader was refused: {}", error.what()));
    }
}

/// In the journal or in the campaign file.
int World::kept_members() {
    std::vector<bool> kept(static_cast<std::size_t>(member_count(subject->campaign)));
    keep_those_of_journal(kept);
    if (is_there(campaign_file, reader)) {
        const std::string content = text_of(reader, campaign_file);
        const MemberNotes notes = is_whole(content) ? read_text(*subject, content).notes : MemberNotes();
        const auto records = records_that_count(*subject, notes);
        for (std::size_t k = 0; k < kept.size(); ++k) kept[k] = kept[k] || records[k];
    }
    return static_cast<int>(std::ranges::count(kept, true));
}

void World::keep_those_of_journal(std::vector<bool>& kept) {
    const fs::path journal = journal_path(campaign_file);
    if (!is_there(journal, reader)) return;
    std::optional<JournalContents> contents;
    try {
        contents = read_journal(journal, reader);
    } catch (const InputError&) {
        return;  // a journal that is not begun; others have members, which are missed then
    }
    const auto records = records_that_count(*subject, contents->members);
    for (std::size_t k = 0; k < kept.size(); ++k) {
        if (!records[k]) continue;
        const MemberNote& note = contents->members[*records[k]];
        kept[k] = note.done() || note.attempt >= subject->campaign.run.attempts;
    }
    std::set<std::pair<int, int>> done;
    for (std::size_t k = 0; k < contents->members.size(); ++k) {
        const MemberNote& note = contents->members[k];
        if (contents->places[k].piece == 0 && note.done() && !done.emplace(note.key, note.arrangement).second)
            fault("a member is twice in the journal");
    }
}

void World::check_kept() {
    const int kept = kept_members();
    const bool was_lost = std::exchange(disk.has_lost, false);
    note("{} members are left, {} were told, {} of them to be on the disk", kept, most_told_, promised_);
    const int wanted = was_cut || was_lost ? promised_ : most_told_;
    if (kept < wanted)
        fault(fmt::format("{} members are left of {} that were told to be {}", kept, wanted,
                          was_cut    ? "on the disk, after a power cut"
                          : was_lost ? "on the disk, after a sync that failed"
                                     : "done, after the end of the process"));
    if (is_there(campaign_file, reader) && !is_whole(text_of(reader, campaign_file)))
        fault(was_cut ? "half a campaign file is left after a power cut" : "half a campaign file is left");
    if (was_cut || was_lost) most_told_ = std::min(kept, most_told_);
    if (was_cut) promised_ = most_told_;
    was_cut = false;
}

bool World::one_session(bool undisturbed) {
    Session& session = *sessions.emplace_back(std::make_unique<Session>(*this, undisturbed));
    bool complete = false;
    try {
        const std::optional<int> status = session.run();
        complete = status && (*status == 0 || (*status == 1 && undisturbed));
        if (status && (*status == 0 || *status == exit_stopped)) promise_all();
        if (undisturbed && !complete)
            fault(fmt::format("a run that nobody disturbed ended with {}", status.value_or(-1)));
    } catch (const InputError& error) {
        note("{}", error.what());
        if (undisturbed) fault(fmt::format("the campaign cannot be resumed: {}", error.what()));
    }
    promise_until(session.sure_until());
    session.master.kill();
    disk.full = false;
    end_of_session();
    check_kept();
    note("the session has made {} calls", session.master.calls());
    return complete;
}

void World::check_end() {
    if (!is_there(campaign_file, reader)) return fault("there is no campaign file at the end");
    const std::string content = text_of(reader, campaign_file);
    if (content != subject->content) fault(fmt::format("the file is not that of an undisturbed run:\n{}", content));
}

void World::end_undisturbed() {
    time.pass(time.now() + 10 * second,
              [&] { return std::ranges::all_of(sessions, [](const auto& session) { return session->is_over(); }); });
    if (!fault_.empty() || !one_session(true)) return;
    check_end();
    const fs::path journal = journal_path(campaign_file);
    if (!keeps_journals && subject->set_aside == 0 &&
        (is_there(journal, reader) || !pieces_of(journal, reader).empty()))
        fault("a journal is left of a campaign that is whole in its file");
    promise_all();
    power_cut();
    check_kept();
    check_end();
}

std::string World::run() {
    const int disturbed = dice.between(1, 3);
    for (int k = 0; k < disturbed && fault_.empty(); ++k) {
        one_session(false);
        if (dice.one_in(4)) power_cut(), check_kept();
        const bool waits = dice.one_in(2);
        time.pass(time.now() + (waits ? 4 * second : dice.between(0, 300'000)), [] { return false; });
    }
    end_undisturbed();
    if (!grows || !fault_.empty()) return fault_;
    note("the campaign grows");
    subject = subject->grown.get();
    one_session(false);
    if (dice.one_in(2)) power_cut(), check_kept();
    end_undisturbed();
    return fault_;
}

}  // namespace

namespace {

Subject make_subject(const char* name, int arrangements, std::size_t cases) {
    Campaign campaign = synthetic::campaign(arrangements);
    campaign.name = name;
    campaign.cases.resize(cases);
    campaign.run.member_deadline = 0;
    Subject subject{campaign, fingerprint(campaign), case_fingerprints(campaign), {}, 0, {}};
    std::string lines;
    for (int number = 0; number < member_count(campaign); ++number) {
        MemberRecord record;
        record.result.load.mean = mean_of(campaign, number);
        if (always_fails(campaign, number)) record.result.status = MemberStatus::failed, ++subject.set_aside;
        lines += line_of(number, &record);
    }
    subject.content = with_digest(lines);
    return subject;
}

}  // namespace

std::vector<Subject> make_subjects() {
    std::vector<Subject> subjects;
    for (const char* name : {"sound", "failing"}) {
        for (const int arrangements : {1, 3, 5}) {
            const std::size_t cases = arrangements == 3 ? 2 : 1;
            Subject& subject = subjects.emplace_back(make_subject(name, arrangements, cases));
            subject.grown = std::make_shared<Subject>(make_subject(name, arrangements + 1, cases));
        }
    }
    return subjects;
}

std::string history(const std::vector<Subject>& subjects, std::uint64_t seed, const Mutant& mutant,
                    std::string* account) {
    World world(subjects[seed % subjects.size()], seed, mutant);
    world.account = account;
    return world.run();
}

}  // namespace floes::simulated
