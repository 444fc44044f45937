#include "cli/command_line.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <optional>
#include <sstream>
#include <utility>

namespace floes {

Option& Option::required() {
    option_->required();
    return *this;
}

Option& Option::one_of(const std::vector<std::string>& words) {
    option_->check(CLI::IsMember(words));
    return *this;
}

Option& Option::within(int low, int high) {
    option_->check(CLI::Range(low, high));
    return *this;
}

Option& Option::within(double low, double high) {
    option_->check(CLI::Range(low, high));
    return *this;
}

Option& Option::positive() {
    option_->check(CLI::PositiveNumber);
    return *this;
}

Option& Option::not_negative() {
    option_->check(CLI::NonNegativeNumber);
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
    return Option(app_->add_option(names, value, help));
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
}

void CommandLine::footer(const std::string& text) {
    app_->footer(text);
}

template <class Parse>
int CommandLine::run_parsed(const Parse& parse) {
    try {
        parse();
    } catch (const CLI::ParseError& error) {
        std::ostringstream output;
        std::ostringstream errors;
        const int status = app_->exit(error, output, errors) == 0 ? 0 : 2;
        throw CommandLineEnd(status, output.str(), errors.str());
    }
    return *exit_status_;
}

int CommandLine::run(std::span<char* const> words) {
    return run_parsed([&] { app_->parse(static_cast<int>(words.size()), words.data()); });
}

int CommandLine::run(const std::vector<std::string>& words) {
    return run_parsed([&] { app_->parse(std::vector<std::string>(words.rbegin(), words.rend())); });
}

std::string CommandLine::program_name() const {
    return app_->get_name();
}

}  // namespace floes
