#include "serve/served_model.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/contract.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "keys/key.hpp"
#include "member/quantity.hpp"
#include "scenario/keys.hpp"

namespace floes {

namespace {

/// The numbers of an axis, whether it has a range or values.
std::pair<double, double> ends_of(const DesignAxis& axis) {
    if (axis.values.empty()) return {axis.from, axis.to};
    std::pair<double, double> ends{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const Value& value : axis.values) {
        const double number = number_of(value).value();
        ends = {std::min(ends.first, number), std::max(ends.second, number)};
    }
    return ends;
}

InputError no_number(const std::string& key) {
    return InputError(
        fmt::format("{} takes no single number, so it cannot be an input; name the inputs by --input, such as "
                    "--input ice.thickness_m",
                    key));
}

ModelInput on_axis_of(const DesignAxis& axis) {
    if (!axis.numeric) throw no_number(axis.key);
    const auto [from, to] = ends_of(axis);
    return {axis.key, from, to, axis.whole};
}

ModelInput free_input(const std::string& path) {
    Scenario scratch;
    const Keys keys = describe(scratch);
    const Key* key = find_key(keys, path);
    if (key == nullptr)
        throw InputError(fmt::format("--input {}: this is not a key that a case takes; did you mean {}?", path,
                                     nearest_path(keys, path)));
    const bool whole = std::holds_alternative<IntegerField>(key->field);
    if (!whole && !std::holds_alternative<NumberField>(key->field)) throw no_number(path);
    return {.key = path, .whole = whole};
}

}  // namespace

bool ModelQuestion::same_point(const ModelQuestion& other) const {
    return values == other.values && arrangements == other.arrangements && seed == other.seed;
}

std::vector<ModelInput> model_inputs(const Design& design, const std::vector<std::string>& keys) {
    std::vector<ModelInput> inputs;
    if (keys.empty()) {
        for (const DesignAxis& axis : design.axes) inputs.push_back(on_axis_of(axis));
        if (inputs.empty())
            throw InputError(
                "The configuration has no [[design.axis]] whose keys could be the inputs; name them by --input, such "
                "as "
                "--input ice.thickness_m --input contact.ice_structure_friction");
        return inputs;
    }
    for (const std::string& key : keys) {
        if (std::ranges::find(inputs, key, &ModelInput::key) != inputs.end())
            throw InputError(fmt::format("--input {} is given twice; keep one", key));
        const auto axis = std::ranges::find(design.axes, key, &DesignAxis::key);
        inputs.push_back(axis == design.axes.end() ? free_input(key) : on_axis_of(*axis));
    }
    return inputs;
}

std::vector<std::string> model_outputs(const Campaign& campaign, const std::vector<std::string>& keys) {
    const std::vector<double> times = campaign.cases.front().scenario.averaging_times();
    const std::vector<Quantity> measured = quantities_with(times);
    if (keys.empty())
        return {std::string{quantity("mean_load").key.view()}, std::string{headline_maximum(measured).key.view()}};
    for (const std::string& key : keys) {
        const std::optional<Quantity> known = any_quantity(key);
        if (!known)
            throw InputError(
                fmt::format("--output {}: this is no quantity of a member; take mean_load, mean_maximum_1s, "
                            "failure_ratio or another of floes summarize --format json",
                            key));
        if (std::ranges::find(measured, key, [](const Quantity& one) { return one.key.view(); }) == measured.end())
            throw InputError(fmt::format(
                "--output {}: the load is not averaged over {:g} s here; analysis.averaging_s has the times that it is "
                "averaged over",
                key, known->averaging));
    }
    return keys;
}

void QuestionQueue::add(const ModelQuestion& question, Tell tell) {
    if (const std::optional<ModelError> refusal = take(question, tell)) tell(*refusal);
}

QuestionQueue::Waiting* QuestionQueue::like(const ModelQuestion& question) {
    for (auto& [turn, one] : under_way_)
        if (one.question.same_point(question)) return &one;
    for (Waiting& one : waiting_)
        if (one.question.same_point(question)) return &one;
    return nullptr;
}

std::optional<ModelError> QuestionQueue::take(const ModelQuestion& question, const Tell& tell) {
    const std::scoped_lock lock(mutex_);
    if (closed_) return closed_;
    if (Waiting* same = like(question); same != nullptr) {
        same->told.push_back(tell);
        return std::nullopt;
    }
    if (waiting_.size() >= most_)
        return ModelError(
            ModelError::Kind::unavailable,
            fmt::format("No more than {} may wait; ask again later, or start the server with a larger --waiting",
                        counted(std::ssize(waiting_), "evaluation")));
    waiting_.push_back({question, {tell}});
    came_.notify_one();
    return std::nullopt;
}

std::optional<AskedQuestion> QuestionQueue::next(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    if (!came_.wait_for(lock, patience, [&] { return !waiting_.empty(); })) return std::nullopt;
    const auto begun = under_way_.emplace(next_turn_++, std::move(waiting_.front())).first;
    waiting_.pop_front();
    return AskedQuestion{begun->first, begun->second.question};
}

void QuestionQueue::answer(std::int64_t turn, const ModelAnswer& answer) {
    std::unique_lock lock(mutex_);
    const auto answered = under_way_.extract(turn);
    lock.unlock();
    FLOES_EXPECTS(!answered.empty());
    for (const Tell& tell : answered.mapped().told) tell(answer);
}

void QuestionQueue::close(const ModelError& why) {
    std::deque<Waiting> all;
    {
        const std::scoped_lock lock(mutex_);
        closed_ = why;
        all = std::exchange(waiting_, {});
        for (auto& [turn, one] : std::exchange(under_way_, {})) all.push_back(std::move(one));
    }
    for (const Waiting& one : all)
        for (const Tell& tell : one.told) tell(why);
}

std::size_t QuestionQueue::waiting() const {
    const std::scoped_lock lock(mutex_);
    return waiting_.size();
}

}  // namespace floes
