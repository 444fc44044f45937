// floes serve: a campaign as a model that samplers call over HTTP.

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <list>
#include <syncstream>
#include <thread>
#include <utility>
#include <variant>

#include "campaign/read.hpp"
#include "cli/commands.hpp"
#include "core/trial.hpp"
#include "member/quantity.hpp"
#include "run/core_pool.hpp"
#include "run/link.hpp"
#include "run/signals.hpp"
#include "run/worker.hpp"
#include "serve/http_server.hpp"
#include "serve/served_campaign.hpp"
#include "serve/served_model.hpp"
#include "serve/um_bridge.hpp"

namespace floes {

namespace {

struct ServeVerb {
    std::string config;
    std::vector<std::string> inputs;
    std::vector<std::string> outputs;
    std::string case_name;
    std::string folder;
    std::string host = "127.0.0.1";
    int port = 4242;
    std::string token_file;
    int threads = 0;
    int at_once = 0;
    int waiting = 64;
    std::vector<std::string> overrides;
};

constexpr const char* examples =
    "The inputs are the axes of [[design.axis]], or the keys that --input names; one evaluation is the campaign with\n"
    "these values, and the outputs are means over its arrangements. The protocol is that of UM-Bridge 1.0, which\n"
    "samplers in Python, R, Julia and Matlab speak. The same numbers give the same answer, and what was computed once\n"
    "is read from the folder.\n\n"
    "  floes serve my.toml --input ice.thickness_m --input contact.ice_structure_friction\n\n"
    "  curl http://localhost:4242/                                 # what goes in, what comes out\n"
    "  curl -d '{\"name\": \"forward\", \"input\": [[0.03, 0.2]]}' http://localhost:4242/Evaluate\n\n"
    "  import umbridge                                             # Python, after pip install umbridge\n"
    "  model = umbridge.HTTPModel(\"http://localhost:4242\", \"forward\")\n"
    "  print(model([[0.03, 0.2]], {\"arrangements\": 8, \"standard_errors\": True}))";

constexpr int most_at_once = 64;  // connections that the server has

std::filesystem::path folder_of(const ServeVerb& verb) {
    if (!verb.folder.empty()) return verb.folder;
    return std::filesystem::path(verb.config).stem().string() + ".served";
}

void expect_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw InputError(fmt::format("{} cannot be made a folder ({}); -o names the folder that keeps the results",
                                     folder.string(), error.message()));
}

/// That requests must bear; empty: none. A token on the command line would be shown to all by ps.
std::string token_of(const ServeVerb& verb) {
    constexpr std::size_t shortest = 16;
    const char* set = std::getenv("FLOES_TOKEN");
    const bool from_file = !verb.token_file.empty();
    std::string token = from_file ? read_text(verb.token_file) : set == nullptr ? "" : set;
    while (token.ends_with('\n') || token.ends_with('\r')) token.pop_back();
    if (token.empty() && !from_file) return token;
    if (token.size() < shortest || !std::ranges::all_of(token, [](char one) { return one > ' ' && one <= '~'; }))
        throw InputError(fmt::format(
            "the token of {} is shorter than {} characters, or has others than letters, digits and signs of ASCII; "
            "make one by: openssl rand -hex 32",
            from_file ? verb.token_file : "FLOES_TOKEN", shortest));
    return token;
}

void expect_token(const ServeVerb& verb, const std::string& token) {
    if (is_loopback(verb.host) || !token.empty()) return;
    throw InputError(
        fmt::format("at --host {} other machines can ask, so they need a token: write a secret into a file that only "
                    "you can read and give --token-file FILE, or set FLOES_TOKEN",
                    verb.host));
}

/// What a user who has just started the server should know.
std::string opening(const ServeVerb& verb, const ServedModel& model, const Campaign& campaign,
                    const std::string& address, bool asks_for_token) {
    std::vector<std::string> inputs;
    for (const ModelInput& one : model.inputs)
        inputs.push_back(one.bounded() ? fmt::format("{} from {} to {}", one.key, one.from, one.to) : one.key);
    std::vector<std::string> outputs;
    for (const std::string& one : model.outputs)
        outputs.push_back(fmt::format("{} in {}", one, any_quantity(one)->unit));
    return fmt::format(
        "{}: {} serves the model \"{}\" of {}, {} for each evaluation; results are kept in {}; {}Ctrl-C ends it\n"
        "inputs, in one list: {}\noutputs, in one list: {}\n",
        campaign.name, address, UmBridge::model_name, campaign.cases.front().name,
        counted(campaign.arrangements, "arrangement"), folder_of(verb).string(),
        asks_for_token ? "requests need the token; " : "", fmt::join(inputs, ", "), fmt::join(outputs, ", "));
}

/// What answers questions, as many at a time as there are helpers.
struct Answering {
    const ServedCampaign& campaign;
    const ServedModel& model;
    std::list<Helper>& helpers;
    CorePool& pool;
};

/// One after the other, beside other threads that do the same.
void answer_some(QuestionQueue& queue, const StopSignals& signals, const Answering& by, Helper& helper) {
    constexpr std::chrono::milliseconds look_at_signals{200};
    while (signals.received() == 0) {
        const std::optional<AskedQuestion> asked = queue.next(look_at_signals);
        if (!asked) continue;
        std::osyncstream progress(std::cerr);
        progress << std::emit_on_flush;
        queue.answer(asked->turn, by.campaign.answer(asked->question, by.model.outputs,
                                                     {compute_member, by.pool, asked->turn, &helper, progress,
                                                      by.helpers.size() == 1}));
    }
}

void answer_until_stopped(QuestionQueue& queue, const StopSignals& signals, const Answering& by) {
    {
        std::list<std::jthread> threads;
        for (Helper& helper : by.helpers) threads.emplace_back([&] { answer_some(queue, signals, by, helper); });
    }
    queue.close(ModelError(ModelError::Kind::unavailable, "The server was stopped; what it has computed is kept"));
    std::cerr << fmt::format("stopped by {}; what is done is kept\n", signal_name(signals.received()));
}

int serve(const ServeVerb& verb) {
    if (started_by_mpi())
        throw InputError(
            "floes serve is one process, which takes the cores of one machine; start it without mpirun and srun.");
    const std::string token = token_of(verb);
    expect_token(verb, token);
    outlive_readers();
    const int threads = threads_of(LocalLink(), verb.threads);
    // While one campaign begins or is published, members of others keep its cores busy.
    const int evaluations = verb.at_once > 0 ? verb.at_once : std::min(2 * threads, most_at_once);
    std::list<Helper> helpers;  // before the first thread; one knows one campaign
    for (int k = 0; k < evaluations; ++k) helpers.emplace_back(compute_member);
    const std::string path = find_config(verb.config);
    const std::string text = read_text(path);
    const auto read = [&](std::vector<std::string> overrides) {
        overrides.insert(overrides.begin(), verb.overrides.begin(), verb.overrides.end());
        return read_campaign({text, path, std::move(overrides), true, true}, read_text);
    };
    const Campaign whole = load_campaign(verb.config, verb.overrides);
    ServedModel model{model_inputs(whole.design, verb.inputs), {}};
    const ServedCampaign campaign(read, whole, model.inputs, {verb.case_name, folder_of(verb)});
    const Campaign example = campaign.in_the_middle();
    model.outputs = model_outputs(example, verb.outputs);
    expect_folder(folder_of(verb));
    const StopSignals signals;
    CorePool pool(threads);
    QuestionQueue queue(static_cast<std::size_t>(verb.waiting));
    const UmBridge bridge(model);
    const HttpServer server(
        verb.host, verb.port, {.token = token}, [&](const HttpRequest& request, const HttpServer::Respond& respond) {
            const auto taken = bridge.take(request.method, request.path, request.body);
            if (const auto* at_once = std::get_if<HttpReply>(&taken)) return respond(*at_once);
            const auto& question = std::get<ModelQuestion>(taken);
            queue.add(question, [=](const ModelAnswer& answer) { respond(reply(question, answer)); });
        });
    std::cerr << opening(verb, model, example, server.address(), !token.empty()) << std::flush;
    answer_until_stopped(queue, signals, {campaign, model, helpers, pool});
    return 0;
}

}  // namespace

void add_serve(CommandLine& line) {
    auto options = std::make_shared<ServeVerb>();
    Verb verb = line.verb("serve", "Serve a campaign as a model that samplers call over HTTP (UM-Bridge)");
    verb.option("config", options->config, "The configuration (CONFIG.toml), or the name of an installed one")
        .required();
    verb.option("--input", options->inputs, "A key that is an input; may be repeated; default: the axes of the design")
        .one_each();
    verb.option("--output", options->outputs,
                "A quantity that is an output; may be repeated; default: mean_load and mean_maximum_1s")
        .one_each();
    verb.option("--case", options->case_name, "The case that is computed, where there are several");
    verb.option("-o,--output-folder", options->folder,
                "Keeps a campaign file for each point; default: CONFIG.served in this folder");
    verb.option("--host", options->host,
                "The numeric address to listen at; others than the default let other machines start computations, and "
                "need a token")
        .shows_default();
    verb.option("--token-file", options->token_file,
                "A file with a secret that requests must bear, at least 16 characters; default: that of the "
                "environment's FLOES_TOKEN, if any");
    verb.option("--port", options->port, "The port to listen at; 0 takes any free one")
        .within(0, 65535)
        .shows_default();
    verb.option("--threads", options->threads, "Number of members at a time; default: one for each core")
        .within(1, 4096);
    verb.option("--at-once", options->at_once,
                "Evaluations under way at a time, whose members share the cores; default: twice the members at a time")
        .within(1, most_at_once);
    verb.option("--waiting", options->waiting, "Evaluations that may wait; further ones are refused")
        .within(1, 100000)
        .shows_default();
    add_overrides(verb, options->overrides);
    verb.footer(examples);
    verb.runs([options] { return serve(*options); });
}

}  // namespace floes
