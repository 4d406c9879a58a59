#!/usr/bin/env bash
# same_outputs.sh REFERENCE PROGRAM: what both programs make of every example, byte for byte: hashes of all
# tiles, pictures in both formats, tiles' pictures, clips, states and trajectories. For changes that must not
# change what the program does; REFERENCE is the program of an earlier commit, built beside this one, or a
# folder in which `same_outputs.sh --keep PROGRAM FOLDER` has kept what such a program made. Ends with 1 where
# anything differs.
set -euo pipefail

if [[ $# -ne 2 && $# -ne 3 ]]; then
  echo "usage: same_outputs.sh REFERENCE PROGRAM, or same_outputs.sh --keep PROGRAM FOLDER" >&2
  exit 2
fi
examples=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../../examples
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

# make_all PROGRAM OUT: everything that is compared.
make_all() {
  local program=$1 out=$2 scene name camera
  for scene in "$examples"/*/; do
    name=$(basename -- "$scene")
    mkdir -p "$out/$name"
    "$program" plant "$scene" -o "$out/$name/hashes.txt" --hashes -q
    "$program" info "$scene" --json >"$out/$name/info.json"
    while read -r camera; do
      "$program" render "$scene" -o "$out/$name/$camera.png" --camera "$camera" --size 480x320 --samples 2 -q
      "$program" render "$scene" -o "$out/$name/$camera.exr" --camera "$camera" --size 320x240 --time 1.5 -q
    done < <(sed -n '/^\[\[camera\]\]/,/^name/s/^name *= *"\(.*\)"/\1/p' "$scene/scene.toml")
    for tier in spline hermite strip flat; do
      "$program" render "$scene" -o "$out/$name/tier_$tier.png" --size 320x240 --tier $tier -q
    done
    "$program" export "$scene" -o "$out/$name/tiles" --tiles 3,3,4,3 --size 128x128 --time 0.5 -q
    "$program" record "$scene" -o "$out/$name/clip" --duration 1 --fps 15 --size 320x180 \
      --save-state "$out/$name/clip.state" -q
    if grep -q '^\[\[walkers\]\]' "$scene/scene.toml"; then
      "$program" walk "$scene" --duration 20 --trajectories "$out/$name/walk.csv" \
        --save-state "$out/$name/walk.state" -q
      "$program" walk "$scene" --duration 1 --fps 10 --record "$out/$name/walk_clip" --size 320x180 -q
    fi
  done
}

if [[ $1 == --keep ]]; then
  make_all "$2" "$3"
  exit 0
fi
reference=$1
if [[ ! -d $reference ]]; then
  reference=$work/reference
  make_all "$1" "$reference"
fi
make_all "$2" "$work/program"
files=$(cd "$reference" && find . -type f | wc -l)
if ! diff -rq "$reference" "$work/program" >"$work/differences"; then
  head -n 20 "$work/differences"
  echo "$(wc -l <"$work/differences") of $files files differ"
  exit 1
fi
echo "$files files are the same"
