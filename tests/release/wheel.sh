#!/usr/bin/env bash
# The wheel, for a user without root, in a fresh environment of Debian's Python and without a network: program and reader
# are of this version, the program uses no library of this machine and gives the members that it gives here.
#   wheel.sh BUILD_FOLDER PROGRAM
set -euo pipefail
build=$1
program=$2
stage=$(mktemp -d)
trap 'rm -rf -- "$stage"' EXIT
fail() { echo "FAILED: $*" >&2; exit 1; }

(cd "$build" && cpack -G External -B "$stage/packed") >"$stage/log" 2>&1 || fail "cpack: $(<"$stage/log")"
mkdir "$stage/home"
mv "$stage"/packed/floes-*.whl "$stage/home/" || fail "no wheel was made: $(<"$stage/log")"

user=()
if [[ $(id -u) == 0 ]]; then
    chmod 755 "$stage"
    chown -R nobody "$stage/home"
    user=(setpriv --reuid nobody --regid nogroup --clear-groups)
fi
# here COMMAND…: as that user, whose PATH begins with the environment; what it says is in the log.
here() {
    (cd "$stage/home" && "${user[@]}" env -i "PATH=$stage/home/venv/bin:/usr/bin:/bin" "HOME=$stage/home" "$@") \
        >"$stage/log" 2>&1 || fail "$1 ended with $?: $(<"$stage/log")"
}

here /usr/bin/python3 -m venv --system-site-packages venv  # what the reader needs is Debian's
here sh -c 'pip install --no-index --no-deps floes-*.whl'  # as which pip does not know Debian's h5py
here floes --version
[[ $(head -1 "$stage/log") == "$("$program" --version | head -1)" ]] || fail "another version: $(<"$stage/log")"
carried=$stage/home/venv/lib/floes
here "$carried/lib/ld-linux-x86-64.so.2" --library-path "$carried/lib" --list "$carried/lib/floes"
grep -vF -e "$carried/lib/" -e linux-vdso "$stage/log" && fail "libraries of this machine are used"
[[ -e $carried/share/doc/floes/licences/libc6 ]] || fail "the libraries came without their licences"

few=(--set campaign.arrangements=1 --set analysis.steady_start_s=1 --set analysis.window_s=3)
here floes new my.toml
here floes run my.toml "${few[@]}"
"$program" run "$stage/home/my.toml" -o "$stage/my.h5" "${few[@]}" >"$stage/log" 2>&1 || fail "here: $(<"$stage/log")"
h5diff --exclude-path /provenance "$stage/home/my.h5" "$stage/my.h5" || fail "the members differ"
here floes replay my.h5 --worst -o worst.png
here floes config --check smoke  # a configuration that came along
here floes array my.toml --for slurm --parts 2
grep -qF "floes=\${FLOES:-$stage/home/venv/bin/floes}" "$stage/home/my.slurm.sh" || fail "jobs start something else"

cat >"$stage/read.py" <<'PYTHON'
import pathlib, sys
import floes_reader
from floes_reader import program
environment = pathlib.Path(sys.prefix)
assert environment in pathlib.Path(floes_reader.__file__).parents, floes_reader.__file__
assert program.executable() == str(environment / "bin/floes"), program.executable()
campaign = floes_reader.open("my.h5")
assert len(campaign.members) == 2 and campaign.members.mean_load.all(), campaign.members
assert program.ask("summarize", "my.h5"), "no answer"
PYTHON
here env PATH=/usr/bin:/bin "$stage/home/venv/bin/python" -B "$stage/read.py"
here pip uninstall -y floes
left=$(find "$stage/home/venv" -path '*floes*' -not -name '*.pyc' -not -type d)
[[ -z $left ]] || fail "left behind: $left"
echo "installed by pip without root, ran and was read, same members"
