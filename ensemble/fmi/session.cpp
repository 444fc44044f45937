#include "fmi/session.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "campaign/campaign.hpp"
#include "campaign/read.hpp"
#include "core/digest.hpp"
#include "core/error.hpp"
#include "core/state_archive.hpp"
#include "fmu/fmu_file.hpp"
#include "shapes/moorings.hpp"

namespace floes {

namespace {

namespace ref = fmu_reference;

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw RunError(fmt::format("{} cannot be read; the FMU's folder resources has to be unpacked.", path.string()));
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string refuse_file(const std::string& path) {
    throw InputError(fmt::format("{}: an FMU reads no other file; state its values.", path));
}

/// "a=1; b=2" as --set takes them one by one.
std::vector<std::string> overrides_in(const std::string& settings) {
    std::vector<std::string> found;
    std::string rest = settings;
    std::ranges::replace(rest, '\n', ';');
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(';'), rest.size());
        const std::size_t first = rest.find_first_not_of(" \t");
        const std::size_t last = rest.find_last_not_of(" \t", end == 0 ? 0 : end - 1);
        if (first < end) found.push_back(rest.substr(first, last - first + 1));
        rest.erase(0, end + 1);
    }
    return found;
}

}  // namespace

FmuSession::FmuSession(std::string resources, std::string_view token) : resources_(std::move(resources)) {
    const std::filesystem::path folder(resources_);
    std::istringstream start(text_of(folder / fmu_start));
    std::vector<std::string> lines;
    for (std::string line; std::getline(start, line);) lines.push_back(line);
    if (lines.size() != 4) throw RunError(fmt::format("{} is not that of an FMU of floes.", fmu_start));
    mover_ = lines[0] == hull_mover_words[0] ? HullMover::inside : HullMover::outside;
    token_ = lines[1];
    first_case_ = lines[2];
    first_arrangement_ = std::stoi(lines[3]);
    if (token != token_)
        throw RunError(fmt::format("The host's description is of another FMU: its token is {}, and {} is expected.",
                                   token, token_));
    configuration_ = text_of(folder / fmu_configuration);
    variables_ = fmu_variables(mover_);
    reset();
}

void FmuSession::reset() {
    reals_ = {};
    integers_ = {};
    integers_[ref::arrangement] = first_arrangement_;
    case_name_ = first_case_;
    settings_.clear();
    phase_ = Phase::instantiated;
    is_set_up_ = false;
    start_ = 0;
    stop_.reset();
    steps_ = 0;
    was_moved_ = false;
    velocity_.setZero();
    member_.reset();
}

const FmuVariable& FmuSession::known(unsigned reference, FmuType type) const {
    const auto found = std::ranges::find(variables_, reference, &FmuVariable::reference);
    if (found != variables_.end() && found->type == type) return *found;
    constexpr std::array<std::string_view, 3> words{"real", "integer", "string"};
    throw InputError(fmt::format("There is no {} variable with the value reference {}.",
                                 words.at(static_cast<std::size_t>(type)), reference));
}

const FmuVariable& FmuSession::settable(unsigned reference, FmuType type) const {
    const FmuVariable& one = known(reference, type);
    if (one.role == FmuRole::output) throw InputError(fmt::format("{} is an output; it cannot be set.", one.name));
    const bool begun = phase_ != Phase::instantiated && phase_ != Phase::initializing;
    if (begun && one.role == FmuRole::parameter)
        throw InputError(
            fmt::format("{} is a fixed parameter; it is set before the initialization mode ends.", one.name));
    return one;
}

double FmuSession::real(unsigned reference) const {
    return reals_.at(known(reference, FmuType::real).reference);
}

int FmuSession::integer(unsigned reference) const {
    return integers_.at(known(reference, FmuType::integer).reference);
}

const char* FmuSession::text(unsigned reference) const {
    return known(reference, FmuType::string).reference == ref::case_name ? case_name_.c_str() : settings_.c_str();
}

void FmuSession::set(unsigned reference, double value) {
    const FmuVariable& one = settable(reference, FmuType::real);
    if (!std::isfinite(value)) throw InputError(fmt::format("{} = {} is no finite number.", one.name, value));
    reals_.at(reference) = value;
}

void FmuSession::set(unsigned reference, int value) {
    const FmuVariable& one = settable(reference, FmuType::integer);
    if (value < 0) throw InputError(fmt::format("{} = {}: arrangements are counted from 0.", one.name, value));
    integers_.at(reference) = value;
}

void FmuSession::set(unsigned reference, const char* value) {
    const FmuVariable& one = settable(reference, FmuType::string);
    (one.reference == ref::case_name ? case_name_ : settings_) = value == nullptr ? "" : value;
}

void FmuSession::expect(Phase phase, std::string_view what) const {
    if (phase_ == phase) return;
    constexpr std::array<std::string_view, 5> words{"instantiated", "in its initialization mode", "being stepped",
                                                    "terminated", "broken by a step that failed"};
    throw InputError(
        fmt::format("{} is out of order: the instance is {}.", what, words.at(static_cast<std::size_t>(phase_))));
}

void FmuSession::set_up(double start, std::optional<double> stop) {
    expect(Phase::instantiated, "Setting up the experiment");
    if (!std::isfinite(start) || (stop && !(*stop >= start)))
        throw InputError(fmt::format("An experiment cannot go from {} s to {} s.", start, stop.value_or(start)));
    start_ = start;
    stop_ = stop;
    is_set_up_ = true;
}

void FmuSession::enter_initialization() {
    expect(Phase::instantiated, "Entering the initialization mode");
    if (!is_set_up_) throw InputError("The experiment is to be set up before the initialization mode.");
    phase_ = Phase::initializing;
}

void FmuSession::begin() {
    const Campaign campaign = read_campaign(
        {.text = configuration_, .file = std::string(fmu_configuration), .overrides = overrides_in(settings_)},
        refuse_file);
    const Case& one = chosen_case(campaign, case_name_);
    if (one.pairing == Pairing::find_cfm)
        throw InputError(fmt::format("Case {} has joints whose Σ is to be calibrated; state joint.cfm.", one.name));
    Scenario scenario = one.scenario;
    if (mover_ == HullMover::outside) scenario.moorings = {};
    if (mover_ == HullMover::inside && !scenario.moorings.give_way())
        throw InputError("The hull has no moorings.mass_t any more, and this FMU is to move it.");
    time_step_ = scenario.general.time_step;
    run_steps_ = scenario.step_count();
    const auto index = static_cast<int>(&one - campaign.cases.data());
    const Vec6 led_from = from_fmu_motion(six(ref::motion));
    member_.emplace(scenario, arrangement_seed(campaign, index),
                    static_cast<std::uint32_t>(integers_[ref::arrangement]),
                    mover_ == HullMover::outside ? &led_from : nullptr);
}

void FmuSession::exit_initialization() {
    expect(Phase::initializing, "Leaving the initialization mode");
    begin();
    read_member({}, Vec6::Zero());
    phase_ = Phase::stepping;
}

void FmuSession::terminate() {
    expect(Phase::stepping, "Terminating");
    phase_ = Phase::terminated;
}

/// Hosts add up their times, and add rounding.
int FmuSession::whole_steps(double at, double length) const {
    const double rounding = 1e-4 * time_step_;
    if (!(std::abs(at - time()) <= rounding))
        throw InputError(fmt::format("A step from {} s is out of order: the last one ended at {} s.", at, time()));
    const double count = std::round(length / time_step_);
    if (!(count >= 1 && count <= 1e9 && std::abs(length - count * time_step_) <= rounding))
        throw InputError(fmt::format("A step of {} s is no whole number of time steps of {} s (general.time_step_s).",
                                     length, time_step_));
    if (stop_ && at + length > *stop_ + rounding)
        throw InputError(
            fmt::format("A step from {} s to {} s ends after the stop time, {} s.", at, at + length, *stop_));
    return static_cast<int>(count);
}

FmuSession::StepEnd FmuSession::step(double at, double length) {
    expect(Phase::stepping, "A step");
    const int count = whole_steps(at, length);
    if (steps_ + count > run_steps_) return StepEnd::run_is_over;
    phase_ = Phase::broken;  // unless it succeeds
    advance(count, length);
    phase_ = Phase::stepping;
    return StepEnd::done;
}

void FmuSession::advance(int steps, double length) {
    HullInput input;
    Vec6 acceleration = Vec6::Zero();
    if (mover_ == HullMover::inside) {
        const Vec6 load = six(ref::force_in);
        input.load = {from_fmu_axes(load.head<3>()), from_fmu_axes(load.tail<3>())};
    } else {
        const Vec6 velocity = six(ref::velocity);
        input.offset = from_fmu_motion(six(ref::motion));
        input.velocity = from_fmu_motion(velocity);
        if (was_moved_) acceleration = (velocity - velocity_) / length;
        was_moved_ = true;
        velocity_ = velocity;
    }
    const Wrench ice = member_->step(steps, input);
    steps_ += steps;
    read_member(ice, acceleration);
}

void FmuSession::read_member(const Wrench& ice, const Vec6& acceleration) {
    Vec6 load;
    load << to_fmu_axes(ice.force), to_fmu_axes(ice.moment);
    const Simulation& simulation = member_->simulation();
    if (const auto& moored = simulation.structure().moored()) {
        put_six(ref::motion, to_fmu_motion(moored->state().offset));
        put_six(ref::velocity, to_fmu_motion(moored->state().velocity));
        const Vec3 held = moored->restoring();
        reals_[ref::mooring_load] = held[0];
        reals_[ref::mooring_load + 1] = -held[1];
        reals_[ref::mooring_load + 2] = held[2];
    } else {
        load.head<3>() += reals_[ref::added_mass] * acceleration.head<3>();
    }
    put_six(ref::ice_load, load);
    integers_[ref::floes_met] = simulation.floes_met();
    integers_[ref::broken_floes] = simulation.ice().broken_floes();
    integers_[ref::failed_joints] = static_cast<int>(simulation.ice().breaks().size());
}

void FmuSession::archive(StateArchive& state) {
    std::vector<char> name(case_name_.begin(), case_name_.end());
    std::vector<char> settings(settings_.begin(), settings_.end());
    state(phase_, is_set_up_, start_, stop_, steps_, was_moved_, velocity_, reals_, integers_, name, settings);
    case_name_.assign(name.begin(), name.end());
    settings_.assign(settings.begin(), settings.end());
}

Bytes FmuSession::saved() const {
    if (phase_ == Phase::broken) throw InputError("The state of an instance that a step has broken is not kept.");
    StateArchive state;
    const_cast<FmuSession*>(this)->archive(state);  // which changes nothing where it does not set
    ByteWriter writer;
    writer.text(token_);
    writer.blob(state.take());
    writer.blob(member_ ? member_->simulation().saved() : Bytes{});
    return writer.take();
}

void FmuSession::set(std::span<const std::byte> saved) {
    ByteReader reader(saved);
    if (reader.text() != token_) throw RunError("The state is not one of this FMU.");
    const Bytes own = reader.blob();
    const Bytes of_member = reader.blob();
    const auto asked = [this] { return std::tuple(case_name_, settings_, integers_[ref::arrangement]); };
    const auto before = asked();
    StateArchive state(own);
    archive(state);
    state.end();
    if (of_member.empty()) {
        member_.reset();
        return;
    }
    const Phase phase = std::exchange(phase_, Phase::broken);  // unless it succeeds
    if (!member_ || asked() != before) begin();
    member_->set(of_member);
    phase_ = phase;
}

}  // namespace floes
