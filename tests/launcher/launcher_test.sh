#!/usr/bin/env bash
# The launcher, on a machine of stubs: what it installs, when it builds, what it starts. Needs no root, network or MPI.
#   launcher_test.sh PROJECT_FOLDER
set -uo pipefail

project=$1
unset OMPI_COMM_WORLD_RANK PMIX_RANK PMI_RANK
stage=$(mktemp -d)
trap 'rm -rf -- "$stage"' EXIT
home="$stage/a folder with spaces"
bin=$stage/bin
export STAGE=$stage
failures=0

check() {  # check WHAT EXPECTED FOUND
    [[ $2 == "$3" ]] && return
    printf 'FAILED %s\n  expected: %s\n  found:    %s\n' "$1" "$2" "$3"
    failures=$((failures + 1))
}
check_has() {  # check_has WHAT PART TEXT
    [[ $3 == *"$2"* ]] && return
    printf 'FAILED %s\n  expected in it: %s\n  found:          %s\n' "$1" "$2" "$3"
    failures=$((failures + 1))
}
stub() { cat >"$bin/$1" && chmod +x "$bin/$1"; }

# A fresh machine: cmake makes a program that prints its arguments; every call is noted in $STAGE/calls.
machine() {
    rm -rf -- "$home" "$bin" "$stage/calls"
    mkdir -p "$home" "$bin"
    cp "$project/floes" "$home/floes"
    mkdir -p "$home/packaging/debian" "$home/src" "$home/ensemble/cli"
    cp "$project/ensemble/cli/verbs.cpp" "$home/ensemble/cli/"
    printf '# why\nalpha   # because\n\nbeta\n' >"$home/packaging/debian/packages.txt"
    printf 'gamma\n' >"$home/packaging/debian/packages-test.txt"
    printf 'eta\n' >"$home/packaging/debian/packages-test-all.txt"
    printf 'epsilon\n' >"$home/packaging/debian/packages-slow.txt"
    printf 'zeta\n' >"$home/packaging/debian/packages-release.txt"
    printf 'theta\n' >"$home/packaging/debian/packages-docs.txt"
    printf 'iota\n' >"$home/packaging/debian/packages-tidy.txt"
    printf 'kappa\n' >"$home/packaging/debian/packages-fuzz.txt"
    mkdir -p "$home/docs/site"
    cat >"$home/docs/site/build.py" <<'SITE'
#!/bin/sh
echo "site${1:+ $*}" >>"$STAGE/calls"
echo "site/index.html"
SITE
    chmod +x "$home/docs/site/build.py"
    printf 'alpha\nbeta\ngamma\n' >"$stage/installed"
    touch "$stage/a b.toml" "$stage/c.toml" "$stage/c d.toml"
    echo 1000 >"$stage/uid"
    : >"$stage/calls"
    stub id <<'STUB'
#!/bin/sh
cat "$STAGE/uid"
STUB
    stub dpkg-query <<'STUB'
#!/bin/bash
shift 3
for package; do grep -qx "$package" "$STAGE/installed" && echo "installed $package" || status=1; done
exit ${status-0}
STUB
    stub apt-get <<'STUB'
#!/bin/sh
echo "apt-get $*" >>"$STAGE/calls"
echo "apt-get chatters"
STUB
    stub cmake <<'STUB'
#!/bin/bash
echo "cmake $*" >>"$STAGE/calls"
if [[ $1 == --preset ]]; then
    mkdir -p "build/$2"
    touch "build/$2/build.ninja"
    echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >>"build/$2/CMakeCache.txt"
    [[ -z ${3-} ]] || sed 's/-D\(.*\)=/\1:BOOL=/' <<<"$3" >>"build/$2/CMakeCache.txt"
    echo configured
else
    [[ -e $STAGE/in_build ]] && echo overlap >>"$STAGE/calls"
    touch "$STAGE/in_build"
    [[ -e $STAGE/slow_build ]] && sleep 0.5
    while [[ -e $STAGE/endless_build ]]; do sleep 0.05; done
    rm "$STAGE/in_build"
    if [[ $* == *"--target package" ]]; then touch "$2/floes_1.1.0_amd64.deb" "$2/floes-1.1.0-Linux.tar.gz" "$2/floes-1.1.0-py3.whl"; exit; fi
    if [[ -e $STAGE/broken_build ]]; then echo "no such header"; exit 1; fi
    cat >"$2/floes" <<'PROGRAM'
#!/bin/bash
printf "program"; printf " <%s>" "$@"; echo
echo "launcher $FLOES_LAUNCHER" >"$STAGE/launcher"
exit ${PROGRAM_STATUS-0}
PROGRAM
    chmod +x "$2/floes"
fi
STUB
    stub ctest <<'STUB'
#!/bin/sh
echo "ctest in $PWD: $*"
STUB
}
# launch ARGUMENT…: sets out, err, status.
launch() {
    out=$(cd "$stage" && PATH=$bin:$PATH "$home/floes" "$@" 2>"$stage/err")
    status=$?
    err=$(<"$stage/err")
}
calls() { cat "$stage/calls"; }

# -- builds once, hands the arguments over unchanged, and the program's status back
machine
PROGRAM_STATUS=85 launch run "a b.toml" '' --set 'x=*'
check "the program knows its launcher" "launcher $home/floes" "$(cat "$stage/launcher")"
check "arguments" "program <run> <a b.toml> <> <--set> <x=*>" "$out"
check "status of the program" 85 "$status"
check "first build" "cmake --preset release
cmake --build $home/build/release --target floes" "$(calls)"
: >"$stage/calls"
launch status c.h5
check "nothing is built where nothing changed" "" "$(calls)"
check "silent when there is nothing to do" "" "$err"
sleep 0.01
touch "$home/src/changed.cpp"
launch status c.h5
check "built again after a change" "cmake --build $home/build/release --target floes" "$(calls)"

# -- through a symbolic link, from elsewhere
ln -s "$home/floes" "$bin/linked"
: >"$stage/calls"
out=$(cd / && PATH=$bin:$PATH linked config --defaults 2>/dev/null)
check "symbolic link" "program <config> <--defaults>" "$out"
check "symbolic link: the project it leads to" "" "$(calls)"

# -- a copied clone runs the program that came with it; what it builds itself leaves the copied build as it is
: >"$stage/calls"
copy="$stage/a copy"
copied() { out=$(cd "$stage" && PATH=$bin:$PATH "$copy/floes" "$@" 2>"$stage/err"); status=$?; err=$(<"$stage/err"); }
cp -a "$home" "$copy"
copied status c.h5
check "a copied clone: its program" "program <status> <c.h5>" "$out"
check "a copied clone: nothing is built or said" "" "$(calls)$err"
echo precious >"$copy/build/release/precious"
sleep 0.01
touch "$copy/src/changed.cpp"
copied status c.h5
check "a changed copy is configured afresh" "cmake --preset release
cmake --build $copy/build/release --target floes" "$(calls)"
check "a changed copy: its program" "program <status> <c.h5>" "$out"
check "a changed copy: the build that came with it" precious "$(cat "$copy/build/release.copied/precious")"
check_has "a changed copy: what is said" \
    "the build in $copy/build/release was made in $home; it is kept as $copy/build/release.copied" "$err"
: >"$stage/calls"
copied status c.h5
check "a changed copy is built once" "" "$(calls)"
rm -rf -- "$copy/build"
cp -a "$home/build" "$copy/build"
sed -i 's/ [0-9.]* / 1.5 /' "$copy/build/release/current"  # as a copy that did not keep the times
copied status c.h5
check_has "a copy without times is built" "cmake --preset release" "$(calls)"
rm -rf -- "$copy"

# -- a project that moved takes its program along
: >"$stage/calls"
mv "$home" "$home moved" && mkdir "$home" && mv "$home moved" "$home/inside"
out=$(PATH=$bin:$PATH "$home/inside/floes" config 2>/dev/null)
check "moved project" "program <config>" "$out"
check "moved project: nothing is built" "" "$(calls)"

# -- whoever calls it from a program may forbid builds
machine
FLOES_BUILD=never launch status c.h5
check "no build allowed, none there: status" 2 "$status"
check_has "no build allowed, none there: why" "is not built yet, and FLOES_BUILD=never allows no build here" "$err"
check_has "no build allowed, none there: what to do" "build it in a terminal, which takes some minutes at first: $home/floes version" "$err"
check "no build allowed: nothing was tried" "" "$(calls)"
launch status c.h5
FLOES_BUILD=never launch status c.h5
check "no build allowed, an up-to-date program" "program <status> <c.h5>" "$out"
sleep 0.01
touch "$home/src/changed.cpp"
: >"$stage/calls"
FLOES_BUILD=never launch status c.h5
check "no build allowed, an old program: status" 2 "$status"
check_has "no build allowed, an old program: why" "is older than its sources" "$err"
check "no build allowed, an old program: nothing was tried" "" "$(calls)$out"

# -- packages are missing, no root
machine
echo alpha >"$stage/installed"
launch run c.toml
check "no root: status" 2 "$status"
check_has "no root: the missing package is named" "missing: beta" "$err"
check_has "no root: the command is named" \
    "sudo apt-get update && sudo apt-get install -y --no-install-recommends beta" "$err"
check "no root: nothing was tried" "" "$(calls)"
launch test
check_has "tests need their packages too" "missing: beta gamma" "$err"

# -- benchmarks: their own packages and target, then all of them
machine
printf 'delta\n' >"$home/packaging/debian/packages-bench.txt"
launch bench
check_has "benchmarks need their packages" "missing: delta" "$err"
echo delta >>"$stage/installed"
mkdir "$home/bench"
printf '#!/bin/bash\nprintf "all"; printf " <%%s>" "$@"; echo\n' >"$home/bench/all.py"
chmod +x "$home/bench/all.py"
launch bench --rounds 3
check "benchmarks" "all <$home/build/release/bench> <--rounds> <3>" "$out"
check "benchmarks: their build" "cmake --preset release -DFLOES_BENCH=ON
cmake --build $home/build/release --target benchmarks" "$(calls)"

# -- packages are missing, root
machine
echo beta >"$stage/installed"
echo 0 >"$stage/uid"
launch run c.toml
check_has "root installs" "apt-get -q update
apt-get -q install -y --no-install-recommends alpha
cmake --preset release" "$(calls)"
check "standard output is the program's alone" "program <run> <c.toml>" "$out"
machine
rm "$bin/apt-get"
stub apt-get <<'STUB'
#!/bin/sh
exit 100
STUB
echo 0 >"$stage/uid"
: >"$stage/installed"
launch run c.toml
check "apt-get failed" 2 "$status"
check_has "apt-get failed, in words" "could not install" "$err"

# -- the build fails
machine
touch "$stage/broken_build"
launch run c.toml
rm "$stage/broken_build"
check "broken build: status" 1 "$status"
check_has "broken build: the compiler's words" "no such header" "$err"
launch run c.toml
check "after a broken build: built again" "program <run> <c.toml>" "$out"
touch "$stage/broken_build"
sleep 0.01
touch "$home/src/changed.cpp"
launch run c.toml
rm "$stage/broken_build"
check "broken build: nothing on standard output" "" "$out"

# -- two launchers at once
machine
touch "$stage/slow_build"
for _ in 1 2 3; do (PATH=$bin:$PATH "$home/floes" status x >"$stage/out.$_" 2>&1) & done
wait
rm "$stage/slow_build"
check "one build at a time" "" "$(calls | grep overlap)"
check "one configuration" 1 "$(calls | grep -c -- --preset)"

# -- while one builds, another runs what is up to date, and says what it waits for where it must wait
machine
launch status c.h5
touch "$stage/endless_build"
(PATH=$bin:$PATH "$home/floes" test >"$stage/out.tests" 2>&1) &
until [[ $(calls) == *"--target tests"* ]]; do sleep 0.05; done
launch status c.h5
check "an up-to-date verb beside a build" "program <status> <c.h5>" "$out"
sleep 0.01
touch "$home/src/changed.cpp"
(PATH=$bin:$PATH "$home/floes" status x >"$stage/out.waits" 2>"$stage/err.waits") &
until [[ -s $stage/err.waits ]]; do sleep 0.05; done
check_has "a verb that must wait says for what" "waiting for another launcher, which builds tests (preset release)" \
    "$(cat "$stage/err.waits")"
rm "$stage/endless_build"
wait
check "and then it runs" "program <status> <x>" "$(cat "$stage/out.waits")"

# -- the program itself starts ranks
machine
launch run --ranks 3 "c d.toml"
check "--ranks is the program's" "program <run> <--ranks> <3> <c d.toml>" "$out"

# -- packages: those just made, whatever an earlier version left
machine
launch package
check_has "packages need their packages, and those of the site" "missing: theta zeta" "$err"
printf 'theta\nzeta\n' >>"$stage/installed"
launch status c.h5  # builds
touch "$home/build/release/floes_1.0.0_amd64.deb" "$home/build/release/floes-1.0.0-Linux.tar.gz" "$home/build/release/floes-1.0.0-py3.whl"
launch package
check "their names" "$home/build/release/floes_1.1.0_amd64.deb
$home/build/release/floes-1.1.0-py3.whl
$home/build/release/floes-1.1.0-Linux.tar.gz" "$out"
check_has "packages" "cmake --build $home/build/release --target all
site
cmake --build $home/build/release --target package" "$(calls)"
launch package --fast
check "packages with an argument" 2 "$status"

# -- the site: its packages, and no build
machine
launch docs
check_has "the site needs its packages" "missing: theta" "$err"
check "without them nothing is made" "" "$(calls)"
echo theta >>"$stage/installed"
launch docs --versions releases
check "the site: where it is" "site/index.html" "$out"
check "the site needs no program" "site --versions releases" "$(calls)"

# -- under mpirun it only executes
for variable in OMPI_COMM_WORLD_RANK PMIX_RANK PMI_RANK; do
    machine
    : >"$stage/installed"
    export "$variable=0"
    launch run c.toml
    check "$variable, not built: status" 2 "$status"
    check_has "$variable, not built: what to do" "outside mpirun" "$err"
    mkdir -p "$home/build/release"
    printf '#!/bin/sh\necho "executed $*"\n' >"$home/build/release/floes"
    chmod +x "$home/build/release/floes"
    launch run c.toml
    check "$variable: executes" "executed run c.toml" "$out"
    check "$variable: nothing else" "" "$(calls)$err"
    unset "$variable"
done

# -- tests
machine
launch test
check "test" "ctest in $home: --preset release --no-tests=error -j3 -L default" "$out"
check "test builds the tests" "cmake --preset release -DFLOES_TESTS=ON
cmake --build $home/build/release --target tests" "$(calls)"
: >"$stage/calls"
launch test
check "the next test configures nothing" "cmake --build $home/build/release --target tests" "$(calls)"
launch test --all
check_has "all tests need their packages too" "missing: eta" "$err"
echo eta >>"$stage/installed"
launch test --all -R wire
check "test --all" "ctest in $home: --preset release --no-tests=error -j3 -LE slow -R wire" "$out"
check_has "all tests have programs of their own" "--target all_tests" "$(calls)"
launch test --slow -R wire
check_has "slow tests need theirs, and those that make packages" "missing: epsilon theta zeta" "$err"
printf 'epsilon\ntheta\nzeta\n' >>"$stage/installed"
launch test --slow -R wire
check "test --slow" "ctest in $home: --preset release --no-tests=error -j3 -R wire" "$out"
: >"$stage/installed"
launch test -L soak
check_has "test -L needs them as well" "missing: alpha beta epsilon eta gamma theta zeta" "$err"
printf '%s\n' alpha beta gamma epsilon eta theta zeta >"$stage/installed"
launch test -L soak
check "test -L" "ctest in $home: --preset release --no-tests=error -j3 -L soak" "$out"

# -- the sanitizers: a build of their own
machine
launch sanitize -R keys
check "sanitize" "ctest in $home: --preset asan --no-tests=error -j2 -L quick -R keys" "$out"
check "sanitize builds quick tests" "cmake --preset asan
cmake --build $home/build/asan --target quick_tests" "$(calls)"

# -- the second compiler: a build of its own, and nothing is run
machine
echo kappa >>"$stage/installed"
launch clang
check "clang builds all" "cmake --preset clang
cmake --build $home/build/clang --target all_tests" "$(calls)"

# -- what changed, before clang-tidy
machine
launch tidy
check_has "tidy needs its packages" "missing: iota" "$err"
echo iota >>"$stage/installed"
stub git <<'STUB'
#!/bin/bash
[[ $1 != rev-parse || $4 == "HEAD^{commit}" ]] || exit 1
[[ $1 != diff ]] || printf 'src/a b.cpp\nensemble/c.cpp\n'
STUB
stub clang-tidy-16 <<'STUB'
#!/bin/sh
echo "tidy $4" >>"$STAGE/calls"
[ "$4" != ensemble/c.cpp ]
STUB
launch tidy
check "tidy reads what changed, and fails with one of them" "cmake --preset dev
tidy ensemble/c.cpp
tidy src/a b.cpp" "$(calls | sort)"
[[ $status != 0 ]] || check "tidy fails" failed "$status"
launch tidy nowhere
check "tidy since a revision that is none" 2 "$status"

# -- wrong words are told before anything is installed or built
machine
: >"$stage/installed"
launch sumarize c.h5
check "a verb that is none: status" 2 "$status"
check "a verb that is none: nothing was tried" "" "$(calls)"
check_has "a verb that is none: those that are" "no verb 'sumarize'; the verbs are new show run array merge status plan " "$err"
check_has "a verb that is none: to the last one" " match serve verify" "$err"
launch run missing.toml -o c.h5
check "a file that is not there: status" 2 "$status"
check_has "a file that is not there: its name" "no file 'missing.toml', which 'floes run' is to read" "$err"
machine
for words in "run -o new.h5" "config new.toml" "--help" "help run"; do
    # shellcheck disable=SC2086
    launch $words
    check "$words is for the program" "0" "$status"
done

# -- how far a build is, without a terminal
machine
rm "$bin/cmake"
stub cmake <<'STUB'
#!/bin/bash
if [[ $1 == --preset ]]; then mkdir -p "build/$2"; exit; fi
echo "[0/2 0.013] Re-checking globbed directories..."
echo "[30/120 60.5] Building CXX object a.o"
echo "[31/120 61.0] Building CXX object b.o"
printf '#!/bin/sh\n' >"$2/floes"
chmod +x "$2/floes"
STUB
FLOES_TOLD_EACH=0 launch run c.toml
check_has "progress in lines" "floes: building floes: 30 of 120, 3:00 left" "$err"
check "a build without a terminal is told once, however far it is" 1 "$(grep -c "building floes: 120 steps" "$stage/err")"

((failures == 0)) && echo "launcher: all checks passed"
exit $((failures > 0))
