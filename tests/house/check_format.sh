#!/usr/bin/env bash
# check_format.sh SOURCES: whether every C++ and GLSL file is as .clang-format lays it out; names those that are not.
# `git ls-files … | xargs clang-format -i` mends them.
set -euo pipefail
cd "$1"

command -v clang-format >/dev/null || { echo "clang-format is not installed" >&2; exit 1; }
rooms=$(cut -d/ -f1 cmake/rooms.txt | sort -u)
# shellcheck disable=SC2086
find $rooms tests cmake -type f \( -name '*.h' -o -name '*.cpp' -o -name '*.glsl' -o -name '*.vert' -o -name '*.frag' \
  -o -name '*.comp' \) -print0 | xargs -0 -n 40 -P "$(nproc)" clang-format --dry-run -Werror
