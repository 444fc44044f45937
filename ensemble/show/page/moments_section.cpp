#include "page/moments_section.hpp"

#include <span>
#include <sstream>

#include "core/base64.hpp"
#include "page/html_parts.hpp"

namespace floes {
namespace {

std::string embedded(const MomentPicture& picture) {
    std::ostringstream text;
    write_base64(text, std::as_bytes(std::span(picture.png)));
    const std::string caption = html_escaped(picture.caption);
    return fmt::format(
        "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption></figure>\n", caption,
        text.str());
}

}  // namespace

std::vector<int> pictured_members(const ReportData& data, bool all) {
    if (!all) return data.largest_member < 0 ? std::vector<int>{} : std::vector<int>{data.largest_member};
    std::vector<int> members;
    for (int k = 0; k < static_cast<int>(data.table.cases.size()); ++k) {
        const auto worst =
            member_with_largest_load(data.table, [k](const MemberRow& row) { return row.case_index == k; });
        if (worst) members.push_back(*worst);
    }
    return members;
}

std::string replay_command(const ReportData& data, int member) {
    return fmt::format("floes replay {} {} --worst -o worst.html", data.file_name, member);
}

std::string moments_section(const ReportData& data) {
    std::string body;
    for (const Moment& moment : data.moments) {
        const MemberRow& row = data.table.members[static_cast<std::size_t>(moment.member)];
        body += fmt::format("<h3>{}: {:.1f} N in member {}</h3>\n",
                            html_escaped(data.table.cases[static_cast<std::size_t>(row.case_index)].name),
                            row.load.maximum, moment.member);
        for (const MomentPicture& picture : moment.pictures) body += embedded(picture);
        if (!moment.differences.empty())
            body += note("The member computed for these pictures is not to the bit the one in the file: " +
                         moment.differences.front());
        body += fmt::format("<p>To watch it: <code>{}</code></p>\n", html_escaped(replay_command(data, moment.member)));
    }
    if (body.empty()) return "";
    return section(data.moments.size() > 1 ? "The worst moments" : "The worst moment", body);
}

}  // namespace floes
