#!/usr/bin/python3
"""Makes the files of a new finding or a new key, with their test, and says what is left to do by hand.

Usage: tools/add.py finding NAME "Title of its section"
       tools/add.py key TABLE.NAME[_unit]

What is made compiles, its test passes, and its figures are placeholders: the mean load; a number that nothing reads.
"""
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]

FINDING = '''// {title}.

#include "findings/sections.hpp"
#include "findings/summary.hpp"

namespace floes {{

Section {name}_section(Evidence& evidence) {{
    const Sample& sample = evidence.sample;
    Results results{{.place = "{name}",
                    .columns = {{{{"case", "case"}}, {{"runs", "runs"}}, estimates("load", "mean load", "N")}}}};
    for (std::size_t k = 0; k < sample.cases.size(); ++k) {{
        const Members& members = sample.done(k);
        results.add({{evidence.summary.named(k), members.size(), over(sample, members, quantity("mean_load"))}});
    }}
    return {{.title = "{title}", .results = {{std::move(results)}}, .after = "\\nMean over members.\\n"}};
}}

}}  // namespace floes
'''
FINDING_TEST = '''#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "findings/example.hpp"
#include "findings/sections.hpp"

namespace floes {{
namespace {name}_test {{

TEST({camel}, IsOfEveryCase) {{
    Evidence evidence = evidence_of({{}}, example::campaign());
    const Section section = {name}_section(evidence);
    const Results& found = section.results.front();
    ASSERT_EQ(found.rows.size(), 3u);
    EXPECT_EQ(found.name(0, "case"), "E30");
    EXPECT_DOUBLE_EQ(found.number(0, "load"), 27);
    EXPECT_THAT(text(std::vector{{section}}, 120), testing::HasSubstr("{title}"));
}}

}}  // namespace {name}_test
}}  // namespace floes
'''
KEY_TEST = '''#include <gtest/gtest.h>

#include "keys/key.hpp"
#include "scenario/keys.hpp"

namespace floes {{
namespace {name}_test {{

TEST({camel}, IsReadAndChangesNoDigestByDefault) {{
    Scenario scenario;
    const Keys keys = describe(scenario);
    const Key* key = find_key(keys, "{path}");
    ASSERT_NE(key, nullptr);
    const std::string before = canonical_text(scenario);
    EXPECT_EQ(before.find("{path}"), std::string::npos);
    std::get<NumberField>(key->field).set(0.5);
    EXPECT_EQ(scenario.{table}.{name}, 0.5);
    EXPECT_NE(canonical_text(scenario), before);
}}

}}  // namespace {name}_test
}}  // namespace floes
'''


def stop(sentence):
    sys.exit(f"tools/add.py: {sentence}")


def camel(name):
    return "".join(word.capitalize() for word in name.split("_"))


def write(path, text):
    path.write_text(text, encoding="utf-8")
    if shutil.which("clang-format"):
        subprocess.run(["clang-format", "-i", path], check=True)
    print(path.relative_to(ROOT))


def write_new(path, text):
    if path.exists():
        stop(f"{path.relative_to(ROOT)} is there already; take another name")
    write(path, text)


def insert(path, before, text, after=""):
    """`text` before the first `before` that follows `after`."""
    old = path.read_text(encoding="utf-8")
    at = old.find(before, old.find(after) + len(after)) if after in old else -1
    if at < 0:
        stop(f"{path.relative_to(ROOT)} has no {(after + ' … ' + before).strip(' …')!r} any more: mend this program")
    write(path, old[:at] + text + old[at:])


def add_finding(name, title):
    if not re.fullmatch(r"[a-z][a-z_]*", name):
        stop(f"{name!r} is no name: take small letters and underscores, as wind_rose")
    folder = ROOT / "ensemble/findings"
    write_new(folder / f"{name}.cpp", FINDING.format(name=name, title=title))
    write_new(ROOT / f"tests/findings/{name}_test.cpp", FINDING_TEST.format(name=name, title=title, camel=camel(name)))
    insert(folder / "sections.hpp", "}  // namespace floes", f"/// {title}.\nSection {name}_section(Evidence& evidence);\n\n")
    insert(folder / "catalogue.cpp", "    {.name = \"members\"",
           f'    {{"{name}", one<{name}_section>, "{title}", always, "{title}"}},\n')
    print("Left: what it computes; what its sheet of a workbook holds, when it is shown unasked (never) and its "
          "place in catalogue.cpp; CHANGELOG.md.")


def add_key(path):
    found = re.fullmatch(r"([a-z]+)\.([a-z][a-z_]*?)(_(?:m|s|N|kN|kPa|MPa|J_m2|m_s|kg_m3|deg|C|percent))?", path)
    if not found:
        stop(f"{path!r} is no key: take a table and a name, as water.albedo or ice.roughness_m")
    table, name = found[1], found[2]
    tables = (ROOT / "src/scenario/tables.hpp").read_text(encoding="utf-8")
    door = re.search(rf"void add_{table}\(Keys& keys, .*?(\w+)& {table}[,)]", tables)
    if not door:
        known = ", ".join(re.findall(r"void add_(\w+)\(Keys& keys, .*?\w+& \1[,)]", tables))
        stop(f"there is no table {table} with a struct of its own; there are {known}")
    for header in sorted(ROOT.glob("src/*/*.hpp")):
        text = header.read_text(encoding="utf-8")
        struct = re.search(rf"^struct {door[1]} \{{\n(?:    [^(/\n]*(?://.*)?\n)+", text, re.M)
        if struct:
            break
    else:
        stop(f"no header of src/ has 'struct {door[1]}'")
    write(header, text[:struct.end()] + f"    double {name} = 0;  ///< what it is, SI\n" + text[struct.end():])
    for source in sorted(ROOT.glob("src/scenario/tables_*.cpp")):
        if (begin := f"void add_{table}(Keys& keys") in source.read_text(encoding="utf-8"):
            insert(source, "\n}\n", f'\n    keys.push_back(late_key(number_key("{path}", {table}.{name}, unit::one, '
                   f'at_least(0).at_most(1), "its source",\n                                       "What it is.")));',
                   begin)
    write_new(ROOT / f"tests/scenario/{name}_test.cpp",
              KEY_TEST.format(table=table, name=name, path=path, camel=camel(name)))
    digests = ROOT / "tests/campaign/digests_test.cpp"
    later = re.search(r"tables_came_later\{([^}]*)\}", digests.read_text(encoding="utf-8"))
    if f'"{table}"' not in later[1]:
        insert(digests, "};", f',\n{" " * 48}"{path}"', "came_later{")
    print("Left: unit, range, source and meaning (tables_*.cpp); what reads it; a contradiction with other keys "
          "(checks_*.cpp); floes config --reference into docs/configuration.md; CHANGELOG.md.")


if __name__ == "__main__":
    if len(sys.argv) == 4 and sys.argv[1] == "finding":
        add_finding(*sys.argv[2:])
    elif len(sys.argv) == 3 and sys.argv[1] == "key":
        add_key(sys.argv[2])
    else:
        sys.exit(__doc__)
