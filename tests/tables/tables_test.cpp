// One table value, four writers.

#include <gmock/gmock.h>

#include <cmath>

#include "tables/section.hpp"

namespace floes {
namespace tables_test {

DataRows records() {
    return {"loads",
            {"name", "mean", "steady", "most"},
            {{"E30, \"soft\"", 1.5, true, 2}, {Named{"E60", "stiff"}, std::nan(""), false, Absent{}}}};
}

TEST(Csv, QuotesWhatWouldBeMisread) {
    EXPECT_EQ(csv(records()), "name,mean,steady,most\n\"E30, \"\"soft\"\"\",1.5,1,2\nE60,,0,\n");
}

TEST(Csv, HasItsHeaderWithoutRows) {
    EXPECT_EQ(csv(DataRows{"", {"name"}}), "name\n");
    EXPECT_EQ(csv(DataRows{.place = "", .names = {"name"}, .in_csv = false}), "");
}

TEST(Json, PutsValuesUnderTheirNames) {
    EXPECT_EQ(json(std::vector{records()}),
              R"({
  "loads": [
    {
      "name": "E30, \"soft\"",
      "mean": 1.5,
      "steady": true,
      "most": 2
    },
    {
      "name": "E60",
      "mean": null,
      "steady": false
    }
  ]
}
)");
}

TEST(Json, HasEmptyListsListsOfValuesAndObjects) {
    const auto values = [](const std::string& one) -> std::vector<Datum> { return {one}; };
    const std::vector<DataRows> all{DataRows{"a/rows", {"name"}},
                                    data_rows(list("a/notes", ".", std::vector<std::string>{"one", "two"}, values)),
                                    data_rows(object("", {{"runs", 3}}))};
    EXPECT_EQ(json(all),
              "{\n  \"a\": {\n    \"rows\": [],\n    \"notes\": [\n      \"one\",\n      \"two\"\n    ]\n  },\n"
              "  \"runs\": 3\n}\n");
    EXPECT_EQ(json(std::vector{DataRows{.place = "a", .names = {"name"}, .in_json = false}}), "{}\n");
}

TEST(Json, HasNoValueForWhatOnlyPeopleCallSomething) {
    EXPECT_EQ(json(std::vector{data_rows(object("", {{"start", Named{"", "none"}}}))}), "{\n  \"start\": null\n}\n");
}

TEST(TextColumns, PutBelowWhatDoesNotFit) {
    const Table table{{"name", "one", "two"}, {"ξ", "1", "22222"}};
    EXPECT_EQ(text_columns(table, 80), "name  one    two\n----------------\nξ       1  22222\n");
    EXPECT_EQ(text_columns(table, 10), "name  one\n---------\nξ       1\n\nname    two\n-----------\nξ     22222\n");
}

TEST(TextColumns, KeepAValueAndItsRangeTogether) {
    EXPECT_EQ(text_columns({{"a", "mean"}, {"x", {"1", "[0, 2]"}}}, 80), "a      mean\n-----------\nx  1 [0, 2]\n");
}

TEST(TextPanels, AreEquallyWideAndRepeatTheHeading) {
    const Table table{{"case", "E30", "E200"}, {"mean", {"1.5", "[1, 2]"}, {"10.5", "[9, 12]"}}};
    EXPECT_EQ(text_panels(table, 80),
              "case    E30           E200\n----------------------------------\nmean    1.5 [1, 2]    10.5 [9, 12]\n");
    EXPECT_EQ(text_panels(table, 20),
              "case    E30\n-------------------\nmean    1.5 [1, 2]\n\n"
              "case   E200\n-------------------\nmean   10.5 [9, 12]\n");
}

TEST(Html, EscapesAndPutsRangesBelow) {
    EXPECT_EQ(html_table({{"a<b"}, {Cell{"1", "[0, 2]"}}}),
              "<div class=\"wide\"><table><tr><th>a&lt;b</th></tr>\n"
              "<tr><td>1<br><small>[0, 2]</small></td></tr>\n</table></div>\n");
}

TEST(Section, IsWrittenInEveryWay) {
    Results loads{.place = "loads", .columns = {{"name", "a"}, {"", "b"}, {"mean"}}};
    loads.add({"x", "1", 1.5});
    const std::vector<Section> told{{.before = "Loads\n\n", .results = {loads}, .after = "\nNote.\n"},
                                    {.missing = "Nothing is known.\n"}};
    EXPECT_EQ(text(told, 80), "Loads\n\na  b\n----\nx  1\n\nNote.\n\nNothing is known.\n");
    EXPECT_THAT(csv(told), testing::StartsWith("name,mean\nx,1.5"));
    EXPECT_THAT(json(told), testing::HasSubstr("\"loads\""));
}

}  // namespace tables_test
}  // namespace floes
