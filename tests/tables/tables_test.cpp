// One table value, four writers.

#include <gmock/gmock.h>

#include <cmath>

#include "tables/section.hpp"

namespace floes {
namespace tables_test {

struct Load {
    std::string name;
    double mean = 0;
    int runs = 0;
    bool steady = true;
};

const std::vector<Load> loads{{"E30, \"soft\"", 1.5, 3, true}, {"E60", std::nan(""), 0, false}};

DataRows records() {
    return make_rows<Load>("loads", loads,
                           {{"name", &Load::name},
                            {Names{"mean_N", "mean/estimate"}, &Load::mean},
                            {Names{"runs", ""}, &Load::runs},
                            {Names{"", "steady"}, &Load::steady},
                            {"most", [](const Load& one) { return one.runs > 0 ? Datum(2) : Datum(Absent{}); }}});
}

TEST(Csv, QuotesWhatWouldBeMisread) {
    EXPECT_EQ(csv(records()), "name,mean_N,runs,most\n\"E30, \"\"soft\"\"\",1.5,3,2\nE60,,0,\n");
}

TEST(Csv, HasItsHeaderWithoutRows) {
    EXPECT_EQ(csv(make_rows<Load>("", {}, {{"name", &Load::name}})), "name\n");
    EXPECT_EQ(csv(json_only(records())), "");
}

TEST(Json, PutsValuesWhereTheirNamesSay) {
    EXPECT_EQ(json(std::vector{records()}),
              R"({
  "loads": [
    {
      "name": "E30, \"soft\"",
      "mean": {
        "estimate": 1.5
      },
      "steady": true,
      "most": 2
    },
    {
      "name": "E60",
      "mean": {
        "estimate": null
      },
      "steady": false
    }
  ]
}
)");
}

TEST(Json, HasEmptyListsAndListsOfValues) {
    const std::vector<DataRows> all{make_rows<Load>("a/rows", {}, {{"name", &Load::name}}),
                                    make_list("a/notes", std::vector<std::string>{"one", "two"}),
                                    make_object("", loads[0], {{Names{"", "runs"}, &Load::runs}})};
    EXPECT_EQ(json(all),
              "{\n  \"a\": {\n    \"rows\": [],\n    \"notes\": [\n      \"one\",\n      \"two\"\n    ]\n  },\n"
              "  \"runs\": 3\n}\n");
    EXPECT_EQ(json(std::vector{csv_only(records())}), "{}\n");
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
    EXPECT_EQ(html_table({{"a<b"}, {Cell{"1", "[0, 2]", "[-1, 3]"}}}),
              "<div class=\"wide\"><table><tr><th>a&lt;b</th></tr>\n"
              "<tr><td>1<br><small>[0, 2]</small><br><small>[-1, 3]</small></td></tr>\n</table></div>\n");
}

TEST(Section, IsWrittenInEveryWay) {
    const std::vector<Section> told{{.before = "Loads\n\n", .table = {{"a", "b"}, {"x", "1"}}, .after = "\nNote.\n"},
                                    {.records = {records()}},
                                    {.missing = "Nothing is known.\n"}};
    EXPECT_EQ(text(told, 80), "Loads\n\na  b\n----\nx  1\n\nNote.\n\nNothing is known.\n");
    EXPECT_THAT(csv(told), testing::StartsWith("name,mean_N,"));
    EXPECT_THAT(json(told), testing::HasSubstr("\"loads\""));
}

}  // namespace tables_test
}  // namespace floes
