#include "cli/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <type_traits>
#include <utility>

#include "cli/answer.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "keys/meant.hpp"

namespace floes {
namespace {

/// "did you mean --threads?" or, if nothing is near, all that there is.
std::string hint(const std::string& word, const std::vector<std::string>& known, const char* all) {
    const auto distance = [&](const std::string& one) { return edit_distance(one, word); };
    const std::string nearest = *std::ranges::min_element(known, {}, distance);
    return distance(nearest) <= 1 + nearest.size() / 3 ? fmt::format("did you mean {}?", nearest)
                                                       : fmt::format("{} {}", all, fmt::join(known, ", "));
}

/// Throws CommandLineEnd for the first of these words that looks like an option and is none of `app`.
void refuse_unknown_options(const CLI::App& app, const std::vector<std::string>& words) {
    std::vector<std::string> known;
    const auto know = [&](const CLI::App& of) {
        for (const CLI::Option* one : of.get_options()) {
            for (const std::string& name : one->get_lnames()) known.push_back("--" + name);
            for (const std::string& name : one->get_snames()) known.push_back("-" + name);
        }
    };
    know(app);
    for (const CLI::App* group : app.get_subcommands([](const CLI::App* one) { return one->get_name().empty(); }))
        know(*group);
    for (const std::string& word : words) {
        const std::string name = word.substr(0, word.find('='));
        if (!name.starts_with('-') || std::ranges::find(known, name) != known.end()) continue;
        const std::string verb = app.get_parent() == nullptr ? "" : " " + app.get_name();
        throw CommandLineEnd(
            2, {},
            fmt::format("floes{}: there is no option {}; {}\n", verb, name, hint(name, known, "the options are")));
    }
}

/// "Take run times" -> "take run times"; "TOML file" stays.
std::string in_sentence(std::string text) {
    const bool word = text.size() > 1 && std::isupper(static_cast<unsigned char>(text[1])) == 0;
    if (word) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
}

std::vector<std::string> names_of(const std::vector<const CLI::Option*>& options) {
    std::vector<std::string> names;
    for (const CLI::Option* option : options) names.push_back(option->get_name());
    return names;
}

/// The options of `app` that were given.
std::vector<const CLI::Option*> given_of(const CLI::App& app) {
    std::vector<const CLI::Option*> given;
    for (const CLI::Option* option : app.get_options())
        if (option->count() > 0) given.push_back(option);
    return given;
}

/// What a command line lacks that has all options right; empty where it lacks nothing.
std::string what_is_missing(const CLI::App& app) {
    for (const CLI::Option* option : app.get_options()) {
        if (!option->get_required() || option->count() > 0) continue;
        const std::string what = in_sentence(option->get_description());
        return option->get_positional() ? " needs " + what : fmt::format(" needs {}: {}", option->get_name(), what);
    }
    std::vector<std::string> verbs;
    for (const CLI::App* inner : app.get_subcommands({})) {
        if (!inner->get_name().empty()) verbs.push_back(inner->get_name());
        if (!inner->get_name().empty() || inner->get_require_option_min() == 0) continue;
        std::vector<const CLI::Option*> all;
        for (const CLI::Option* option : inner->get_options())
            if (option != inner->get_help_ptr()) all.push_back(option);
        const auto given = given_of(*inner);
        if (given.size() == 1) continue;
        return fmt::format(
            " takes exactly one of {}; {}", fmt::join(names_of(all), ", "),
            given.empty() ? "none was given" : fmt::format("{} were given", fmt::join(names_of(given), " and ")));
    }
    if (app.get_require_subcommand_min() == 0 || !app.get_subcommands().empty()) return {};
    if (const std::vector<std::string> words = app.remaining(); !words.empty())
        return fmt::format(" has no {}; {}", words.front(), hint(words.front(), verbs, "it has"));
    return fmt::format(" needs one of {} behind it", fmt::join(verbs, ", "));
}

/// Which options cannot stand as they do; empty where they can.
std::string what_does_not_fit(const CLI::App& app) {
    for (const CLI::Option* option : given_of(app)) {
        for (const CLI::Option* other : option->get_needs())
            if (other->count() == 0) return fmt::format(": {} needs {}", option->get_name(), other->get_name());
        for (const CLI::Option* other : option->get_excludes())
            if (other->count() > 0)
                return fmt::format(": {} and {} cannot be given together", option->get_name(), other->get_name());
    }
    return {};
}

/// The option that the parser's message begins with, as "--size: …"; nullptr if it begins with none.
const CLI::Option* option_of(const CLI::App& app, const std::string& message) {
    const CLI::Option* option = app.get_option_no_throw(message.substr(0, message.find(':')));
    for (const CLI::App* inner : app.get_subcommands({}))
        if (option == nullptr && inner->get_name().empty()) option = option_of(*inner, message);
    return option;
}

/// The parser's error in our words, without the end of the sentence.
std::string in_our_words(const CLI::App& app, const CLI::ParseError& error) {
    const std::string message = error.what();
    const CLI::Option* option = option_of(app, message);
    const auto kind = static_cast<CLI::ExitCodes>(error.get_exit_code());
    if (kind == CLI::ExitCodes::ArgumentMismatch && option != nullptr) {
        const int wanted = option->get_items_expected_min();
        return wanted > 1
                   ? fmt::format(": {} takes {} values", option->get_name(), wanted)
                   : fmt::format(": {} needs a value: {}", option->get_name(), in_sentence(option->get_description()));
    }
    std::string sentence;
    if (kind == CLI::ExitCodes::RequiredError) sentence = what_is_missing(app);
    if (kind == CLI::ExitCodes::RequiresError || kind == CLI::ExitCodes::ExcludesError)
        sentence = what_does_not_fit(app);
    if (kind == CLI::ExitCodes::ExtrasError)
        sentence = fmt::format(" has no use for {}", fmt::join(app.remaining(), " "));
    return sentence.empty() ? ": " + message : sentence;
}

/// "floes laboratory plate".
std::string full_name(const CLI::App& app) {
    return app.get_parent() == nullptr ? "floes" : full_name(*app.get_parent()) + " " + app.get_name();
}

/// Numbers as people write them, without zeros behind.
std::string number_text(double value) {
    return fmt::format("{:.15g}", value);
}

/// The fault of a word that should be a number; empty if it is one.
template <class Number>
std::string number_fault(const std::string& word) {
    Number value{};
    if (CLI::detail::lexical_cast(word, value) && std::isfinite(static_cast<double>(value))) return {};
    if (const std::string pointed = with_decimal_point(word); !pointed.empty())
        return fmt::format("{} is no number; write {}, with a point", word, pointed);
    return fmt::format("{} is no {}number", word, std::is_integral_v<Number> ? "whole " : "");
}

/// Takes the zeros off a whole number in front of which CLI11 would read it as octal.
std::string without_leading_zeros(std::string& word) {
    const std::size_t sign = word.starts_with('-') || word.starts_with('+') ? 1 : 0;
    if (word.size() > sign && word.find_first_not_of("0123456789", sign) == std::string::npos)
        word.erase(sign, std::min(word.find_first_not_of('0', sign), word.size() - 1) - sign);
    return {};
}

/// Checks the words of an option that is read into a `Value`, or several or perhaps one of them; --help shows nothing
/// of it.
template <class Value>
void expect_numbers(CLI::Option& option, const Value& /*read_into*/) {
    if constexpr (std::is_integral_v<Value>) option.transform(CLI::Validator(without_leading_zeros, "", ""));
    if constexpr (std::is_arithmetic_v<Value>)
        option.check(CLI::Validator([](const std::string& word) { return number_fault<Value>(word); }, "", ""));
}

template <class Value>
void expect_numbers(CLI::Option& option, const std::vector<Value>& /*read_into*/) {
    expect_numbers(option, Value{});
}

template <class Value>
void expect_numbers(CLI::Option& option, const std::optional<Value>& /*read_into*/) {
    expect_numbers(option, Value{});
}

/// Numbers for which `allowed` is true; `words` are what is allowed, and `help` the same in --help.
template <class Number, class Allowed>
void allow(CLI::Option& option, const Allowed& allowed, const std::string& words, const std::string& help) {
    const auto fault = [&option, allowed, words](const std::string& word) -> std::string {
        Number value{};
        if (!CLI::detail::lexical_cast(word, value)) return number_fault<Number>(word);
        if (allowed(value)) return {};
        const bool many = option.get_delimiter() == ',';
        return fmt::format("{} is not {}{}", word, words,
                           many ? " (a comma begins the next value; decimals have a point)" : "");
    };
    option.check(CLI::Validator(fault, help, ""));
}

template <class Number>
void allow_range(CLI::Option& option, Number low, Number high) {
    const std::string ends[]{number_text(low), number_text(high)};
    allow<Number>(
        option, [=](Number value) { return value >= low && value <= high; },
        fmt::format("from {} to {}", ends[0], ends[1]),
        fmt::format("{} in [{} - {}]", std::is_integral_v<Number> ? "INT" : "FLOAT", ends[0], ends[1]));
}

/// The verb below `app`; nullptr if there is none.
CLI::App* inner_of(CLI::App& app, const std::string& verb) {
    const auto named = app.get_subcommands([&](const CLI::App* one) { return one->get_name() == verb; });
    return named.empty() ? nullptr : named.front();
}

}  // namespace

Option& Option::required() {
    option_->required();
    return *this;
}

Option& Option::one_of(const std::vector<std::string>& words) {
    const auto fault = [words](const std::string& word) {
        return std::ranges::find(words, word) != words.end()
                   ? std::string()
                   : fmt::format("there is no {}; {}", word, hint(word, words, "allowed are"));
    };
    option_->check(CLI::Validator(fault, fmt::format("{{{}}}", fmt::join(words, ",")), ""));
    return *this;
}

Option& Option::within(int low, int high) {
    allow_range(*option_, low, high);
    return *this;
}

Option& Option::within(double low, double high) {
    allow_range(*option_, low, high);
    return *this;
}

Option& Option::positive() {
    allow<double>(
        *option_, [](double value) { return value > 0; }, "above 0", "POSITIVE");
    return *this;
}

Option& Option::not_negative() {
    allow<double>(
        *option_, [](double value) { return value >= 0; }, "0 or more", "NONNEGATIVE");
    return *this;
}

Option& Option::comma_separated() {
    option_->delimiter(',')->allow_extra_args(false);
    return *this;
}

Option& Option::exactly(int values) {
    option_->expected(values);
    return *this;
}

Option& Option::one_each() {
    option_->type_size(1)->allow_extra_args(false);
    return *this;
}

Option& Option::last_wins() {
    option_->take_last();
    return *this;
}

Option& Option::shows_default() {
    option_->capture_default_str();
    return *this;
}

Option& Option::file_ending(const std::vector<std::string>& endings) {
    const auto check = [endings](const std::string& name) {
        const bool meant = std::ranges::any_of(endings, [&](const std::string& one) { return name.ends_with(one); });
        return meant ? std::string()
                     : fmt::format("{} would not be what its name says; give it a name that ends with {}", name,
                                   fmt::join(endings, " or "));
    };
    option_->check(CLI::Validator(check, "", ""));
    return writes_file();
}

Option& Option::writes_file() {
    const auto fault = [](const std::string& name) -> std::string {
        try {
            expect_place(name);
        } catch (const InputError& refused) {
            return refused.what();
        }
        return {};
    };
    option_->check(CLI::Validator(fault, "", ""));
    return *this;
}

Option& Option::value_name(const std::string& name) {
    option_->type_name(name);
    return *this;
}

Option& Option::needs(const Option& other) {
    option_->needs(other.option_);
    return *this;
}

Option& Option::excludes(const Option& other) {
    option_->excludes(other.option_);
    return *this;
}

bool Option::given() const {
    return option_->count() > 0;
}

template <class Value>
Option OptionList::option(const std::string& names, Value& value, const std::string& help) {
    CLI::Option* option = app_->add_option(names, value, help);
    expect_numbers(*option, value);
    return Option(option);
}

template Option OptionList::option(const std::string&, std::string&, const std::string&);
template Option OptionList::option(const std::string&, int&, const std::string&);
template Option OptionList::option(const std::string&, double&, const std::string&);
template Option OptionList::option(const std::string&, std::vector<std::string>&, const std::string&);
template Option OptionList::option(const std::string&, std::vector<int>&, const std::string&);
template Option OptionList::option(const std::string&, std::vector<double>&, const std::string&);
template Option OptionList::option(const std::string&, std::optional<int>&, const std::string&);
template Option OptionList::option(const std::string&, std::optional<double>&, const std::string&);

Option OptionList::flag(const std::string& names, bool& value, const std::string& help) {
    return Option(app_->add_flag(names, value, help));
}

OptionList Verb::exactly_one_of(const std::string& name, const std::string& title) {
    CLI::Option_group* group = app_->add_option_group(name, title);
    group->require_option(1);
    return OptionList(group);
}

void Verb::footer(const std::string& text) {
    app_->footer(text);
}

void Verb::runs(std::function<int()> action) {
    app_->callback([action = std::move(action), status = exit_status_] { *status = action(); });
}

void Verb::prints(std::function<std::string()> answer) {
    runs([answer = std::move(answer)] {
        std::fputs(answer().c_str(), stdout);
        return 0;
    });
}

Verb Verb::inner(const std::string& name, const std::string& description) {
    app_->require_subcommand(1);
    return {app_->add_subcommand(name, description), exit_status_};
}

CommandLine::CommandLine(const std::string& description)
    : app_(std::make_unique<CLI::App>(description)), exit_status_(std::make_shared<int>(0)) {
    app_->require_subcommand(1);
}

CommandLine::~CommandLine() = default;

Verb CommandLine::verb(const std::string& name, const std::string& description) {
    return {app_->add_subcommand(name, description), exit_status_};
}

void CommandLine::moved(const std::string& former, const std::string& now) {
    CLI::App* verb = app_->add_subcommand(former)->group("")->prefix_command();  // "": not in --help
    verb->set_help_flag();
    verb->callback([=] {
        throw CommandLineEnd(2, {},
                             fmt::format("floes: {} is called floes {} now; its options are the same.\n", former, now));
    });
}

void CommandLine::version(const std::function<std::string()>& text, const std::string& help) {
    app_->set_version_flag("--version", text, help);
    app_->add_subcommand("version", help)->callback([text] { throw CommandLineEnd(0, text() + "\n", {}); });
}

void CommandLine::help_verb() {
    const auto words = std::make_shared<std::vector<std::string>>();
    CLI::App* help = app_->add_subcommand("help", "Say of a verb what its --help says");
    help->add_option("verb", *words, "The verb, as run or laboratory plate; none: all verbs in a line each");
    help->callback([this, words] {
        // help() of the program itself would show the verb that was chosen, which is this one.
        const CLI::App* asked = find(*words);
        std::string before;
        for (const CLI::App* app = asked->get_parent(); app != nullptr; app = app->get_parent())
            before = app->get_name() + (before.empty() ? "" : " ") + before;
        throw CommandLineEnd(0, asked == app_.get() ? whole_help_ : asked->help(before), {});
    });
}

/// The verb of these words; none: the program.
CLI::App* CommandLine::find(const std::vector<std::string>& verb) const {
    CLI::App* app = app_.get();
    for (const std::string& word : verb) {
        CLI::App* inner = inner_of(*app, word);
        if (inner == nullptr && app == app_.get()) refuse_unknown(word);
        if (inner == nullptr) break;
        app = inner;
    }
    return app;
}

void CommandLine::refuse_unknown(const std::string& word) const {
    if (word.empty() || inner_of(*app_, word) != nullptr) return;
    if (word.front() == '-') {
        refuse_unknown_options(*app_, {word});
        return;
    }
    std::vector<std::string> verbs;
    for (const CLI::App* one : app_->get_subcommands({}))
        if (!one->get_group().empty()) verbs.push_back(one->get_name());
    if (verbs.empty()) return;
    throw CommandLineEnd(2, {},
                         fmt::format("floes: there is no verb {}; {}\n", word, hint(word, verbs, "the verbs are")));
}

void CommandLine::footer(const std::string& text) {
    app_->footer(text);
}

int CommandLine::run(std::span<char* const> words) {
    if (!words.empty()) app_->name(words.front());
    if (words.size() == 1) throw CommandLineEnd(0, app_->help(), {});
    return run(std::vector<std::string>(words.begin() + (words.empty() ? 0 : 1), words.end()));
}

int CommandLine::run(const std::vector<std::string>& words) {
    if (!words.empty()) refuse_unknown(words.front());
    whole_help_ = app_->help();
    try {
        app_->parse(std::vector<std::string>(words.rbegin(), words.rend()));
    } catch (const CLI::ParseError& error) {
        const CLI::App* asked = app_.get();
        while (!asked->get_subcommands().empty()) asked = asked->get_subcommands().front();
        refuse_unknown_options(*asked, asked->remaining());
        if (error.get_exit_code() != 0) {
            const std::string verb = full_name(*asked);
            const std::string said = in_our_words(*asked, error);
            throw CommandLineEnd(
                2, {}, fmt::format("{}{}{} {} --help says more\n", verb, said, said.ends_with('?') ? "" : ";", verb));
        }
        std::ostringstream output;
        app_->exit(error, output, output);
        throw CommandLineEnd(0, output.str(), {});
    }
    return *exit_status_;
}

std::string CommandLine::typed_program() const {
    if (const char* launcher = std::getenv("FLOES_LAUNCHER")) return shell_word(launcher);
    return app_->get_name().empty() ? "floes" : shell_word(app_->get_name());
}

}  // namespace floes
