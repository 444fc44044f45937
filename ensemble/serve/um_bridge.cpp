#include "serve/um_bridge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "core/text.hpp"
#include "keys/meant.hpp"
#include "member/quantity.hpp"

namespace floes {

namespace {

using nlohmann::ordered_json;

constexpr std::array config_keys{"arrangements", "seed", "standard_errors"};
constexpr std::array derivatives{"/Gradient", "/ApplyJacobian", "/ApplyHessian"};
constexpr std::size_t longest_shown = 60;  // characters of what was sent
constexpr int deepest = 16;                // lists in lists; requests have three, and printing recurses

/// Text that came from outside need not be UTF-8, so wrong bytes are replaced.
std::string text_of(const ordered_json& value) {
    return value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

std::string shown(const ordered_json& value) {
    const std::string text = text_of(value);
    const std::string_view begin = beginning(text, longest_shown);
    return begin.size() < text.size() ? fmt::format("{}…", begin) : text;
}

ModelError invalid(const std::string& sentence) {
    return {ModelError::Kind::invalid_input, sentence};
}

ordered_json object_of(std::string_view body) {
    ordered_json request;
    try {
        request = ordered_json::parse(body, [](int depth, ordered_json::parse_event_t, const ordered_json&) {
            if (depth > deepest) throw invalid(fmt::format("The request has more than {} lists in lists", deepest));
            return true;
        });
    } catch (const ordered_json::parse_error& error) {
        throw invalid(
            fmt::format("The request is not JSON, from byte {} on; numbers are finite there, without NaN and "
                        "Infinity",
                        error.byte));
    } catch (const ordered_json::out_of_range&) {
        throw invalid("The request has a number that is too large; its numbers are finite");
    }
    if (!request.is_object())
        throw invalid(fmt::format("The request is {}; allowed: an object, as {{\"name\": \"{}\"}}", shown(request),
                                  UmBridge::model_name));
    return request;
}

void expect_name(const ordered_json& request) {
    const auto name = request.find("name");
    if (name == request.end())
        throw invalid(fmt::format("The request has no name; write \"name\": \"{}\"", UmBridge::model_name));
    if (*name != UmBridge::model_name)
        throw ModelError(
            ModelError::Kind::model_not_found,
            fmt::format("There is no model {} here; the only one is \"{}\"", shown(*name), UmBridge::model_name));
}

std::int64_t whole_number(const std::string& key, const ordered_json& value, std::int64_t least) {
    // Clients in languages with one kind of number write 4 as 4.0, those in R write it as [4].
    const ordered_json& number = value.is_array() && value.size() == 1 ? value.front() : value;
    constexpr double most = 9007199254740992.0;  // 2^53, up to which a double is exact
    if (number.is_number()) {
        const auto given = number.get<double>();
        if (given == std::floor(given) && given >= static_cast<double>(least) && given <= most)
            return static_cast<std::int64_t>(given);
    }
    throw invalid(fmt::format("config has {} = {}; allowed: a whole number of at least {}", key, shown(value), least));
}

bool yes_or_no(const std::string& key, const ordered_json& value) {
    const ordered_json& word = value.is_array() && value.size() == 1 ? value.front() : value;
    if (!word.is_boolean()) throw invalid(fmt::format("config has {} = {}; allowed: true or false", key, shown(value)));
    return word.get<bool>();
}

/// The question without its numbers.
ModelQuestion configured(const ordered_json& request) {
    ModelQuestion question;
    const auto config = request.find("config");
    const bool none = config == request.end() || config->is_null() || (config->is_array() && config->empty());
    if (none) return question;  // R writes an empty list as []
    if (!config->is_object())
        throw invalid(fmt::format("config is {}; allowed: an object with any of {}", shown(*config),
                                  fmt::join(config_keys, ", ")));
    for (const auto& [key, value] : config->items()) {
        if (key == "arrangements") {
            question.arrangements = whole_number(key, value, 1);
        } else if (key == "seed") {
            question.seed = whole_number(key, value, 0);
        } else if (key == "standard_errors") {
            question.standard_errors = yes_or_no(key, value);
        } else {
            const auto* const near =
                std::ranges::min_element(config_keys, {}, [&](const char* one) { return edit_distance(one, key); });
            throw invalid(
                fmt::format("config has {}; allowed: {}. Did you mean {}? Other keys are set when the server "
                            "is started, by floes serve --set",
                            shown(key), fmt::join(config_keys, ", "), *near));
        }
    }
    return question;
}

std::string names_of(const std::vector<ModelInput>& inputs) {
    std::vector<std::string> names;
    for (const ModelInput& input : inputs) names.push_back(input.key);
    return name_list(names);
}

double number_of(const ModelInput& input, const ordered_json& value) {
    if (!value.is_number())
        throw invalid(fmt::format("The input {} is {}; allowed: a number", input.key, shown(value)));
    const auto number = value.get<double>();
    if (number < input.from || number > input.to)
        throw invalid(fmt::format("The input {} is {}; allowed: {} to {}, between which its axis lies", input.key,
                                  number, input.from, input.to));
    if (input.whole && number != std::floor(number))
        throw invalid(fmt::format("The input {} is {}; allowed: a whole number", input.key, number));
    return number == 0 ? 0 : number;  // -0 is the same point
}

std::vector<double> numbers_of(const std::vector<ModelInput>& inputs, const ordered_json& request) {
    const std::string allowed =
        fmt::format("one list of {}: {}", counted(std::ssize(inputs), "number"), names_of(inputs));
    const auto input = request.find("input");
    if (input == request.end()) throw invalid(fmt::format("The request has no input; allowed: {}", allowed));
    if (!input->is_array() || !std::ranges::all_of(*input, [](const auto& one) { return one.is_array(); }))
        throw invalid(fmt::format("input is {}; allowed: a list of lists, {}", shown(*input), allowed));
    if (input->size() != 1)
        throw invalid(fmt::format("input has {}; allowed: {}", counted(std::ssize(*input), "list"), allowed));
    const ordered_json& list = input->front();
    if (list.size() != inputs.size())
        throw invalid(
            fmt::format("The list in input has {}; allowed: {}", counted(std::ssize(list), "number"), allowed));
    std::vector<double> numbers;
    for (std::size_t i = 0; i < inputs.size(); ++i) numbers.push_back(number_of(inputs[i], list[i]));
    return numbers;
}

HttpReply reply_with(const ordered_json& body) {
    return {200, text_of(body)};
}

ordered_json described(const ServedModel& model) {
    ordered_json about{{"model", UmBridge::model_name}, {"inputs", ordered_json::array()}};
    for (const ModelInput& input : model.inputs) {
        ordered_json one{{"key", input.key}};
        if (input.bounded()) one.update({{"from", input.from}, {"to", input.to}});
        about["inputs"].push_back(std::move(one));
    }
    about["outputs"] = ordered_json::array();
    for (const std::string& output : model.outputs)
        about["outputs"].push_back({{"key", output}, {"unit", any_quantity(output)->unit}});
    about["config"] = config_keys;
    return about;
}

HttpReply model_info() {
    ordered_json support{{"Evaluate", true}};
    for (const char* path : derivatives) support[path + 1] = false;
    return reply_with({{"support", support}});
}

/// Throws ModelError.
std::variant<HttpReply, ModelQuestion> taken(const ServedModel& model, std::string_view method, std::string_view path,
                                             std::string_view body) {
    const bool reads = method == "GET" || method == "HEAD";
    if (reads && path == "/Info") return reply_with({{"protocolVersion", 1.0}, {"models", {UmBridge::model_name}}});
    if (reads && path == "/") return reply_with(described(model));
    const bool derivative = std::ranges::find(derivatives, path) != derivatives.end();
    constexpr std::array by_post{"/ModelInfo", "/InputSizes", "/OutputSizes", "/Evaluate"};
    if (!derivative && std::ranges::find(by_post, path) == by_post.end())
        throw ModelError(ModelError::Kind::unsupported_feature,
                         fmt::format("There is no {} here; allowed: GET /Info and POST {}",
                                     beginning(path, longest_shown), fmt::join(by_post, ", ")));
    if (method != "POST")
        throw invalid(fmt::format("{} takes POST; {} was sent", path, beginning(method, longest_shown)));
    const ordered_json request = object_of(body);
    expect_name(request);
    if (derivative)
        throw ModelError(ModelError::Kind::unsupported_feature,
                         fmt::format("{} is not supported: loads have no derivatives here. Use a method that needs "
                                     "none, or differences with the same seed",
                                     path.substr(1)));
    if (path == "/ModelInfo") return model_info();
    ModelQuestion question = configured(request);
    if (path == "/InputSizes") return reply_with({{"inputSizes", {model.inputs.size()}}});
    if (path == "/OutputSizes")
        return reply_with(
            {{"outputSizes", std::vector(question.standard_errors ? std::size_t{2} : 1, model.outputs.size())}});
    question.values = numbers_of(model.inputs, request);
    return question;
}

/// By ModelError::Kind.
constexpr std::array<std::pair<int, const char*>, 5> statuses_and_types{{
    {400, "InvalidInput"},
    {500, "InvalidOutput"},
    {400, "ModelNotFound"},
    {400, "UnsupportedFeature"},
    {503, "Unavailable"},
}};

}  // namespace

HttpReply reply(const ModelError& error) {
    const auto [status, type] = statuses_and_types.at(static_cast<std::size_t>(error.kind()));
    return {status, text_of({{"error", {{"type", type}, {"message", error.what()}}}})};
}

HttpReply reply(const ModelQuestion& question, const ModelAnswer& answer) {
    if (const auto* error = std::get_if<ModelError>(&answer)) return reply(*error);
    const auto& values = std::get<ModelValues>(answer);
    const bool known = std::ranges::all_of(values.standard_errors, [](double one) { return std::isfinite(one); });
    if (question.standard_errors && !known)
        return reply(
            invalid("A single arrangement has no standard error; ask for more, as in \"config\": "
                    "{\"arrangements\": 8, \"standard_errors\": true}"));
    ordered_json output = ordered_json::array({values.means});
    if (question.standard_errors) output.push_back(values.standard_errors);
    return reply_with({{"output", output}});
}

std::variant<HttpReply, ModelQuestion> UmBridge::take(std::string_view method, std::string_view path,
                                                      std::string_view body) const {
    try {
        return taken(model_, method, path, body);
    } catch (const ModelError& error) {
        return reply(error);
    }
}

}  // namespace floes
