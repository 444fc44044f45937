#!/usr/bin/python3
"""The project keeps the rules of layers.py, and each rule refuses what it is for."""

import pathlib
import unittest

import layers

PROJECT = pathlib.Path(__file__).resolve().parents[2]


class Project(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.sources = layers.read_sources(PROJECT)
        cls.modules = layers.declared((PROJECT / "CMakeLists.txt").read_text(encoding="utf-8"))
        cls.table = layers.rows((PROJECT / "ARCHITECTURE.md").read_text(encoding="utf-8"))

    def none(self, sentences):
        self.assertGreater(len(self.sources), 100)
        self.assertGreater(len(self.modules), 20)
        self.assertEqual(list(sentences), [])

    def test_declares_what_it_includes_and_draws_it(self):
        self.none(layers.broken_declarations(self.modules, self.table, self.sources))

    def test_libraries_come_in_by_their_doors(self):
        self.none(layers.broken_doors(self.table, self.sources))

    def test_headers_make_no_ring(self):
        self.none(layers.rings(self.sources))

    def test_every_class_has_a_name_of_its_own(self):
        self.none(layers.shared_names(self.sources))

    def test_files_and_functions_are_short(self):
        self.none(layers.long_texts(self.sources))

    def test_every_source_begins_with_its_idea(self):
        self.none(layers.wordless(self.sources | layers.read_sources(PROJECT, "inl")))

    def test_comments_and_pages_name_sources_that_are_there(self):
        pages = {path.name: path.read_text(encoding="utf-8")
                 for path in [*PROJECT.glob("*.md"), *PROJECT.glob("docs/*.md")] if path.name != "CHANGELOG.md"}
        self.assertIn("CONTRIBUTING.md", pages)
        self.none(layers.lost_names(self.sources, pages, {path.name for path in PROJECT.glob("tests/*/*.[hc]pp")}))

    def test_tests_share_nothing(self):
        tests = {path.relative_to(PROJECT).as_posix(): path.read_text(encoding="utf-8")
                 for kind in ("[hc]pp", "py", "sh") for path in PROJECT.glob(f"tests/**/*.{kind}")
                 if "layers" not in path.parts}
        self.assertGreater(len(tests), 300)
        self.none(layers.shared_places(tests))


class Rules(unittest.TestCase):
    """Each on sources made for it."""

    CMAKE = "floes_module(src/core)\nfloes_module(src/ice USES core LIBRARIES a INSIDE world\n  PRIVATE b)\n"

    def test_modules_are_read_with_what_they_use(self):
        modules = layers.declared("# floes_module(src/no)\nfloes_module(src/world)\n" + self.CMAKE)
        self.assertEqual(modules["ice"], layers.Module("src/ice", {"core", "world"}))
        self.assertEqual(layers.layers(modules), {"world": 0, "core": 0, "ice": 1})
        with self.assertRaisesRegex(ValueError, "ice uses world, declared below it or nowhere"):
            layers.layers(layers.declared(self.CMAKE))

    def test_declarations(self):
        modules = layers.declared("floes_module(src/core)\nfloes_module(src/ice USES core)\n")
        table = {"core": layers.Row(0, set()), "ice": layers.Row(2, set())}
        sources = {"src/core/id.hpp": "", "src/ice/ice.cpp": '// #include "core/id.hpp"\n', "src/new/a.hpp": ""}
        self.assertEqual(list(layers.broken_declarations(modules, table, sources)), [
            "CMakeLists.txt declares that ice uses core, and no file of ice includes it",
            "src/new/a.hpp lies in no folder that CMakeLists.txt declares as a module",
            "ARCHITECTURE.md has ice in layer 2; by what it uses it is in 1"])
        table["old"] = layers.Row(0, set())
        self.assertIn("old stands in one of CMakeLists.txt and ARCHITECTURE.md alone",
                      layers.broken_declarations(modules, table, {}))

    def test_doors(self):
        table = {"ice": layers.Row(1, {"MPI"}), "run": layers.Row(2, {"HDF5"})}
        text = ("#include <vector>\n#include <fmt/format.h>\n #  include <mpi.h>\n#include <hdf5.h>\n#include <cstdio>\n"
                "#include <curl/curl.h>\n")
        self.assertEqual(list(layers.broken_doors(table, {"src/ice/a.cpp": text, "ensemble/run/a.cpp": "#include <cstdio>"})), [
            "src/ice/a.cpp:4 includes <hdf5.h>; the row of ice in ARCHITECTURE.md does not name HDF5",
            "src/ice/a.cpp:5 includes <cstdio>; src/ opens no file and prints nothing",
            "src/ice/a.cpp:6 includes <curl/curl.h>; no library in tests/layers/layers.py has such a header",
            "ARCHITECTURE.md has HDF5 in the row of run, and no file of run includes it"])
        boost = {"src/ice/a.hpp": "#include <boost/crc.hpp>\n"}
        self.assertIn("include it in a .cpp", "".join(layers.broken_doors({}, boost)))
        for header in ("Random123/philox.h", "xxhash.h", "zlib.h", "Eigen/Dense", "CLI/CLI.hpp", "nlohmann/json.hpp",
                       "tbb/parallel_for.h", "nlopt.h", "unistd.h", "btBulletDynamicsCommon.h", "toml++/toml.h"):
            self.assertIsNotNone(layers.library_of(header), header)
        self.assertIsNone(layers.library_of("math.h"))

    def test_lost_names(self):
        sources = {"src/ice/a.hpp": "// As core/b.hpp has it.\n#include <boost/c.hpp>\n/// (ice/a.hpp)\n", "src/core/c.cpp": ""}
        self.assertEqual(list(layers.lost_names(sources, {"README.md": "`d.cpp`, `src/ice/a.hpp`, `c.cpp`"})), [
            "src/ice/a.hpp names core/b.hpp, which is not there", "README.md names d.cpp, which is not there"])

    def test_shared_places(self):
        helper = "tests/support/temporary_folder.hpp"
        for line in ('testing::TempDir() + "a"', 'fs::temp_directory_path() / "a"', "cp a /tmp/a", 'open("/dev/shm/a")',
                     '"serve", "--port", "4242"', "serve --port 4242", 'one.bind(("127.0.0.1", 4242))',
                     'HttpServer server("localhost", 8080, {})', "tempfile.gettempdir()"):
            self.assertEqual(len(list(layers.shared_places({"tests/a/a.cpp": f"\n{line}\n", helper: line}))), 1, line)
        for line in ("mktemp -d", "tempfile.TemporaryDirectory()", '"--port", "0"', 'bind(("127.0.0.1", 0))',
                     "$stage/root/tmp/", "cluster/tmp/%n"):
            self.assertEqual(list(layers.shared_places({"tests/a/a.sh": line})), [], line)

    def test_rows_of_tables(self):
        self.assertEqual(layers.rows("| layer | module | what | libraries |\n| 2 | `ice` | `x`, y | |\n"
                                     "| 10 | `cli` | verbs | A, B c |\n"),
                         {"ice": layers.Row(2, set()), "cli": layers.Row(10, {"A", "B c"})})

    def test_rings(self):
        ring = {"src/ice/a.hpp": '#include "ice/b.hpp"\n', "src/ice/b.hpp": '#include "core/c.hpp"\n',
                "src/core/c.hpp": '#include "ice/a.hpp"\n', "src/core/d.hpp": '#include "core/c.hpp"\n'}
        self.assertEqual(layers.rings(ring), ["these headers include each other: src/core/c.hpp -> src/ice/a.hpp -> "
                                              "src/ice/b.hpp -> src/core/c.hpp"])
        del ring["src/core/c.hpp"]
        self.assertEqual(layers.rings(ring), [])

    def test_names(self):
        text = '''namespace floes {
class Told;  // struct Said {
template <class Value, int n = (2 > 1)>
class Kept final : public Base<Value> { struct Inner {}; enum class Kind { a }; };
namespace { struct Hidden {}; }
void f() { struct Local {}; const char* text = "class Quoted {"; }
}
'''
        self.assertEqual([name for kind, name, _, _ in layers.scopes(text) if kind == "class"], ["floes::Kept"])
        sources = {"src/ice/part.hpp": "namespace floes {\nstruct Part {};\n}\n",
                   "src/ice/part.cpp": "namespace floes {\nclass Part::State {};\nstruct Piece {};\n}\n",
                   "src/world/parts.hpp": "namespace floes {\nclass Part {};\n}\n"}
        self.assertEqual(layers.shared_names(sources), ["floes::Part is a class of src/ice/part and of src/world/parts"])

    def test_lengths(self):
        body = "    if (x) {\n        y();\n    }\n" * 20
        short = f"namespace floes {{\n\nint f(int x,\n      int y) {{\n{body[:-6]}}}\n}}\n"
        self.assertEqual(list(layers.long_texts({"src/a/a.cpp": short})),
                         ["src/a/a.cpp:3 begins a function of 63 lines, more than 60"])
        self.assertEqual(list(layers.long_texts({"src/a/a.cpp": short.replace("    if (x) {\n        y();\n    }\n", "", 1)})), [])
        self.assertEqual(len(list(layers.long_texts({"src/a/a.cpp": "// x\n" * 801}))), 1)
        table = "const int all[] = {\n" + "    1,\n" * 100 + "};\n"
        self.assertEqual(list(layers.long_texts({"src/a/a.cpp": table})), [])

    def test_openings(self):
        good = {"src/a/a.hpp": "#pragma once\n// Ice.\n\nint a;\n", "src/a/a.cpp": '#include "a/a.hpp"\n',
                "src/a/b.cpp": "// Water.\n// And more.\n\nint b;\n", "src/a/c.inl": "// Lanes.\n#define C\n"}
        self.assertEqual(list(layers.wordless(good)), [])
        for bad in ({"src/a/a.hpp": "#pragma once\n#include <cmath>\n"}, {"src/a/b.cpp": '#include "a/b.hpp"\n'}):
            self.assertRegex(list(layers.wordless(bad))[0], "without a comment")
        self.assertRegex(list(layers.wordless({"src/a/a.hpp": "#pragma once\n// A sum.\nint sum();\n"}))[0], "first part")


if __name__ == "__main__":
    unittest.main()
