#!/usr/bin/env bash
# run_sanitized.sh SOURCES PRESET: builds with the preset's sanitizers what they can say most about, and runs it:
#   asan   the readers on good, broken and hostile files
#   tsan   what runs on many threads
set -euo pipefail
sources=$1 preset=$2
build=$sources/build/$preset

case $preset in
  asan) targets=(prairie_{files,pictures,maps}_tests replay_{map_file,georaster,scene}) ;;
  tsan) targets=(prairie_thread_tests) ;;
esac

exec 9>"$build.lock"
flock 9
cd "$sources"
launcher=()
! command -v ccache >/dev/null || launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
log=$(mktemp)
trap 'rm -f -- "$log"' EXIT
if ! { cmake --preset "$preset" "${launcher[@]}" && cmake --build "$build" --target "${targets[@]}"; } >"$log" 2>&1 9>&-; then
  cat -- "$log"
  exit 1
fi

unset PRAIRIE_DATA  # large files tell sanitizers nothing that small ones do not
case $preset in
  asan)
    # Full stacks at every allocation: libraries keep no frame pointers, and their leaks are known by their frames.
    export ASAN_OPTIONS=detect_leaks=1:fast_unwind_on_malloc=0 UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1
    export LSAN_OPTIONS=suppressions=$sources/tests/sanitizers/leaks_of_libraries.txt:print_suppressions=0
    "$build/tests/fuzz/replay_map_file" 9>&- &  # as long as all others
    for room in files pictures maps; do
      "$build/tests/$room/prairie_${room}_tests" --gtest_brief=1 --gtest_filter='-*Speed*'
    done
    for reader in georaster scene; do "$build/tests/fuzz/replay_$reader"; done
    wait $!
    ;;
  tsan)
    export TSAN_OPTIONS=halt_on_error=1
    "$build/tests/sanitizers/prairie_thread_tests" --gtest_brief=1
    ;;
esac
