// A request to `floes serve`: up to the first line end its path, then its body. Each is answered with JSON, or is a
// question whose numbers lie where they may.

#include <cmath>
#include <string>
#include <variant>

#include "fuzz/fuzz.hpp"
#include "serve/um_bridge.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const floes::UmBridge bridge(
        {{{"ice.thickness_m", 0.02, 0.05}, {"field.floes", 4, 12, true}}, {"mean_load", "mean_maximum_1s"}});
    const std::string text(reinterpret_cast<const char*>(data), size);
    const std::size_t line = text.find('\n');
    const std::string body = line == std::string::npos ? "" : text.substr(line + 1);
    const auto taken = bridge.take("POST", text.substr(0, line), body);
    if (const auto* reply = std::get_if<floes::HttpReply>(&taken)) {
        floes::fuzz::require(reply->status == 200 || reply->status == 400, "a request has another status");
        floes::fuzz::require(reply->body.size() < 1000, "a reply is as long as what was sent");
        return 0;
    }
    const auto& question = std::get<floes::ModelQuestion>(taken);
    floes::fuzz::require(question.values.size() == 2, "a question has other inputs");
    floes::fuzz::require(question.values[0] >= 0.02 && question.values[0] <= 0.05, "a number is out of range");
    floes::fuzz::require(question.values[1] == std::floor(question.values[1]), "a whole number is none");
    floes::fuzz::require(question.arrangements.value_or(1) >= 1 && question.seed.value_or(0) >= 0,
                         "config is out of range");
    return 0;
}
