"""Manual pages and completions say what --help says, in the form that their readers want.

    pages.py PROGRAM FOLDER_OF_PAGES [--synthetic=PROGRAM] [--shells]

--synthetic: what makes a campaign file, for the names of its cases; --shells: zsh and fish as well, and lint by mandoc.
"""

import gzip
import json
import pathlib
import re
import subprocess
import sys
import tempfile

PROGRAM, FOLDER, SHELLS = sys.argv[1], pathlib.Path(sys.argv[2]), "--shells" in sys.argv
MAKE_FILE = next((word.removeprefix("--synthetic=") for word in sys.argv if word.startswith("--synthetic=")), None)
FAULTS = []


def check(holds, sentence):
    if not holds:
        FAULTS.append(sentence)


def output(*command, **more):
    done = subprocess.run(command, capture_output=True, text=True, **more)
    return done.stdout + done.stderr


def help_of(*verb):
    return output(PROGRAM, *verb, "--help")


def verbs():
    return listed_by()


def listed_by(*verb):
    listed = re.search(r"^Subcommands:\n(.*?)(\n\n|\Z)", help_of(*verb), re.M | re.S)
    return re.findall(r"^  ([a-z]+)\s", listed[1], re.M) if listed else []


def all_verbs():
    """Each verb as its words, those of other verbs included: ("laboratory", "plate")."""
    for verb in verbs():
        yield (verb,)
        for inner in listed_by(verb):
            yield verb, inner


def options_of(verb):
    return set(re.findall(r"^\s+(?:-\w,)?(--[a-z][\w-]*)", help_of(*verb), re.M))


def words(text):
    """Words of a text without signs, so that line breaks and hyphenation do not count."""
    return re.sub(r"\W+", " ", text)


def complete_in_bash(*line):
    """What bash offers for the last word of a command line."""
    script = f"""source {FOLDER}/floes.bash
        COMP_WORDS=({' '.join(repr(word) for word in line)}) COMP_CWORD={len(line) - 1}
        _floes; printf '%s\\n' "${{COMPREPLY[@]}}" """
    return subprocess.run(["bash", "-uc", script], capture_output=True, text=True, check=True).stdout.split()


def check_manual():
    for verb in [(), *all_verbs()]:
        name = "-".join(["floes", *verb]) + ".1.gz"
        page = FOLDER / name
        check(page.exists(), f"there is no {name}")
        if not page.exists():
            continue
        shown = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", str(page)], capture_output=True, text=True,
                               env={"MANWIDTH": "500", "PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8"})
        check(not shown.stderr, f"man warns of {name}: {shown.stderr}")
        on_page = words(shown.stdout)
        for paragraph in re.split(r"\n\s*|\s{2,}", help_of(*verb).split("Options:")[1]):
            text = words(paragraph).strip()
            if len(text) > 20 and not paragraph.startswith("[Exactly"):  # CLI11's own words for a group
                check(text in on_page, f"{name} lacks what --help says: {paragraph}")
        if SHELLS:
            source = gzip.decompress(page.read_bytes()).decode()
            lint = output("mandoc", "-T", "lint", "-W", "warning", input=source)
            check(not lint.strip(), f"mandoc warns of {name}: {lint}")


def check_bash():
    check(set(complete_in_bash("floes", "")) == set(verbs()), "bash does not offer the verbs")
    check(complete_in_bash("floes", "summ") == ["summarize"], "bash does not complete summ")
    check(complete_in_bash("floes", "laboratory", "c") == ["cantilever"], "bash does not complete laboratory c")
    for verb in all_verbs():
        missing = options_of(verb) - set(complete_in_bash("floes", *verb, "--"))
        check(not missing, f"bash does not offer {missing} of {verb}")
    check(complete_in_bash("floes", "run", "--isolation", "") == ["none", "process"],
          "bash does not know the isolations")
    check(complete_in_bash("floes", "config", str(FOLDER / "_fl")) == [str(FOLDER / "_floes")], "bash completes no files")
    check(complete_in_bash("floes", "run", "--set", "field.conc") == ["field.concentration_percent="],
          "bash does not know the keys")
    with tempfile.TemporaryDirectory() as folder:
        for name in ("a.toml", "a.h5", "a.journal", "a.txt"):
            pathlib.Path(folder, name).touch()
        pathlib.Path(folder, "inner").mkdir()
        start = folder + "/"
        for words_before, expected in {("run",): ["a.toml", "inner"], ("summarize",): ["a.h5", "inner"],
                                       ("config", "--check"): ["a.toml", "inner"],
                                       ("verify",): ["a.h5", "a.journal", "inner"]}.items():
            offered = sorted(complete_in_bash("floes", *words_before, start))
            check(offered == [start + name for name in expected], f"bash offers {offered} after {words_before}")


def check_cases():
    """Names of cases, which come from the campaign file on the line."""
    with tempfile.TemporaryDirectory() as folder:
        file = folder + "/small.h5"
        subprocess.run([MAKE_FILE, file], check=True)
        status = json.loads(output(PROGRAM, "status", file, "--format", "json"))
        names = [case["name"] for case in status["cases"]]
        offered = complete_in_bash(PROGRAM, "replay", file, "--case", "")
        check(len(names) > 1 and offered == names, f"bash offers {offered}, and the cases are {names}")
        check(complete_in_bash(PROGRAM, "replay", file, "--case", names[1][:2]) == [names[1]], "or not by their start")


def check_zsh():
    check(not output("zsh", "-n", str(FOLDER / "_floes")), "zsh cannot read its completion")
    for typed, completed in {r"floes run --res\t--iso\tp\t": "--resume --isolation process",
                             r"floes lab\tpl\t--she\t": "laboratory plate --sheet-m"}.items():
        # A shell in a terminal of its own, asked by the key for a list.
        script = f"""zmodload zsh/zpty; zpty floes zsh -f -i
            zpty -w floes 'fpath=({FOLDER} $fpath); autoload -U compinit; compinit -u -D; PS1=; TERM=dumb'
            zpty -w floes 'unsetopt zle_bracketed_paste; LISTMAX=0; bindkey "^I" complete-word; echo rea"dy"'
            zpty -m floes x '*ready*'
            zpty -n -w floes $'{typed}'; sleep 2; zpty -n -w floes $'\\C-a#\\n'
            zpty -w floes 'echo fin"ished"'
            zpty -r -m floes all '*finished*'; print -r -- $all"""
        shown = re.sub(r"\x1b\[[0-9;?]*[A-Za-z]|\x08|\r", "", output("zsh", "-fc", script, timeout=60))
        check(completed in re.sub(r"\s+", " ", shown), f"zsh completes otherwise: {shown}")


def check_fish():
    def offered(line):
        found = output("fish", "--no-config", "-c", f"source {FOLDER}/floes.fish; complete -C '{line}'")
        return {each.split("\t")[0] for each in found.splitlines()}

    check(set(verbs()) <= offered("floes "), "fish does not offer the verbs")
    for verb in all_verbs():
        missing = options_of(verb) - offered(f"floes {' '.join(verb)} --") - {"--help"}
        check(not missing, f"fish does not offer {missing} of {verb}")
    check({"none", "process"} <= offered("floes run --isolation "), "fish does not know the isolations")
    check(offered("floes run --set field.conc") == {"field.concentration_percent="}, "fish does not know the keys")


check(len(verbs()) > 10, f"--help lists only {verbs()}")
check_manual()
check_bash()
if MAKE_FILE:
    check_cases()
if SHELLS:
    check_zsh()
    check_fish()
print("\n".join(FAULTS) or "pages and completions agree with --help")
sys.exit(bool(FAULTS))
