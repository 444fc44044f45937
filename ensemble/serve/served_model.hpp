#pragma once
// A campaign as a function of numbers, as samplers call it: what goes in, what comes out, what is wrong.

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "campaign/campaign.hpp"

namespace floes {

/// A key of the configuration that whoever asks sets to a number.
struct ModelInput {
    std::string key;                                         ///< full path of a scenario's key: "ice.thickness_m"
    double from = -std::numeric_limits<double>::infinity();  ///< allowed, in the key's unit
    double to = std::numeric_limits<double>::infinity();
    bool whole = false;

    /// Has an axis, so `from` and `to` are numbers.
    bool bounded() const { return std::isfinite(from) && std::isfinite(to); }
};

struct ServedModel {
    std::vector<ModelInput> inputs;    ///< at least one, keys unique
    std::vector<std::string> outputs;  ///< keys of quantities, at least one
};

/// The axes of the campaign's design as inputs, or with `keys` those keys: between the ends of their axis where they
/// have one, otherwise within what the key allows. Throws InputError where there are none, for a key that is none of a
/// scenario or takes no single number, and for one that is given twice.
std::vector<ModelInput> model_inputs(const Design& design, const std::vector<std::string>& keys);

/// `keys` as outputs, or without any the mean load and the largest load of the headlines. Throws InputError for one
/// that is no quantity, or that the campaign's first case does not measure.
std::vector<std::string> model_outputs(const Campaign& campaign, const std::vector<std::string>& keys);

/// What is asked: the inputs' numbers, in their order, and what replaces the configuration's own.
struct ModelQuestion {
    std::vector<double> values;
    std::optional<std::int64_t> arrangements = {};
    std::optional<std::int64_t> seed = {};
    bool standard_errors = false;  ///< are to be told; they are computed anyway

    /// The same simulations answer both.
    bool same_point(const ModelQuestion& other) const;
};

/// One number for each output, over arrangements.
struct ModelValues {
    std::vector<double> means;
    std::vector<double> standard_errors;  ///< of the means; NaN of a single arrangement
};

/// Why there are none; what() is a sentence.
class ModelError : public std::runtime_error {
  public:
    /// The types of errors of the protocol, and one for a server that does not take the request.
    enum class Kind { invalid_input, invalid_output, model_not_found, unsupported_feature, unavailable };

    ModelError(Kind kind, const std::string& sentence) : std::runtime_error(sentence), kind_(kind) {}

    Kind kind() const { return kind_; }

  private:
    Kind kind_;
};

using ModelAnswer = std::variant<ModelValues, ModelError>;

// Questions wait here for the threads that answer them, in the order in which they came. Two alike are answered once.

/// A question that is being answered.
struct AskedQuestion {
    std::int64_t turn = 0;  ///< lower ones came sooner; unique
    ModelQuestion question;
};

/// Called from any thread. Every call-back is called once: by answer(), or by close().
class QuestionQueue {
  public:
    using Tell = std::function<void(const ModelAnswer&)>;

    /// No more than `most` different questions wait, beside those that are being answered.
    explicit QuestionQueue(std::size_t most) : most_(most) {}

    /// Lets the question wait. `tell` is called at once with the reason where it cannot.
    void add(const ModelQuestion& question, Tell tell);

    /// The question to be answered next, which counts as being answered from now on; none within `patience`.
    std::optional<AskedQuestion> next(std::chrono::milliseconds patience);

    /// Answers the question that next() gave with this turn, once.
    void answer(std::int64_t turn, const ModelAnswer& answer);

    /// Answers all that wait or are being answered, and all that come later, with `why`.
    void close(const ModelError& why);

    std::size_t waiting() const;

  private:
    struct Waiting {
        ModelQuestion question;
        std::vector<Tell> told;
    };

    Waiting* like(const ModelQuestion& question);
    std::optional<ModelError> take(const ModelQuestion& question, const Tell& tell);

    mutable std::mutex mutex_;
    std::condition_variable came_;
    std::size_t most_;
    std::deque<Waiting> waiting_;
    std::map<std::int64_t, Waiting> under_way_;  // by turn
    std::int64_t next_turn_ = 0;
    std::optional<ModelError> closed_;
};

}  // namespace floes
