#!/usr/bin/env bash
# Plants one meadow with every compiler and optimisation level and compares the hashes of its blades.
#   hash_matrix.sh SOURCE_FOLDER WORK_FOLDER [COMPILER,FLAGS …]
# Without variants: g++ and clang++ at -O0 and -O2. Compilers that are not installed are an error, not a pass.
set -euo pipefail

source_folder=$1
work_folder=$2
shift 2
variants=("$@")
((${#variants[@]})) || variants=(g++,-O0 g++,-O2 clang++,-O0 clang++,-O2)

# What planting needs, and no more: no image library.
files=(
  files/error.cpp
  maps/filled_heights.cpp maps/ground_survey.cpp maps/height_bounds.cpp maps/height_field.cpp
  maps/node_grid.cpp maps/node_mask.cpp maps/nodata_fill.cpp
  generator/cell_lattice.cpp generator/cell_table.cpp generator/meadow.cpp generator/plant.cpp
  generator/plant_cell.cpp generator/tiles.cpp
  tests/generator/hashed_meadow.cpp tests/generator/print_hash.cpp
)
# As cmake/prairie_room.cmake and shaders/CMakeLists.txt set them.
flags=(-std=c++20 -ffp-contract=off -fno-math-errno -fno-trapping-math -DGLM_FORCE_XYZW_ONLY
  "-I$source_folder")
launcher=()
! command -v ccache >/dev/null || launcher=(ccache)

hash_of_variant() {
  local compiler=${1%%,*}
  local -a options
  IFS=, read -ra options <<<"${1#*,}"
  command -v "$compiler" >/dev/null || { echo "$compiler is not installed" >&2; return 1; }
  local folder=$work_folder/$1
  mkdir -p "$folder"
  local objects=() file object
  for file in "${files[@]}"; do
    object=$folder/${file//\//_}.o
    "${launcher[@]}" "$compiler" "${flags[@]}" "${options[@]}" -c "$source_folder/$file" -o "$object"
    objects+=("$object")
  done
  "$compiler" "${options[@]}" "${objects[@]}" -o "$folder/print_hash" -ltbb -lxxhash -lfmt
  "$folder/print_hash"
}

first=
different=0
for variant in "${variants[@]}"; do
  hash=$(hash_of_variant "$variant")
  echo "$hash $variant"
  first=${first:-$hash}
  [[ $hash == "$first" ]] || different=1
done
if ((different)); then
  echo "the builds plant different blades" >&2
  exit 1
fi
