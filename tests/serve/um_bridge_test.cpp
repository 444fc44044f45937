#include "serve/um_bridge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace floes {
namespace um_bridge_test {

using nlohmann::json;
using testing::HasSubstr;

const UmBridge& bridge() {
    static const UmBridge made(
        {{{"ice.thickness_m", 0.02, 0.05}, {"field.floes", 4, 12, true}, {"structure.speed_m_s"}},
         {"mean_load", "mean_maximum_1s"}});
    return made;
}

HttpReply reply_to(const std::string& method, const std::string& path, const std::string& body = "") {
    return std::get<HttpReply>(bridge().take(method, path, body));
}

json body_of(const std::string& path, const std::string& body) {
    const HttpReply reply = reply_to("POST", path, body);
    EXPECT_EQ(reply.status, 200) << reply.body;
    return json::parse(reply.body);
}

ModelQuestion question(const std::string& body) {
    auto taken = bridge().take("POST", "/Evaluate", body);
    const auto* refused = std::get_if<HttpReply>(&taken);
    if (refused != nullptr) ADD_FAILURE() << refused->body;
    return refused == nullptr ? std::get<ModelQuestion>(taken) : ModelQuestion{};
}

/// "type: sentence" of an error with the status that its type has.
std::string error(const HttpReply& reply) {
    const json error = json::parse(reply.body).at("error");
    EXPECT_EQ(error.size(), 2u);
    const std::string type = error.at("type");
    EXPECT_EQ(reply.status, type == "InvalidOutput" ? 500 : type == "Unavailable" ? 503 : 400);
    return type + ": " + error.at("message").get<std::string>();
}

std::string refusal(const std::string& body, const std::string& path = "/Evaluate") {
    return error(reply_to("POST", path, body));
}

std::string with_input(const std::string& input) {
    return R"({"name": "forward", "input": )" + input + "}";
}

std::string with_config(const std::string& config) {
    return R"({"name": "forward", "input": [[0.03, 8, 0.1]], "config": )" + config + "}";
}

TEST(UmBridge, SaysWhatItIs) {
    EXPECT_EQ(json::parse(reply_to("GET", "/Info").body),
              json::parse(R"({"protocolVersion": 1.0, "models": ["forward"]})"));
    EXPECT_EQ(body_of("/ModelInfo", R"({"name": "forward"})"),
              json::parse(R"({"support": {"Evaluate": true, "Gradient": false, "ApplyJacobian": false,
                                          "ApplyHessian": false}})"));
    EXPECT_EQ(body_of("/InputSizes", R"({"name": "forward", "config": {}})"), json::parse(R"({"inputSizes": [3]})"));
    EXPECT_EQ(body_of("/OutputSizes", R"({"name": "forward"})"), json::parse(R"({"outputSizes": [2]})"));
    EXPECT_EQ(body_of("/OutputSizes", R"({"name": "forward", "config": {"standard_errors": true}})"),
              json::parse(R"({"outputSizes": [2, 2]})"));
}

TEST(UmBridge, NamesItsInputsAndOutputsBesideTheProtocol) {
    const json about = json::parse(reply_to("GET", "/").body);
    EXPECT_EQ(about.at("inputs"), json::parse(R"([{"key": "ice.thickness_m", "from": 0.02, "to": 0.05},
                                                  {"key": "field.floes", "from": 4.0, "to": 12.0},
                                                  {"key": "structure.speed_m_s"}])"));
    EXPECT_EQ(about.at("outputs").at(1), json::parse(R"({"key": "mean_maximum_1s", "unit": "N"})"));
}

TEST(UmBridge, TakesAQuestion) {
    const ModelQuestion plain = question(with_input("[[0.03, 8, -1.5e-3]]"));
    EXPECT_EQ(plain.values, (std::vector{0.03, 8.0, -0.0015}));
    EXPECT_FALSE(plain.arrangements);
    EXPECT_FALSE(plain.seed);
    EXPECT_FALSE(plain.standard_errors);

    const ModelQuestion all = question(with_config(R"({"arrangements": 6, "seed": 0, "standard_errors": true})"));
    EXPECT_EQ(all.arrangements, 6);
    EXPECT_EQ(all.seed, 0);
    EXPECT_TRUE(all.standard_errors);
}

TEST(UmBridge, TakesWhatClientsOfOtherLanguagesWrite) {
    EXPECT_FALSE(question(with_config("[]")).seed);    // R: an empty list
    EXPECT_FALSE(question(with_config("null")).seed);  // Julia: nothing
    EXPECT_EQ(question(with_config(R"({"arrangements": [6]})")).arrangements, 6);
    EXPECT_EQ(question(with_config(R"({"arrangements": 6.0})")).arrangements, 6);
    EXPECT_TRUE(question(with_config(R"({"standard_errors": [true]})")).standard_errors);
    EXPECT_EQ(question(with_input("[[0.03, 8.0, 0]]")).values.at(1), 8);
}

TEST(UmBridge, TakesMinusZeroAsZero) {
    EXPECT_FALSE(std::signbit(question(with_input("[[0.03, 8, -0.0]]")).values.at(2)));
}

TEST(UmBridge, RefusesWhatIsNoRequest) {
    EXPECT_THAT(refusal(""), HasSubstr("InvalidInput: The request is not JSON, from byte 1 on"));
    EXPECT_THAT(refusal(with_input("[[0.03, NaN, 1]]")),
                HasSubstr("numbers are finite there, without NaN and Infinity"));
    EXPECT_THAT(refusal(with_input("[[0.03, 1e999, 1]]")), HasSubstr("a number that is too large"));
    EXPECT_THAT(refusal("[1, 2]"), HasSubstr("The request is [1,2]; allowed: an object"));
    EXPECT_THAT(refusal(std::string(30000, '[') + std::string(30000, ']')), HasSubstr("more than 16 lists in lists"));
    EXPECT_THAT(refusal("{}"), HasSubstr("The request has no name; write \"name\": \"forward\""));
    EXPECT_EQ(refusal(R"({"name": "posterior"})"),
              "ModelNotFound: There is no model \"posterior\" here; the only one is \"forward\"");
    EXPECT_THAT(refusal(R"({"name": 4})", "/ModelInfo"), HasSubstr("ModelNotFound: There is no model 4 here"));
    EXPECT_THAT(refusal("{\"name\": \"\xff\"}"), HasSubstr("InvalidInput: The request is not JSON"));
}

TEST(UmBridge, RefusesInputsOfOtherSizes) {
    const std::string allowed = "allowed: one list of 3 numbers: ice.thickness_m, field.floes, structure.speed_m_s";
    EXPECT_EQ(refusal(R"({"name": "forward"})"), "InvalidInput: The request has no input; " + allowed);
    EXPECT_EQ(refusal(with_input("[]")), "InvalidInput: input has 0 lists; " + allowed);
    EXPECT_EQ(refusal(with_input("[[0.03, 8], [0.1]]")), "InvalidInput: input has 2 lists; " + allowed);
    EXPECT_EQ(refusal(with_input("[[0.03, 8]]")), "InvalidInput: The list in input has 2 numbers; " + allowed);
    EXPECT_EQ(refusal(with_input("[0.03, 8, 0.1]")),
              "InvalidInput: input is [0.03,8,0.1]; allowed: a list of lists, one list of 3 numbers: ice.thickness_m, "
              "field.floes, structure.speed_m_s");
}

TEST(UmBridge, RefusesInputsOutOfRange) {
    EXPECT_EQ(refusal(with_input("[[0.06, 8, 0.1]]")),
              "InvalidInput: The input ice.thickness_m is 0.06; allowed: 0.02 to 0.05, between which its axis lies");
    EXPECT_THAT(refusal(with_input("[[0.019, 8, 0.1]]")), HasSubstr("ice.thickness_m is 0.019"));
    EXPECT_EQ(refusal(with_input("[[0.03, 8.5, 0.1]]")),
              "InvalidInput: The input field.floes is 8.5; allowed: a whole number");
    EXPECT_EQ(refusal(with_input(R"([[0.03, 8, "fast"]])")),
              "InvalidInput: The input structure.speed_m_s is \"fast\"; allowed: a number");
    EXPECT_THAT(refusal(with_input("[[null, 8, 0.1]]")), HasSubstr("ice.thickness_m is null; allowed: a number"));
}

TEST(UmBridge, RefusesUnknownConfig) {
    EXPECT_THAT(
        refusal(with_config(R"({"seeds": 3})")),
        HasSubstr("InvalidInput: config has \"seeds\"; allowed: arrangements, seed, standard_errors. Did you mean "
                  "seed?"));
    EXPECT_THAT(refusal(with_config("3")), HasSubstr("config is 3; allowed: an object with any of arrangements"));
    for (const char* wrong : {"0", "-1", "1.5", "true", "[1, 2]", "1e30", "\"4\""})
        EXPECT_THAT(refusal(with_config(std::string{"{\"arrangements\": "} + wrong + "}")),
                    HasSubstr("; allowed: a whole number of at least 1"));
    EXPECT_THAT(refusal(with_config(R"({"seed": -1})")), HasSubstr("seed = -1; allowed: a whole number of at least 0"));
    EXPECT_THAT(refusal(with_config(R"({"standard_errors": 1})")), HasSubstr("= 1; allowed: true or false"));
    EXPECT_THAT(refusal(R"({"name": "forward", "config": {"seeds": 3}})", "/OutputSizes"), HasSubstr("\"seeds\""));
}

TEST(UmBridge, RefusesWhatItDoesNotSupport) {
    for (const char* path : {"/Gradient", "/ApplyJacobian", "/ApplyHessian"})
        EXPECT_THAT(refusal(R"({"name": "forward"})", path), HasSubstr("UnsupportedFeature: ")) << path;
    EXPECT_THAT(refusal(R"({"name": "other"})", "/Gradient"), HasSubstr("ModelNotFound"));
    EXPECT_EQ(error(reply_to("GET", "/Answer")),
              "UnsupportedFeature: There is no /Answer here; allowed: GET /Info and POST /ModelInfo, /InputSizes, "
              "/OutputSizes, /Evaluate");
    EXPECT_EQ(error(reply_to("GET", "/Evaluate")), "InvalidInput: /Evaluate takes POST; GET was sent");
}

TEST(UmBridge, ShowsNoMoreThanABeginningOfWhatWasSent) {
    const std::string sentence = refusal("{\"name\": \"" + std::string(5000, 'x') + "\"}");
    EXPECT_LT(sentence.size(), 200u);
    EXPECT_THAT(sentence, HasSubstr("xxx…"));
    EXPECT_LT(error(reply_to("POST", "/" + std::string(5000, 'x'))).size(), 300u);
}

TEST(UmBridge, WritesEveryDigitOfAnAnswer) {
    const ModelQuestion asked{{0.03}, {}, {}, false};
    const ModelValues values{{0.1 + 0.2, 1e-300}, {0.5, 0.25}};
    const HttpReply plain = reply(asked, values);
    EXPECT_EQ(plain.status, 200);
    EXPECT_EQ(json::parse(plain.body), json({{"output", {{0.1 + 0.2, 1e-300}}}}));
    const HttpReply both = reply(ModelQuestion{{0.03}, {}, {}, true}, values);
    EXPECT_EQ(json::parse(both.body), json({{"output", {{0.1 + 0.2, 1e-300}, {0.5, 0.25}}}}));
}

TEST(UmBridge, SaysWhyThereIsNoAnswer) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(error(reply(ModelQuestion{{0.03}, 1, {}, true}, ModelValues{{1, 2}, {nan, nan}})),
                HasSubstr("InvalidInput: A single arrangement has no standard error; ask for more"));
    EXPECT_EQ(reply(ModelQuestion{{0.03}, 1, {}, false}, ModelValues{{1, 2}, {nan, nan}}).status, 200);
    EXPECT_EQ(error(reply(ModelQuestion{}, ModelError(ModelError::Kind::invalid_output, "It failed \xff."))),
              "InvalidOutput: It failed \ufffd.");
    EXPECT_EQ(error(reply(ModelError(ModelError::Kind::unavailable, "Later."))), "Unavailable: Later.");
}

}  // namespace um_bridge_test
}  // namespace floes
