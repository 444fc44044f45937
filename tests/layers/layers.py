"""The project's modules as CMakeLists.txt declares them and its sources include them, and the rules that they keep.

The compiler refuses an include that is not declared: a module's include path holds nothing else. What it cannot see stands
here: declared dependencies that nobody needs, rings of files, libraries that come in by many doors, the layers of
ARCHITECTURE.md, two classes of one name, long files and long functions, and tests that could meet.
"""

import collections
import pathlib
import re

MOST_LINES, MOST_LINES_OF_A_FUNCTION = 800, 60
FILES_AND_OUTPUT = {"fstream", "iostream", "cstdio", "print", "syncstream"}
LIBRARIES = {  # name: what stands between the angle brackets
    "Boost": r"boost/.*", "Bullet": r"(bt[A-Z]|Bullet|LinearMath/).*",
    "cairo": r"(cairo/)?cairo.*\.h", "CLI11": r"CLI/.*", "Eigen": r"(unsupported/)?Eigen/.*", "fmt": r"fmt/.*",
    "HDF5": r"hdf5(_hl)?\.h|hdf5/serial/.*|H5.*", "libxlsxwriter": r"xlsxwriter(/.*)?\.h", "NetCDF": r"netcdf.*\.h", "MPI": r"(mpi|openmpi/).*",
    "NLopt": r"nlopt\.h(pp)?", "nlohmann json": r"nlohmann/.*",
    "POSIX": r"(sys/.*|gnu/libc-version|fcntl|poll|sched|signal|spawn|termios|time|unistd)\.h", "Random123": r"Random123/.*",
    "TBB": r"(oneapi/)?tbb/.*", "toml++": r"toml(\+\+|\.hpp).*", "xxHash": r"xxh(ash|3)\.h", "zlib": r"z(lib|conf)\.h"}
EVERYWHERE = {"fmt"}  # no row of ARCHITECTURE.md names it

Module = collections.namedtuple("Module", "folder uses")  # "src/ice", the modules that it may include
Row = collections.namedtuple("Row", "layer libraries")    # of a table in ARCHITECTURE.md


def read_sources(project, kind="[hc]pp"):
    """Path, as "src/ice/failure.cpp", to text."""
    files = sorted(file for top in ("src", "ensemble") for file in (project / top).rglob(f"*.{kind}"))
    return {file.relative_to(project).as_posix(): file.read_text(encoding="utf-8") for file in files}


def declared(cmake):
    """Name to Module, in the order of the floes_module() lines."""
    modules = {}
    for folder, arguments in re.findall(r"^floes_module\(([\w/]+)([^)]*)\)", cmake, re.M):
        words, kind, uses = arguments.split(), "", set()
        for word in words:
            if word in ("USES", "INSIDE", "LIBRARIES", "PRIVATE"):
                kind = word
            elif kind in ("USES", "INSIDE"):
                uses.add(word)
        modules[folder.rpartition("/")[2]] = Module(folder, uses)
    return modules


def layers(modules):
    """Name to layer: 0 uses no module, every other stands one above the highest that it uses."""
    found = {}
    for name, module in modules.items():  # a module is declared after those it uses, or CMake's list is no order
        unknown = module.uses - found.keys()
        if unknown:
            raise ValueError(f"{name} uses {', '.join(sorted(unknown))}, declared below it or nowhere")
        found[name] = 1 + max((found[other] for other in module.uses), default=-1)
    return found


def rows(architecture):
    """Name to Row of the tables in ARCHITECTURE.md."""
    return {name: Row(int(layer), {library for library in libraries.split(", ") if library})
            for layer, name, libraries in
            re.findall(r"^\| (\d+) \| `(\w+)` \|[^|]*\|\s*([^|]*?)\s*\|$", architecture, re.M)}


def includes(text):
    """(line number, header, whether in angle brackets) of each #include; those in comments are none."""
    return [(number, match[2], match[1] == "<") for number, line in enumerate(text.split("\n"), 1)
            if (match := re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line))]


def module_of(path):
    return path.split("/")[-2] if "/" in path else ""


def library_of(header):
    return next((name for name, form in LIBRARIES.items() if re.fullmatch(form, header)), None)


def broken_declarations(modules, table, sources):
    """Dependencies that are declared in vain, modules and layers that CMakeLists.txt and ARCHITECTURE.md tell otherwise."""
    used = collections.defaultdict(set)
    for path, text in sources.items():
        used[module_of(path)] |= {module_of(header) for _, header, foreign in includes(text) if not foreign}
    for name, module in modules.items():
        for other in sorted(module.uses - used[name]):
            yield f"CMakeLists.txt declares that {name} uses {other}, and no file of {name} includes it"
    for path in sources:
        if path.rpartition("/")[0] not in {module.folder for module in modules.values()}:
            yield f"{path} lies in no folder that CMakeLists.txt declares as a module"
    levels = layers(modules)
    for name in sorted(levels.keys() ^ table.keys()):
        yield f"{name} stands in one of CMakeLists.txt and ARCHITECTURE.md alone"
    for name in levels.keys() & table.keys():
        if levels[name] != table[name].layer:
            yield f"ARCHITECTURE.md has {name} in layer {table[name].layer}; by what it uses it is in {levels[name]}"


def broken_doors(table, sources):
    """Headers of libraries outside the modules that ARCHITECTURE.md names for them, and names that nobody needs."""
    used = collections.defaultdict(set)
    for path, text in sources.items():
        for line, header, foreign in includes(text):
            if not foreign:
                continue
            where, name = f"{path}:{line} includes <{header}>", module_of(path)
            if path.startswith("src/") and header in FILES_AND_OUTPUT:
                yield f"{where}; src/ opens no file and prints nothing"
            if not re.search(r"[./]", header):
                continue  # the standard library
            library = library_of(header)
            if library is None:
                yield f"{where}; no library in tests/layers/layers.py has such a header"
                continue
            if path.endswith(".hpp") and library == "Boost":
                yield f"{where}; it took half of the build when it was in a header: include it in a .cpp"
            used[name].add(library)
            if library not in EVERYWHERE and name in table and library not in table[name].libraries:
                yield f"{where}; the row of {name} in ARCHITECTURE.md does not name {library}"
    for name, row in table.items():
        for library in sorted(row.libraries - used[name]):
            yield f"ARCHITECTURE.md has {library} in the row of {name}, and no file of {name} includes it"


def rings(sources):
    """Headers that include each other."""
    edges = {path: {f"{folder}/{header}" for _, header, foreign in includes(text) if not foreign
                    for folder in ("src", "ensemble")} & sources.keys()
             for path, text in sources.items() if path.endswith(".hpp")}
    state, found = {}, []

    def visit(at, way):
        state[at] = "open"
        for other in sorted(edges[at]):
            if state.get(other) == "open":
                found.append(f"these headers include each other: {' -> '.join(way[way.index(other):] + [other])}")
            elif other not in state:
                visit(other, way + [other])
        state[at] = "done"
    for start in sorted(edges):
        if start not in state:
            visit(start, [start])
    return found


def bare(text):
    """The text without comments, strings and preprocessor lines, line by line as it was."""
    def blank(match):
        return "\n" * match[0].count("\n") if match[0].startswith(("/", "#", 'R"')) else "0"
    noise = r'R"(\w*)\([^\0]*?\)\1"|//[^\n]*|/\*[^\0]*?\*/|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\'|^#(?:[^\n]*\\\n)*[^\n]*'
    return re.sub(noise, blank, text, flags=re.M)


def scopes(text):
    """(kind, name, first line, last line) of each class and function: kind is "class" or "function", the name with its
    namespaces; what stands in a function or in a namespace without a name is not told, but the function itself is."""
    code = re.sub(r"\btemplate\s*<(?:[^<>]|<[^<>]*>)*>", lambda m: "\n" * m[0].count("\n"), bare(text))
    token = (r"\bnamespace\s*([\w:]*)\s*\{|\b(?:enum\s+class|enum|class|struct|union)\s+(?:\[\[[^\]]*\]\]\s*)?([\w:]+)"
             r"(?:\s+final)?\s*(?::(?!:)[^;{}()]*)?\{|\{|\}")
    told, stack = [], []
    for match in re.finditer(token, code):
        line = code.count("\n", 0, match.start()) + 1
        if match[0] == "}":
            if not stack:
                continue
            kind, name, first = stack.pop()
            if kind in ("class", "function"):
                told.append((kind, "::".join([n for _, n, _ in stack] + [name]), first, line))
        elif match[0].startswith("namespace"):
            stack.append(("namespace" if match[1] else "hidden", match[1], line))
        elif match[2] and not any(kind in ("function", "block") for kind, _, _ in stack):
            visible = all(kind == "namespace" for kind, _, _ in stack)
            stack.append(("class" if visible else "inner", match[2], line))
        elif any(kind in ("function", "block") for kind, _, _ in stack):
            stack.append(("block", "", line))
        else:
            before = re.split(r"[;{}]", code[:match.start()])[-1]
            is_function = "(" in before and not re.search(r"=\s*$", before)
            start = match.start() - len(before.lstrip()) if is_function else match.start()
            stack.append(("function" if is_function else "block", "", code.count("\n", 0, start) + 1))
    return told


def shared_names(sources):
    units = collections.defaultdict(set)
    for path, text in sources.items():
        for kind, name, _, _ in scopes(text):
            if kind == "class" and "::" not in name.removeprefix("floes::").replace("hdf5::", ""):
                units[name].add(path.rpartition(".")[0])
    return [f"{name} is a class of {' and of '.join(sorted(where))}" for name, where in sorted(units.items())
            if len(where) > 1]


def long_texts(sources):
    for path, text in sources.items():
        if text.count("\n") > MOST_LINES:
            yield f"{path} has {text.count(chr(10))} lines, more than {MOST_LINES}: split it"
        for kind, _, first, last in scopes(text):
            if kind == "function" and last - first + 1 > MOST_LINES_OF_A_FUNCTION:
                yield f"{path}:{first} begins a function of {last - first + 1} lines, more than {MOST_LINES_OF_A_FUNCTION}"


def wordless(sources):
    """Sources that do not begin with their idea: a comment that stands by itself, of a .cpp also the header of its name."""
    for path, text in sources.items():
        own = path.replace(".cpp", ".hpp")
        if path.endswith(".cpp") and own in sources and text.startswith(f'#include "{own.split("/", 1)[1]}"\n'):
            continue
        opening = text.removeprefix("#pragma once\n")
        if not opening.startswith("// "):
            yield f"{path} begins without a comment on what it holds"
        elif not re.match(r"(//[^\n]*\n)+(\n|#)", opening):
            yield f"{path} begins with the comment of its first part: say what all of it is, and leave a line free"


SHARED = {  # what two tests at the same time would meet in
    r"TempDir\(|temp_directory_path\(|gettempdir\(|tmpnam|(?<![\w}/$])(/var/tmp|/tmp|/dev/shm)\b": "a folder of all",
    r"--port[\s=\"',]+[1-9]|bind\(\([^)]*,\s*[1-9]\d|HttpServer(\s+\w+)?\(\"[^\"]*\", *[1-9]": "a fixed port"}


def shared_places(tests):
    """Where a test's source names a folder or a port that other tests may use. The one helper makes folders of their own."""
    for path, text in tests.items():
        for number, line in enumerate(text.split("\n"), 1):
            for pattern, what in SHARED.items():
                if re.search(pattern, line) and path != "tests/support/temporary_folder.hpp":
                    yield f"{path}:{number} names {what}; take a TemporaryFolder, mktemp -d, tempfile or port 0"


def lost_names(sources, pages, tests=()):
    """Of sources that comments or pages name and that are not there. "module/file.hpp", or in pages the file alone."""
    there = set(sources) | {path.split("/", 1)[1] for path in sources}
    for path, text in sources.items():
        for name in re.findall(r"""(?<![\w"/<])([a-z]\w*/\w+\.[hc]pp)\b""", text):
            if name not in there:
                yield f"{path} names {name}, which is not there"
    there |= {path.rpartition("/")[2] for path in sources} | set(tests)
    for path, text in pages.items():
        for name in re.findall(r"`((?:(?:src|ensemble)/\w+/)?\w+\.[hc]pp)`", text):
            if name not in there:
                yield f"{path} names {name}, which is not there"
