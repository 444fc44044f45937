#!/usr/bin/env bash
# The package in a bare Debian 12: what lintian says of it, whether apt installs it, and whether floes gives there the
# members that it gives here; the same of the container, which is made of this package instead of one that is built in
# it. Needs root, mmdebstrap, lintian, busybox and buildah; apt's own sources of this machine serve the new root.
#   debian_root.sh BUILD_FOLDER PROGRAM PROJECT_FOLDER
# FLOES_BARE_ROOT names a tarball of such a root, for those who run this often.
set -euo pipefail
build=$1
program=$2
project=$3
[[ $(id -u) == 0 ]] || { echo "this test needs root" >&2; exit 1; }
stage=$(mktemp -d)
trap 'rm -rf -- "$stage"' EXIT
fail() { echo "FAILED: $*" >&2; exit 1; }

(cd "$build" && cpack -G "DEB;External" -B "$stage") >"$stage/log" || fail "cpack: $(<"$stage/log")"
package=$(echo "$stage"/floes_*.deb)
[[ -e $package ]] || fail "no package was made: $(<"$stage/log")"

# The project has no address of its own; nothing else is suppressed.
lintian --allow-root --fail-on error,warning \
    --suppress-tags bogus-mail-host,bogus-mail-host-in-debian-changelog "$package" ||
    fail "lintian is not content"

sources=(/etc/apt/sources.list.d/debian.sources)
[[ -e ${sources[0]} ]] || sources=(/etc/apt/sources.list)
if [[ ${FLOES_BARE_ROOT-} ]]; then
    mkdir "$stage/root" && tar -C "$stage/root" -xf "$FLOES_BARE_ROOT"
else
    mmdebstrap --quiet --variant=minbase bookworm "$stage/root" "${sources[@]}" || fail "mmdebstrap"
fi

# Of this root as debian:12, with no registry and in no storage but its own.
box() { XDG_RUNTIME_DIR=$stage buildah --root "$stage/images" --runroot "$stage/running" --storage-driver vfs "$@"; }
mkdir -p "$stage"/{empty,work,built/floes/build/release}
cp "$package" "$stage/built/floes/build/release/"
bare=$(box from scratch)
{ box add "$bare" "$stage/root" / && box commit -q "$bare" docker.io/library/debian:12; } >"$stage/log" 2>&1 ||
    fail "no image: $(<"$stage/log")"
box bud --isolation chroot --pull-never --build-context "build=$stage/built" -t floes \
    -f "$project/packaging/container/Containerfile" "$stage/empty" >"$stage/log" 2>&1 ||
    fail "the container: $(tail -20 "$stage/log")"
container=$(box from --pull-never floes)
[[ $(box inspect --format '{{.OCIv1.Config.Entrypoint}}' "$container") == "[floes]" ]] || fail "it starts something else"
box run --isolation chroot -v "$stage/work:/work" "$container" -- floes run smoke --ranks 2 >"$stage/log" 2>&1 ||
    fail "in the container: $(tail -20 "$stage/log")"
box rm -a >/dev/null && box rmi -a >/dev/null

cp "$package" "$stage/root/"
# With /proc, which is gone with the command.
here() {
    # shellcheck disable=SC2016  # expanded by that shell
    unshare -m sh -c 'mount -t proc proc "$0/proc" && exec chroot "$0" env -i PATH=/usr/bin:/bin:/usr/sbin:/sbin \
        HOME=/root DEBIAN_FRONTEND=noninteractive "$@"' "$stage/root" "$@"
}

cp -L /etc/resolv.conf "$stage/root/etc/resolv.conf"
here apt-get -q update >"$stage/log" 2>&1 || fail "apt-get update: $(<"$stage/log")"
here apt-get -q install -y --no-install-recommends "/$(basename "$package")" >"$stage/log" 2>&1 ||
    fail "apt: $(tail -20 "$stage/log")"
here sh -c '! command -v g++ && ! command -v cmake' || fail "the package brings a compiler along"
[[ $(here floes --version | head -1) == "$("$program" --version | head -1)" ]] || fail "another version is installed"
here sh -c 'cd /root && floes run smoke >/dev/null' || fail "floes run smoke ended with $?"
"$program" run "$stage/root/usr/share/floes/configs/smoke.toml" -o "$stage/smoke.h5" >"$stage/log" 2>&1 ||
    fail "the same here ended with $?: $(<"$stage/log")"
h5diff --exclude-path /provenance "$stage/root/root/smoke.h5" "$stage/smoke.h5" || fail "the members differ"
h5diff --exclude-path /provenance "$stage/work/smoke.h5" "$stage/smoke.h5" || fail "the container's members differ"
here floes run smoke -o /root/two.h5 --ranks 2 >"$stage/log" 2>&1 && fail "mpirun is there unasked"
[[ $(<"$stage/log") == *"could not be started"* ]] || fail "without mpirun it says $(<"$stage/log")"
[[ -e $stage/root/usr/lib/python3/dist-packages/floes_reader/__init__.py ]] || fail "the Python reader is missing"
# The tarball, on a machine that has a kernel, a shell and no library.
mkdir -p "$stage"/none/{bin,dev,opt,proc,root,tmp}
cp "$(command -v busybox)" "$stage/none/bin/busybox"
for word in sh env dirname readlink; do ln -s busybox "$stage/none/bin/$word"; done
tar -C "$stage/none/opt" -xf "$stage"/floes-*.tar.gz
# shellcheck disable=SC2016
unshare -m sh -c 'mount -t proc proc "$0/proc" && mount --bind /dev "$0/dev" && exec chroot "$0" /bin/env -i PATH=/bin \
    HOME=/root sh -c "cd /root && /opt/floes-*/bin/floes run smoke && /opt/floes-*/bin/floes replay smoke.h5 --worst -o worst.png"' \
    "$stage/none" >"$stage/log" 2>&1 || fail "without libraries the tarball says: $(tail -20 "$stage/log")"
h5diff --exclude-path /provenance "$stage/none/root/smoke.h5" "$stage/smoke.h5" || fail "the tarball's members differ"
[[ -s $stage/none/root/worst.png && -e $(echo "$stage"/none/opt/floes-*/share/doc/floes/licences/libc6) ]] ||
    fail "the tarball's picture or its licences are missing"
here dpkg --verify floes || fail "files changed"
here apt-get -q purge -y floes >"$stage/log" 2>&1 || fail "apt-get purge: $(<"$stage/log")"
[[ ! -e $stage/root/usr/share/floes ]] || fail "purge leaves files"
echo "installed in a bare root and in a container, ran there and without any library, same members"
