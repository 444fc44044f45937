#pragma once
// One instance of an FMU, whichever version of FMI its host speaks: its variables, its member, and in which order it
// may be told what. Throws InputError and RunError with a sentence for the host's log; an instance that a step has
// broken takes reset(), set() and its end only.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/bytes.hpp"
#include "fmu/variables.hpp"
#include "member/stepped_member.hpp"

namespace floes {

class StateArchive;

class FmuSession {
  public:
    /// `resources`: the FMU's folder of that name; `token`: what the host takes from the description. Throws RunError
    /// where a file is missing or the token is another's.
    FmuSession(std::string resources, std::string_view token);

    double real(unsigned reference) const;
    int integer(unsigned reference) const;
    const char* text(unsigned reference) const;  ///< until it is set again
    void set(unsigned reference, double value);
    void set(unsigned reference, int value);
    void set(unsigned reference, const char* value);

    /// Times in s. Before enter_initialization(), once.
    void set_up(double start, std::optional<double> stop);
    void enter_initialization();
    /// Makes the member. Throws InputError, as floes run does, for settings that cannot be run.
    void exit_initialization();
    void terminate();
    /// As it was instantiated, from any state.
    void reset();

    enum class StepEnd { done, run_is_over };
    /// From `at`, which is where the last step ended, over a length of whole time steps. The run is over where its end
    /// lies before that of the step; then nothing has happened.
    StepEnd step(double at, double length);

    double time() const { return start_ + static_cast<double>(steps_) * time_step_; }  ///< s, where the last step ended

    Bytes saved() const;
    void set(std::span<const std::byte> saved);

  private:
    enum class Phase { instantiated, initializing, stepping, terminated, broken };

    const FmuVariable& known(unsigned reference, FmuType type) const;
    const FmuVariable& settable(unsigned reference, FmuType type) const;
    void expect(Phase phase, std::string_view what) const;
    Vec6 six(unsigned first) const { return Vec6(reals_.data() + first); }
    void put_six(unsigned first, const Vec6& values) { std::ranges::copy(values, reals_.begin() + first); }
    void begin();
    int whole_steps(double at, double length) const;
    void advance(int steps, double length);
    void read_member(const Wrench& ice, const Vec6& acceleration);
    void archive(StateArchive& state);

    std::string resources_, token_;
    std::string configuration_;
    HullMover mover_ = HullMover::inside;
    std::vector<FmuVariable> variables_;
    std::array<double, fmu_reference::count> reals_{};
    std::array<int, fmu_reference::count> integers_{};
    std::string case_name_, settings_;
    std::string first_case_;  ///< of the description, as is the number of the arrangement
    int first_arrangement_ = 0;

    Phase phase_ = Phase::instantiated;
    bool is_set_up_ = false;
    double start_ = 0;
    std::optional<double> stop_;
    std::int64_t steps_ = 0;        ///< of the member
    bool was_moved_ = false;        ///< by others, in a step before
    Vec6 velocity_ = Vec6::Zero();  ///< at the beginning of that step
    double time_step_ = 0;          ///< s
    int run_steps_ = 0;             ///< of the whole run
    std::optional<SteppedMember> member_;
};

}  // namespace floes
