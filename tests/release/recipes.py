"""Recipes and CI files have their form, and every command of floes in them and in the batch scripts exists.

    recipes.py PROJECT_FOLDER PROGRAM
"""

import ast
import pathlib
import re
import shutil
import subprocess
import sys

import yaml

CI_FILES = [".github/workflows/tests.yml", ".gitlab-ci.yml", "packaging/ci/campaign.github.yml",
            "packaging/ci/campaign.gitlab-ci.yml"]
COMMANDS_IN = CI_FILES + ["packaging/conda/recipe/meta.yaml", "README.md", "docs/start.md", "docs/clusters.md",
                          "docs/tutorial.md", "docs/limits.md",
                          "packaging/clusters/pbs/campaign.pbs", "packaging/clusters/lsf/campaign.lsf", "slurm/campaign.sbatch"]
YAMLLINT = ("{extends: default, rules: {line-length: disable, document-start: disable, truthy: {check-keys: false}, "
            "comments: {min-spaces-from-content: 2}}}")


def commands_in(text):
    """(verb, options) of each `floes VERB …` in a text; a comment ends it, and what follows && is another."""
    for line in text.replace("\\\n", " ").splitlines():
        for part in re.split(r"&&|;|`|\|", line):
            found = re.search(r'(?:^|[\s"/}])floes"?\}?"?\s+([a-z]+)\s(.*)', part.split(" # ")[0])
            if found and not part.lstrip().startswith("#"):
                yield found[1], re.findall(r"(?<!\S)(--[a-z-]+|-[a-z])(?=[ =]|$)", found[2])


def code_in(page):
    """What a page shows as code: indented lines, and words between backquotes."""
    return "\n".join(re.findall(r"^    .*$", page, re.M) + re.findall(r"`([^`\n]+)`", page))


def options_of(program, verb):
    """Options of a verb; None if there is no such verb."""
    shown = subprocess.run([program, verb, "--help"], capture_output=True, text=True)
    if not re.search(rf"^Usage: \S+ {verb} ", shown.stdout, re.M):  # --help answers for unknown verbs as well
        return None
    return set(re.findall(r"(?<!\S)(--?[a-z][a-z-]*)", shown.stdout.replace(",", " ")))


def faults(project, program):
    known = {}
    for name in COMMANDS_IN:
        text = (project / name).read_text(encoding="utf-8")
        for verb, options in commands_in(code_in(text) if name.endswith(".md") else text):
            if verb in ("package", "test", "tidy", "clang", "coverage"):
                continue  # of the launcher
            known.setdefault(verb, options_of(program, verb))
            if known[verb] is None:
                yield f"{name} calls floes {verb}, a verb that there is not"
                continue
            for option in set(options) - known[verb]:
                yield f"{name} calls floes {verb} {option}, an option that there is not"
    if len(known) < 3:
        yield f"only these verbs were found in the recipes: {sorted(known)}"

    parsed = {name: yaml.safe_load((project / name).read_text(encoding="utf-8")) for name in CI_FILES}
    for name, content in parsed.items():
        if "github" in name:
            jobs = content["jobs"]
            if True not in content:  # YAML reads the key `on` as a truth
                yield f"{name} does not say when it runs"
            if not all(job.get("runs-on") and job.get("steps") for job in jobs.values()):
                yield f"{name} has a job without runs-on or steps"
        else:
            jobs = {key: job for key, job in content.items() if isinstance(job, dict)}
            if not all(job.get("script") for job in jobs.values()):
                yield f"{name} has a job without a script"
        if not any("campaign.h5" in str(job) or "floes_*.deb" in str(job) for job in jobs.values()):
            yield f"{name} keeps nothing"
    if shutil.which("yamllint"):
        lint = subprocess.run(["yamllint", "-s", "-d", YAMLLINT, *CI_FILES], cwd=project, capture_output=True,
                              text=True)
        if lint.returncode:
            yield lint.stdout.strip()

    for form in sorted((project / ".github/ISSUE_TEMPLATE").glob("*.yml")):
        content = yaml.safe_load(form.read_text(encoding="utf-8"))
        if not {"name", "description", "body"} <= content.keys():
            yield f"{form.name} lacks its name, description or body"
        if not all(field["attributes"].get("label") for field in content.get("body", [])):
            yield f"{form.name} has a field without a label"

    spack = ast.parse((project / "packaging/spack/package.py").read_text(encoding="utf-8"))
    if not any(isinstance(node, ast.ClassDef) and node.name == "Floes" for node in spack.body):
        yield "packaging/spack/package.py has no class Floes"
    calls = [node.func for node in ast.walk(spack) if isinstance(node, ast.Call)]
    called = {function.id for function in calls if isinstance(function, ast.Name)}
    if not {"version", "license", "generator"} <= called:
        yield f"packaging/spack/package.py lacks a directive; it has {sorted(called)}"
    # conda-build fills in the templates first; the selectors behind # are comments of YAML.
    meta = (project / "packaging/conda/recipe/meta.yaml").read_text(encoding="utf-8")
    recipe = yaml.safe_load(re.sub(r"\{\{.*?\}\}", "compiler", meta))
    for part in ("package", "source", "build", "requirements", "test", "about"):
        if part not in recipe:
            yield f"packaging/conda/recipe/meta.yaml has no {part}"
    if not (project / "packaging/conda/recipe" / recipe["source"]["path"] / "CMakeLists.txt").resolve().exists():
        yield "packaging/conda/recipe/meta.yaml does not lead to the sources"


def main():
    found = list(faults(pathlib.Path(sys.argv[1]), sys.argv[2]))
    print("\n".join(found) or "recipes: all in order")
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
