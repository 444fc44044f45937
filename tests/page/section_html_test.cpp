// Sections as HTML.

#include "page/section_html.hpp"

#include <gmock/gmock.h>

namespace floes {
namespace section_html_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Figure figure_of(std::string caption) {
    return {.description = "test", .caption = std::move(caption)};
}

std::size_t count_of(const std::string& text, const std::string& words) {
    std::size_t count = 0;
    for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
    return count;
}

/// A row for each of the words, for these readers.
Results rows_of(const std::vector<std::pair<std::string, Results::For>>& words) {
    Results results{.columns = {{"", "a"}, {"", "b"}}};
    for (const auto& [word, whom] : words) results.add({word, 1}, whom);
    return results;
}

TEST(SectionHtml, TellsWhatTheTextTellsAndShowsRowsAndFiguresOfThePageAlone) {
    const Section told{.title = "Loads",
                       .before = "! Beware.\nOne.\nTwo.\n\nThree.\n",
                       .results = {rows_of({{"x", Results::For::everybody}, {"y", Results::For::on_page}})},
                       .after = "\nMeaning.\n",
                       .notes = {"First.", "Second."},
                       .figures = {figure_of("A caption")}};
    const std::string html = section_html(told, "Everything");
    EXPECT_THAT(html,
                AllOf(HasSubstr("<h3>Loads</h3>"),
                      HasSubstr("<p class=\"warning\">Beware.</p>\n<p>One.<br>\nTwo.</p>\n<p>Three.</p>"),
                      HasSubstr("<tr><td>x</td><td>1</td></tr>\n</table>"),
                      HasSubstr("<details><summary>Further rows</summary>"), HasSubstr("<tr><td>y</td><td>1</td></tr>"),
                      HasSubstr("<p class=\"note\">\nMeaning."), HasSubstr("<li>First.</li>\n<li>Second.</li>"),
                      HasSubstr("<figcaption>A caption</figcaption>")));
    EXPECT_THAT(section_html(told, "Loads of everything"), Not(HasSubstr("<h3>")));
    EXPECT_EQ(section_html({}, "Loads"), "");
}

TEST(SectionHtml, FoldsRowsThatTheTextHas) {
    const Section told{.results = {rows_of({{"x", Results::For::everybody}, {"y", Results::For::folded}})}};
    EXPECT_THAT(section_html(told, ""), HasSubstr("<details><summary>Further rows</summary>"));
    EXPECT_EQ(text(std::vector{told}, 20), "a  b\n----\nx  1\ny  1\n");
}

TEST(SectionHtml, SaysWhatIsWrongFirst) {
    const std::string html = page_one_html("Loads", {.sentence = "E30: 20 N"}, {{"n = 2"}, {}, {}}, {});
    EXPECT_LT(html.find("<p class=\"warning\">n = 2</p>"), html.find("E30: 20 N"));
    EXPECT_THAT(page_one_html("Loads", {}, {{"Nothing done"}, {}, {}}, {}), HasSubstr("No member is done yet."));
}

// From 0 to 20 N over 100 of 110 units: 5 N, from 2 to 8 N, has its dot at 5 + 100 · 5 / 20, and the limit of 10 N is
// in the middle.
TEST(SectionHtml, DrawsEstimatesToTheScaleOfTheirColumn) {
    Results results{.columns = {{"case", "case"}, estimates("load", "load", "N")}, .view = Results::View::drawn};
    results.columns.back().limit = 10;
    results.add({"small", Estimate{5, 2, 8}});
    results.add({"large", Estimate{20, 16, 24, false}});
    results.add({"none", Undefined{"needs 4 more"}});
    const std::string html = section_html({.results = {results}}, "");
    EXPECT_THAT(html, HasSubstr("d=\"M15.0 7H45.0\""));
    EXPECT_THAT(html, HasSubstr("cx=\"30.0\" cy=\"7\""));
    EXPECT_THAT(html, HasSubstr("cx=\"105.0\""));
    EXPECT_THAT(html, HasSubstr("M55.0 0V14"));
    EXPECT_THAT(html, HasSubstr("<i>0</i><i>20</i>"));
    EXPECT_THAT(html, HasSubstr("<td class=\"words\" data-head=\"load, N\">needs 4 more</td>"));
}

TEST(SectionHtml, ClosesLongTablesAtFirst) {
    const std::vector<std::pair<std::string, Results::For>> words(39, {"x", Results::For::everybody});
    Section told{.title = "Points", .results = {rows_of(words)}};
    EXPECT_THAT(section_html(told, ""), Not(HasSubstr("<details>")));
    told.results.front().add({"x", 1});
    EXPECT_THAT(section_html(told, ""), HasSubstr("<h3>Points</h3>\n<details><summary>40 rows</summary>"));
}

TEST(SectionHtml, PutsFiguresWithoutACaptionBesideTheNext) {
    const std::string html =
        section_html({.figures = {figure_of("first"), figure_of(""), figure_of("second and third")}}, "");
    EXPECT_EQ(count_of(html, "<figure>"), 2u);
    EXPECT_EQ(count_of(html, "<div class=\"panels\">"), 1u);
    EXPECT_EQ(count_of(html, "<svg"), 3u);
}

}  // namespace section_html_test
}  // namespace floes
