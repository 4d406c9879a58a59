#!/usr/bin/env bash
# check_install.sh SOURCES BUILD CHECK: installs the build into a fresh folder and checks that, without SOURCES,
#   consumer   another project finds the package, and steps a world with it
#   program    the installed program draws a picture of the installed example
set -euo pipefail
sources=$1 build=$2 check=$3

prefix=$(mktemp -d)
trap 'rm -rf -- "$prefix"' EXIT
cmake --install "$build" --prefix "$prefix/prairie" >"$prefix/install.log"
if grep -rlF --include='*.cmake' -- "$sources" "$prefix/prairie"; then
  echo "the files above name the sources" >&2
  exit 1
fi
example=$prefix/prairie/share/prairie/examples/meadow

# without_sources COMMAND…: runs it where an empty folder hides the sources; 77 where this machine cannot do that.
without_sources() {
  local as_root=()
  ((EUID == 0)) || as_root=(--map-root-user)
  unshare "${as_root[@]}" --mount true 2>/dev/null || { echo "no mounts of one's own here: skipped"; exit 77; }
  unshare "${as_root[@]}" --mount sh -c \
    'mount -t tmpfs none "$1" || exit 77; shift; exec "$@"' sh "$sources" "$@"
}

cd "$prefix"
case $check in
  consumer)
    cp -r "$sources/tests/install/consumer" consumer
    without_sources sh -c "cmake -G Ninja -S consumer -B built -DCMAKE_PREFIX_PATH='$prefix/prairie' &&
      cmake --build built && built/consumer '$example'"
    ;;
  program)
    without_sources prairie/bin/prairie render "$example" -o picture.png --size 320x200
    test -s picture.png
    ;;
esac
