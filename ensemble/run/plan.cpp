#include "run/plan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "campaign_file/read.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "core/undefined.hpp"
#include "core/units.hpp"
#include "member/array_output.hpp"
#include "run/simulate.hpp"
#include "store/journal.hpp"
#include "store/member_record.hpp"

namespace floes {

namespace {

/// With its pieces.
double bytes_of(const std::filesystem::path& journal) {
    auto bytes = static_cast<double>(std::filesystem::file_size(journal));
    for (const int piece : pieces_of(journal))
        bytes += static_cast<double>(std::filesystem::file_size(piece_path(journal, piece)));
    return bytes;
}

MeasuredRun of_journal(const std::filesystem::path& journal, const std::filesystem::path& campaign_file) {
    const JournalContents contents = read_journal(journal);
    MeasuredRun run{read_stored_campaign(contents, journal), {}, bytes_of(journal)};
    for (const std::optional<std::size_t>& record : match_records(run.campaign, contents.members)) {
        const bool done = record && contents.members[*record].done();
        run.wall_time.push_back(done ? contents.members[*record].wall_time : undefined);
    }
    // During a run the file is older than the journal.
    const bool complete = !contents.sessions.empty() && !contents.sessions.back().ended.empty();
    if (complete && std::filesystem::exists(campaign_file))
        run.file_bytes = static_cast<double>(std::filesystem::file_size(campaign_file));
    return run;
}

MeasuredRun of_campaign_file(const std::filesystem::path& path) {
    const CampaignFile file(path);
    const CampaignTable table = read_campaign_file(file);
    MeasuredRun run{file.campaign(), read_wall_times(file), 0, static_cast<double>(std::filesystem::file_size(path))};
    for (std::size_t k = 0; k < run.wall_time.size(); ++k)
        if (table.members.at(k).status != RowStatus::done) run.wall_time[k] = undefined;
    return run;
}

}  // namespace

MeasuredRun read_measured_run(const std::filesystem::path& campaign_file) {
    const std::filesystem::path journal = journal_path(campaign_file);
    if (std::filesystem::exists(journal)) return of_journal(journal, campaign_file);
    if (std::filesystem::exists(campaign_file)) return of_campaign_file(campaign_file);
    throw InputError(fmt::format("there is neither {} nor its journal {}. Give the output file of floes run.",
                                 campaign_file.string(), journal.string()));
}

namespace {

constexpr double peaks_a_separation = 0.57;  // declustered peaks; of the members of configs/table3.toml

constexpr int cores_of_a_node = 64;

/// That many numbers of which none compresses well.
std::vector<double> numbers(std::size_t count) {
    std::vector<double> made(count);
    for (std::size_t k = 0; k < count; ++k) made[k] = std::sin(static_cast<double>(k + 1));
    return made;
}

/// Size of a done member's record without its history, from a record with as many numbers.
double record_bytes(const Scenario& scenario) {
    MemberRecord record;
    record.case_key = std::string(32, '0');
    record.host = "node0000";
    const Analysis& analysis = scenario.analysis;
    record.result.load.segment_maximum = numbers(static_cast<std::size_t>(analysis.segments));
    record.result.levels.resize(analysis.exceedance_levels.size());
    record.result.averaged.resize(scenario.averaging_times().size());
    const double peaks = peaks_a_separation * analysis.window / analysis.peak_separation;
    for (AveragedLoad& one : record.result.averaged) {
        one.segment_maximum = record.result.load.segment_maximum;
        one.peaks = numbers(static_cast<std::size_t>(std::lround(peaks)));
    }
    for (const double number : numbers(static_cast<std::size_t>(scenario.field.floes)))
        record.result.arrangement.push_back({number, 2 * number, 3 * number});
    record.result.load_map = {numbers(LoadMap::heights * LoadMap::angles), numbers(LoadMap::heights * LoadMap::angles),
                              numbers(LoadMap::parts)};
    return static_cast<double>(encode(record).size());
}

/// Sizes of its rows of numbers, packed: three of loads, and those of the motions that the hull has.
struct HistoryBytes {
    double all = 0;
    double deflated = 0;  ///< the compressed part; small sets are left uncompressed

    explicit HistoryBytes(const Scenario& scenario) {
        for (const ArrayOutput& output : array_outputs) {
            if (output.group() != "history" || !scenario.analysis.keep_history) continue;
            const std::size_t numbers = output.axes[0]->places(scenario).size();
            const double bytes = measured_member_costs().history_bytes * static_cast<double>(numbers);
            all += bytes;
            if (PackedNumbers{numbers, {}}.deflated()) deflated += bytes;
        }
    }
};

/// Two independent uniform numbers in (0, 1) for a member.
std::array<double, 2> draw(const Campaign& campaign, int number) {
    const PhiloxKey key{static_cast<std::uint32_t>(campaign.seed), static_cast<std::uint32_t>(campaign.seed >> 32)};
    const PhiloxCounter words = philox({static_cast<std::uint32_t>(number), 0, 0, 0}, key);
    return {(words[0] + 0.5) * 0x1p-32, (words[1] + 0.5) * 0x1p-32};
}

/// Log-normal, of mean 1.
double scatter(const std::array<double, 2>& uniform, double variation) {
    const double sigma = std::sqrt(std::log1p(variation * variation));
    const double normal = std::sqrt(-2 * std::log(uniform[0])) * std::cos(2 * std::numbers::pi * uniform[1]);
    return std::exp(sigma * normal - sigma * sigma / 2);
}

std::vector<SimulatedMember> members_of(const Campaign& campaign) {
    std::vector<HistoryBytes> histories;
    std::vector<double> others;
    std::vector<double> costs;
    for (const Case& one : campaign.cases) {
        histories.emplace_back(one.scenario);
        others.push_back(record_bytes(one.scenario));
        costs.push_back(expected_cost(campaign, static_cast<int>(costs.size())));  // of the case's first member
    }
    std::vector<SimulatedMember> members;
    members.reserve(static_cast<std::size_t>(member_count(campaign)));
    for (int number = 0; number < member_count(campaign); ++number) {
        const auto k = static_cast<std::size_t>(member_key(campaign, number).case_index);
        members.push_back({.expected_cost = costs[k],
                           .record_bytes = histories[k].all + others[k],
                           .file_bytes = histories[k].all + measured_member_costs().file_per_record_byte * others[k],
                           .packed_bytes = histories[k].deflated});
    }
    return members;
}

/// Measured seconds per unit of expected cost, for each case of the run and for all its members.
struct MeasuredRates {
    std::vector<std::vector<double>> of_case;
    std::vector<double> of_all;
};

MeasuredRates rates_of(const MeasuredRun& run) {
    MeasuredRates rates{std::vector<std::vector<double>>(run.campaign.cases.size()), {}};
    for (std::size_t k = 0; k < run.wall_time.size(); ++k) {
        if (std::isnan(run.wall_time[k])) continue;
        const int number = static_cast<int>(k);
        const double rate = run.wall_time[k] / expected_cost(run.campaign, number);
        rates.of_case[static_cast<std::size_t>(member_key(run.campaign, number).case_index)].push_back(rate);
        rates.of_all.push_back(rate);
    }
    return rates;
}

/// The rates from which members of a case draw.
const std::vector<double>& rates_for(const Case& one, const MeasuredRun& run, const MeasuredRates& rates) {
    const auto same = std::ranges::find(run.campaign.cases, one.name, &Case::name);
    if (same == run.campaign.cases.end()) return rates.of_all;
    const auto& own = rates.of_case[static_cast<std::size_t>(same - run.campaign.cases.begin())];
    return own.empty() ? rates.of_all : own;
}

/// Makes sizes as much larger as those of the run are than they would have been planned.
void scale_as_measured(std::vector<SimulatedMember>& members, const MeasuredRun& run) {
    const std::vector<SimulatedMember> planned = members_of(run.campaign);
    double journal = 0;
    double file = measured_member_costs().file_bytes;
    for (std::size_t k = 0; k < planned.size(); ++k) {
        if (std::isnan(run.wall_time[k])) continue;
        journal += planned[k].record_bytes;
        file += planned[k].file_bytes;
    }
    const double of_journal = run.journal_bytes > 0 ? run.journal_bytes / journal : run.file_bytes / file;
    const double of_file = run.file_bytes > 0 ? run.file_bytes / file : of_journal;
    for (SimulatedMember& member : members) {
        member.record_bytes *= of_journal;
        member.packed_bytes *= of_journal;
        member.file_bytes *= of_file;
    }
}

}  // namespace

namespace {

/// Whether ice meets an upright wall all round.
bool is_upright(const Shape& shape) {
    constexpr double least = 80 * unit::degree;
    if (!shape.is_of_revolution()) return shape.kind() == HullKind::four_legs;
    return std::abs(shape.wall_angle_above_water() - std::numbers::pi / 2) < std::numbers::pi / 2 - least;
}

/// s per unit of expected cost.
double time_per_unit(const Scenario& scenario, const MemberCosts& costs) {
    switch (scenario.general.solver) {
        case SolverKind::stock:
            return costs.stock_per_unit;
        case SolverKind::lanes:
            return costs.lanes_per_unit;
        case SolverKind::direct:
            break;
    }
    return costs.direct_per_unit * (is_upright(scenario.structure.shape) ? costs.jam : 1);
}

}  // namespace

PlannedMembers expected_members(const Campaign& campaign) {
    const MemberCosts costs = measured_member_costs();
    PlannedMembers planned{members_of(campaign), costs.source};
    for (std::size_t k = 0; k < planned.members.size(); ++k) {
        const int number = static_cast<int>(k);
        const auto case_index = static_cast<std::size_t>(member_key(campaign, number).case_index);
        SimulatedMember& member = planned.members[k];
        member.run_time = member.expected_cost * time_per_unit(campaign.cases[case_index].scenario, costs) *
                          scatter(draw(campaign, number), costs.variation);
    }
    return planned;
}

PlannedMembers measured_members(const Campaign& campaign, const MeasuredRun& run) {
    const MeasuredRates rates = rates_of(run);
    if (rates.of_all.empty()) throw InputError(fmt::format("no member of {} is done yet.", run.campaign.name));
    PlannedMembers planned{
        members_of(campaign),
        fmt::format("{} of {}", counted(std::ssize(rates.of_all), "measured member"), run.campaign.name)};
    scale_as_measured(planned.members, run);
    std::vector<const std::vector<double>*> of_case;
    for (const Case& one : campaign.cases) of_case.push_back(&rates_for(one, run, rates));
    for (std::size_t k = 0; k < planned.members.size(); ++k) {
        const int number = static_cast<int>(k);
        const std::vector<double>& from = *of_case[static_cast<std::size_t>(member_key(campaign, number).case_index)];
        const auto chosen = static_cast<std::size_t>(draw(campaign, number)[0] * static_cast<double>(from.size()));
        planned.members[k].run_time = planned.members[k].expected_cost * from[chosen];
    }
    return planned;
}

void set_record_bytes(PlannedMembers& planned, double bytes) {
    for (SimulatedMember& member : planned.members) {
        member.file_bytes *= bytes / member.record_bytes;
        member.packed_bytes *= bytes / member.record_bytes;
        member.record_bytes = bytes;
    }
}

int usual_ranks(int cores) {
    return (cores + cores_of_a_node - 1) / cores_of_a_node;
}

PlanRow plan_row(std::span<const SimulatedMember> members, const Machine& machine, const DriverCosts& costs,
                 bool with_file) {
    const auto& cores = machine.cores_of_rank;
    PlanRow row{std::accumulate(cores.begin(), cores.end(), 0), static_cast<int>(cores.size()),
                simulate(members, machine, costs, with_file),
                costs.memory_per_member * static_cast<double>(members.size())};
    row.forecast.file_bytes += measured_member_costs().file_bytes;
    return row;
}

}  // namespace floes
