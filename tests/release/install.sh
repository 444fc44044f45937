#!/usr/bin/env bash
# `cmake --install`: everything under the prefix, also with DESTDIR, and a tree that works after it was moved.
#   install.sh BUILD_FOLDER PROJECT_FOLDER
set -euo pipefail
build=$1
project=$2
stage=$(mktemp -d)
trap 'rm -rf -- "$stage"' EXIT
fail() { echo "FAILED: $*" >&2; exit 1; }
unset FLOES_HOME FLOES

# Nothing outside the prefix, nor outside DESTDIR.
DESTDIR=$stage/destdir cmake --install "$build" --prefix /opt/floes >"$stage/log" ||
    fail "cmake --install: $(<"$stage/log")"
[[ $(cd "$stage/destdir" && find . -mindepth 2 -maxdepth 2) == ./opt/floes ]] || fail "files outside the prefix"
mkdir "$stage/a folder"
mv "$stage/destdir/opt/floes" "$stage/a folder/moved"
root="$stage/a folder/moved"

# What belongs there is there, and nothing else: no sources, tests or libraries.
for path in bin/floes share/floes/configs/smoke.toml share/floes/configs/validation share/floes/slurm/job.sh \
    share/floes/pbs/campaign.pbs share/floes/lsf/campaign.lsf share/man/man1/floes.1.gz share/man/man1/floes-run.1.gz \
    share/bash-completion/completions/floes share/zsh/site-functions/_floes share/fish/vendor_completions.d/floes.fish \
    share/floes/python/first_look.ipynb share/floes/python/pyproject.toml \
    share/doc/floes/LICENSE share/doc/floes/docs/THIRD_PARTY.md share/doc/floes/docs/start.md; do
    [[ -e $root/$path ]] || fail "$path is not installed"
done
cd "$root"
allowed='^\./(bin/floes$|lib.*/floes-fmu/.*/floes_fmu\.so$|share/(floes|man/man1|doc/floes|bash-completion|zsh|fish)/)'
others=$(find . -type f | grep -vE "$allowed") || true
[[ -z $others ]] || fail "installed as well: $others"

# The pages lead where they say, as in the clone.
/usr/bin/python3 -B - "$project/tests/docs" share/doc/floes <<'PYTHON' || fail "links of installed pages lead nowhere"
import pathlib, sys
sys.path.insert(0, sys.argv[1])
import pages_test
root = pathlib.Path(sys.argv[2]).resolve()
faults = [fault for page in sorted(root.rglob("*.md")) for fault in pages_test.broken_links(page, root)]
sys.exit("\n".join(faults) or 0)
PYTHON

# The moved tree works without the clone: no word of where it was built, no path of libraries in the program.
readelf -d "$root/bin/floes" | grep -E 'R(UN)?PATH' && fail "the program looks for libraries in a folder of the build"
grep -rlF "$project" "$root" --include=* | grep -v '/bin/floes$' && fail "installed files name the build's folder"
cd "$stage"
export PATH="$root/bin:$PATH"
floes config --check smoke | grep -q '^ok: ' || fail "the installed configuration smoke is not found"
[[ ! -e smoke ]] || fail "something was written"
status=0
floes config --check nowhere >log 2>&1 || status=$?
[[ $status == 2 && $(<log) == *nowhere* ]] || fail "an unknown name ends with $status: $(<log)"

# The Python reader is there.
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$root/share/floes/python /usr/bin/python3 -c \
    'import floes_reader, floes_reader.plots; assert floes_reader.__file__.startswith("'"$root"'")' ||
    fail "the Python reader is not installed"

# The program finds the library of FMUs where it is installed.
if [[ $(uname -m) == x86_64 ]]; then
    "$root/bin/floes" export smoke --case E60 --fmu "$stage/ice.fmu" >"$stage/log" 2>&1 || fail "export --fmu: $(<"$stage/log")"
fi

# The scripts of Slurm find the installed program.
mkdir job
cat >"$stage/mpirun" <<'STUB'
#!/bin/sh
echo "mpirun $*"
STUB
chmod +x "$stage/mpirun"
said=$(cd job && PATH=$stage:$PATH SLURM_JOB_ID=7 SLURM_JOB_NODELIST=here SLURM_SUBMIT_DIR=$PWD \
    bash "$root/share/floes/slurm/smoke.sbatch" 2>/dev/null)
[[ $said == *"$root/bin/floes run --isolation process"*"/share/floes/configs/smoke.toml -o floes-smoke-7.h5"* ]] ||
    fail "smoke.sbatch does $said"
[[ $(PATH=$stage:$PATH FLOES_ARGUMENTS="my.toml -o my.h5" bash "$root/share/floes/lsf/campaign.lsf") == \
    "mpirun --bind-to none --map-by ppr:1:node floes run --isolation process my.toml -o my.h5 --resume" ]] ||
    fail "campaign.lsf does something else"
printf 'n1\nn1\nn2\n' >nodes
[[ $(PATH=$stage:$PATH FLOES_ARGUMENTS="my.toml" FLOES_SECONDS=60 PBS_NODEFILE=$PWD/nodes PBS_O_WORKDIR=$PWD \
    bash "$root/share/floes/pbs/campaign.pbs") == \
    "mpirun --bind-to none -n 2 --map-by ppr:1:node floes run --isolation process my.toml --time-left 60 --resume" ]] ||
    fail "campaign.pbs does something else"
echo "installed, moved and used"
