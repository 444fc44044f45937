#pragma once
// Changes of a text file: those that must not matter to whoever reads it, and cuts, which must.

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace floes {

using TextChange = std::function<std::string(const std::string&)>;

/// Every `from` as `to`.
inline std::string replaced(std::string text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

/// Every number between blanks, commas and brackets, written by `write`; other words stay.
inline std::string with_numbers(const std::string& text, const std::function<std::string(double)>& write) {
    std::string changed;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" \t\r\n,[]{}:", at), text.size());
        const std::string_view word = std::string_view(text).substr(at, end - at);
        double number = 0;
        const auto [stop, fault] = std::from_chars(word.data(), word.data() + word.size(), number);
        const bool is_number = !word.empty() && fault == std::errc{} && stop == word.data() + word.size();
        changed += is_number ? write(number) : std::string(word);
        if (end < text.size()) changed += text[end];
        at = end + 1;
    }
    return changed;
}

inline std::string in_case(std::string text, int (*change)(int)) {
    for (char& one : text) one = static_cast<char>(change(static_cast<unsigned char>(one)));
    return text;
}

inline std::vector<std::pair<std::string, TextChange>> line_changes() {
    return {
        {"CRLF", [](const std::string& text) { return replaced(text, "\n", "\r\n"); }},
        {"CR", [](const std::string& text) { return replaced(text, "\n", "\r"); }},
        {"byte order mark", [](const std::string& text) { return "\xEF\xBB\xBF" + text; }},
        {"empty lines", [](const std::string& text) { return "\n" + replaced(text, "\n", "\n \n"); }},
        {"no last line end", [](const std::string& text) { return text.substr(0, text.find_last_not_of('\n') + 1); }}};
}

/// With sixteen digits behind the point; with as many as are needed; and with a sign, which JSON does not have.
inline std::vector<std::pair<std::string, TextChange>> number_changes() {
    const auto by = [](const std::function<std::string(double)>& write) {
        return [write](const std::string& text) { return with_numbers(text, write); };
    };
    return {{"1e1", by([](double number) { return fmt::format("{:.16e}", number); })},
            {"1E1", by([](double number) { return fmt::format("{:.16E}", number); })},
            {"10.0", by([](double number) { return fmt::format("{:.17f}", number); })}};
}

inline std::vector<std::pair<std::string, TextChange>> lenient_number_changes() {
    const auto by = [](const std::function<std::string(double)>& write) {
        return [write](const std::string& text) { return with_numbers(text, write); };
    };
    return {{"10.", by([](double number) {
                 const std::string plain = fmt::format("{}", number);
                 return plain.find_first_of(".e") == std::string::npos ? plain + "." : plain;
             })},
            {"+10", by([](double number) { return fmt::format("{:+}", number); })}};
}

/// The file cut behind every line, and behind every so many bytes.
inline std::vector<std::string> cuts_of(const std::string& bytes, std::size_t step) {
    std::vector<std::string> cuts;
    for (std::size_t at = 0; at < bytes.size(); ++at)
        if (at % step == 0 || (at > 0 && bytes[at - 1] == '\n')) cuts.push_back(bytes.substr(0, at));
    return cuts;
}

}  // namespace floes
