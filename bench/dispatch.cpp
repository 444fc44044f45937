// floes_dispatch MEMBERS MILLISECONDS STEPS THREADS WRITERS FOLDER: the real driver, with its journal in FOLDER, on
// members that only sleep and give histories of so many steps. Alone or under mpirun. Every rank prints a line of JSON:
// where its processor time went. The line of rank 0 has the times as well, beside those that the simulated run gives.

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "campaign_file/pieces.hpp"
#include "campaign_file/publish.hpp"
#include "run/hands.hpp"
#include "run/link.hpp"
#include "run/plan.hpp"
#include "run/run_campaign.hpp"
#include "run/worker.hpp"

namespace {

using namespace floes;
using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Of this thread or process, by its clock, s.
double processor_time(clockid_t whose) {
    timespec time{};
    ::clock_gettime(whose, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Six floes, one case, so many members and steps.
Campaign campaign_of(int members, int steps) {
    Scenario scenario;
    scenario.field.floes = 6;
    scenario.field.concentration = 0.3;
    scenario.structure.speed = 3.5 / (steps * scenario.general.time_step);
    const int window = steps / 6 * 3;  // three segments
    scenario.analysis = {(steps - window) * scenario.general.time_step, window * scenario.general.time_step, 3};
    return {"dispatch", 1, members, {{"sleeping", scenario}}};
}

/// As hard to compress as loads are.
std::vector<double> noise(std::size_t count, std::uint64_t state) {
    std::vector<double> values(count);
    for (double& value : values) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        value = static_cast<double>(state >> 11);
    }
    return values;
}

MemberFunction sleeper(std::chrono::duration<double> duration, std::size_t steps) {
    return [=](const Campaign&, int number, std::stop_token) {
        if (duration.count() > 0) std::this_thread::sleep_for(duration);
        MemberResult result;
        result.load.segment_maximum.resize(3);
        for (auto* history : {&result.history.surge, &result.history.sway, &result.history.heave})
            *history = noise(steps, static_cast<std::uint64_t>(number));
        result.arrangement.resize(6);
        return result;
    };
}

/// What the simulated run gives for the same members, without the launch, which is over when the clock begins.
Forecast forecast_of(const Campaign& campaign, double duration, double record_bytes, int cores, int ranks, int writers,
                     int processors = static_cast<int>(std::thread::hardware_concurrency())) {
    PlannedMembers planned = expected_members(campaign);
    set_record_bytes(planned, record_bytes);  // noise packs worse than loads do
    for (SimulatedMember& member : planned.members) member.run_time = duration;
    DriverCosts costs = measured_costs();
    costs.start_up = 0;
    costs.start_up_per_rank = 0;
    Machine machine = machine_of(cores, ranks);
    machine.processors = processors;
    machine.writers = writers;
    return simulate(planned.members, machine, costs);
}

/// What publishing by so many hands costs, s of processor time, one after another in this process: the orders, all
/// pieces and the dearest, the file that refers to them, and all digests.
nlohmann::ordered_json costs_of_hands(const Campaign& campaign, const JournalContents& contents,
                                      const std::filesystem::path& file, int hands) {
    const double begin = processor_time(CLOCK_THREAD_CPUTIME_ID);
    std::vector<Bytes> orders;
    FoundSizes most{};
    for (const PieceOrder& order : piece_orders(campaign, contents, file, hands)) {
        most = order.most;
        orders.push_back(encode(order));
    }
    const double ordered = processor_time(CLOCK_THREAD_CPUTIME_ID) - begin;
    make_piece_folder(file);
    std::vector<FilePiece> pieces;
    double all = 0;
    double dearest = 0;
    for (const Bytes& order : orders) {
        const PieceMade made = make_piece(campaign, decode<PieceOrder>(order));
        if (!made.trouble.empty()) throw std::runtime_error(made.trouble);
        pieces.push_back(made.piece);
        all += made.processor_time;
        dearest = std::max(dearest, made.processor_time);
    }
    double digesting = 0;
    double texts = 0;
    const double before = processor_time(CLOCK_THREAD_CPUTIME_ID);
    publish_over_pieces(file, campaign, pieces, most, contents.sessions, {},
                        [&](const std::filesystem::path& over, const std::vector<std::string>& datasets) {
                            const double from = processor_time(CLOCK_THREAD_CPUTIME_ID);
                            std::vector<std::vector<std::string>> shares(static_cast<std::size_t>(hands));
                            for (std::size_t k = 0; k < datasets.size(); ++k)
                                shares[k % shares.size()].push_back(datasets[k]);
                            DatasetDigests digests;
                            for (const auto& share : shares) digests.merge(digests_over_pieces(over, pieces, share));
                            digesting = processor_time(CLOCK_THREAD_CPUTIME_ID) - from;
                            digests_over_pieces(over, pieces, std::array{std::string("/provenance/host")});
                            texts = processor_time(CLOCK_THREAD_CPUTIME_ID) - from - digesting;
                            return digests;
                        });
    const double index = processor_time(CLOCK_THREAD_CPUTIME_ID) - before - digesting - texts;
    return {{"orders", ordered}, {"pieces", all},        {"dearest_piece", dearest},
            {"index", index},    {"digests", digesting}, {"digest_of_texts", texts}};
}

/// What a message costs this rank, s of processor time: `send` one to, `receive` one from another rank. Ranks 0 and 1
/// exchange many at once; the others take no part.
nlohmann::ordered_json message_costs(Link& link) {
    constexpr int messages = 200;
    if (link.size() == 1 || link.rank() > 1) return {};
    const double begin = processor_time(CLOCK_THREAD_CPUTIME_ID);
    for (int i = 0; i < messages; ++i) link.send(1 - link.rank(), Tag::alive, {});
    const double sent = processor_time(CLOCK_THREAD_CPUTIME_ID);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));  // they are all there when the clock goes on
    const double all_there = processor_time(CLOCK_THREAD_CPUTIME_ID);
    for (int taken = 0; taken < messages;) taken += link.poll() ? 1 : 0;
    return {{"send", (sent - begin) / messages},
            {"receive", (processor_time(CLOCK_THREAD_CPUTIME_ID) - all_there) / messages}};
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 7) {
        fmt::print(stderr, "Usage: floes_dispatch MEMBERS MILLISECONDS STEPS THREADS WRITERS FOLDER\n");
        return 2;
    }
    const int members = std::atoi(arguments[1]);
    const double duration = 1e-3 * std::atof(arguments[2]);
    const int steps = std::atoi(arguments[3]);
    const int threads = std::atoi(arguments[4]);
    const int writers = std::atoi(arguments[5]);
    const std::filesystem::path file = std::filesystem::path(arguments[6]) / "dispatch.h5";
    const MemberFunction compute = sleeper(std::chrono::duration<double>(duration), static_cast<std::size_t>(steps));

    const std::unique_ptr<Link> link = open_link();
    const nlohmann::ordered_json of_message = message_costs(*link);
    const auto inside = Clock::now();
    const double thread_before = processor_time(CLOCK_THREAD_CPUTIME_ID);
    const double process_before = processor_time(CLOCK_PROCESS_CPUTIME_ID);
    nlohmann::ordered_json line{{"rank", link->rank()}, {"ranks", link->size()}, {"message_s", of_message}};
    int status = 0;
    if (link->rank() != 0) {
        status = serve_campaign(*link, threads, compute);
    } else {
        status = lead_ranks(*link, std::cerr, [&] {
            const Campaign campaign = campaign_of(members, steps);
            std::ostringstream said;
            Progress progress(said, Progress::Style::plain);
            const auto begin = Clock::now();
            const RunOptions options{
                .places = {file, Existing::replace}, .threads = threads, .writers = writers, .resume_command = ""};
            const int done = run_campaign(campaign, options, *link, compute, progress);
            const double wall = since(begin);
            line["message_thread_processor_s"] = processor_time(CLOCK_THREAD_CPUTIME_ID) - thread_before;

            const double before_reading = processor_time(CLOCK_THREAD_CPUTIME_ID);
            const JournalContents contents = read_journal(journal_path(file));
            line["read_processor_s"] = processor_time(CLOCK_THREAD_CPUTIME_ID) - before_reading;
            const StoredMembers stored = stored_members(contents, journal_path(file));
            const auto publish_begin = Clock::now();
            const double before = processor_time(CLOCK_THREAD_CPUTIME_ID);
            publish(file, campaign, stored, contents.sessions);
            line["publish_s"] = since(publish_begin);
            line["publish_processor_s"] = processor_time(CLOCK_THREAD_CPUTIME_ID) - before;
            int own = 0;
            int in_parts = 0;
            for (std::size_t k = 0; k < stored.notes().size(); ++k) {
                own += stored.read(k).rank == 0 ? 1 : 0;
                in_parts += contents.places[k].piece > 0 ? 1 : 0;
            }
            const int cores = threads * link->size();
            double all_bytes = static_cast<double>(std::filesystem::file_size(journal_path(file)));
            for (const int piece : pieces_of(journal_path(file)))
                all_bytes += static_cast<double>(std::filesystem::file_size(piece_path(journal_path(file), piece)));
            const double record_bytes = all_bytes / members;
            const Forecast forecast = forecast_of(campaign, duration, record_bytes, cores, link->size(), writers);
            line["cores"] = cores;
            line["members"] = members;
            line["writers"] = forecast.writers;
            line["in_parts"] = in_parts;
            line["member_s"] = duration;
            line["own_members"] = own;
            line["record_bytes"] = record_bytes;
            line["wall_s"] = wall;
            line["predicted_wall_s"] = forecast.wall_time;
            line["members_per_s"] = members / (wall - line["publish_s"].get<double>());
            line["predicted_members_per_s"] = members / forecast.last_member;
            line["file_bytes"] = std::filesystem::file_size(file);
            if (forecast.writers > 1) {
                line["file_processor_s"] = costs_of_hands(campaign, contents, file, forecast.writers);
                line["predicted_file_processor_s"] =
                    forecast_of(campaign, duration, record_bytes, cores, link->size(), writers, 1).file_time;
            }
            return done;
        });
    }
    const double of_thread = processor_time(CLOCK_THREAD_CPUTIME_ID) - thread_before;
    if (link->rank() != 0) line["message_thread_processor_s"] = of_thread;
    line["inside_s"] = since(inside);
    line["crew_processor_s"] = processor_time(CLOCK_PROCESS_CPUTIME_ID) - process_before - of_thread;
    fmt::print("{}\n", line.dump());
    return status;
}
