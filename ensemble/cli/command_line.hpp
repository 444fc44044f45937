#pragma once
// The command line of the program: its verbs, their options, and what these may be. The door to CLI11, which takes nine
// seconds to compile wherever it is included.
//
//   CommandLine line("what the program is");
//   Verb verb = line.verb("status", "Show the members done, failed and still to do");
//   verb.option("campaign", options->file, "The campaign file").required();
//   verb.runs([options] { return show(*options); });
//   return line.run(words);

#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace floes {

/// Ends the program: the command line was wrong (exit status 2), or asked for help or the version (0).
class CommandLineEnd : public std::runtime_error {
  public:
    /// `output`: for standard output; `errors`: for standard error.
    CommandLineEnd(int status, std::string output, const std::string& errors)
        : std::runtime_error(errors), status_(status), output_(std::move(output)) {}

    int status() const { return status_; }
    const std::string& output() const { return output_; }

  private:
    int status_;
    std::string output_;
};

/// An option of a verb, or a positional argument.
class Option {
  public:
    explicit Option(CLI::Option* option) : option_(option) {}

    Option& required();
    Option& one_of(const std::vector<std::string>& words);
    Option& within(int low, int high);
    Option& within(double low, double high);
    Option& positive();
    Option& not_negative();
    Option& comma_separated();
    Option& exactly(int values);
    Option& one_each();  ///< one value each time it is given; the next word is an argument of the verb
    Option& last_wins();
    Option& shows_default();
    Option& writes_file();  ///< names a file that is written; refused where its folder does not permit that
    Option& file_ending(const std::vector<std::string>& endings);  ///< of the file that it writes, as ".html"
    Option& value_name(const std::string& name);
    Option& needs(const Option& other);
    Option& excludes(const Option& other);

    bool given() const;

  private:
    CLI::Option* option_;
};

/// A list of options: those of a verb, or a group of which one is chosen.
class OptionList {
  public:
    explicit OptionList(CLI::App* app) : app_(app) {}

    /// `names`: "-o,--output", or one word without dashes for a positional argument. Value: std::string, int, double,
    /// or a vector or std::optional of these, as listed in command_line.cpp.
    template <class Value>
    Option option(const std::string& names, Value& value, const std::string& help);
    Option flag(const std::string& names, bool& value, const std::string& help);

  protected:
    CLI::App* app_;
};

class Verb : public OptionList {
  public:
    Verb(CLI::App* app, std::shared_ptr<int> exit_status) : OptionList(app), exit_status_(std::move(exit_status)) {}

    /// Options of which exactly one is given; `title` says so in --help.
    OptionList exactly_one_of(const std::string& name, const std::string& title);

    void footer(const std::string& text);

    /// The function that carries out the verb after its options are read; it returns the exit status.
    void runs(std::function<int()> action);

    /// The function that gives the verb's answer, for standard output; the exit status is 0.
    void prints(std::function<std::string()> answer);

    /// A verb below this one, as in "floes laboratory plate"; the user has to choose one.
    Verb inner(const std::string& name, const std::string& description);

  private:
    std::shared_ptr<int> exit_status_;
};

class CommandLine {
  public:
    explicit CommandLine(const std::string& description = {});
    ~CommandLine();

    Verb verb(const std::string& name, const std::string& description);
    /// Refuses the verb of an earlier version with a sentence that names what it is called now.
    void moved(const std::string& former, const std::string& now);
    /// The flag --version and the verb version, which print what `text` returns.
    void version(const std::function<std::string()>& text, const std::string& help);
    void footer(const std::string& text);
    /// The verb help, which says of another verb what its --help says.
    void help_verb();

    /// Runs the verb of a command line whose first word is the program, and returns its exit status. Throws
    /// CommandLineEnd, and what the verb throws.
    int run(std::span<char* const> words);
    /// The same without the program's name.
    int run(const std::vector<std::string>& words);

    /// What people type to start the program: the script that started it, otherwise the first word of the command line.
    std::string typed_program() const;

    /// For manual pages and completions.
    const CLI::App& app() const { return *app_; }

  private:
    CLI::App* find(const std::vector<std::string>& verb) const;
    void refuse_unknown(const std::string& word) const;

    std::unique_ptr<CLI::App> app_;
    std::shared_ptr<int> exit_status_;
    std::string whole_help_;  ///< of the program, before a verb is chosen
};

}  // namespace floes
