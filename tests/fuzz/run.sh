#!/bin/sh
# Gives every reader damaged text for so many seconds each, begun from the shipped files and what earlier runs have found
# (build-asan/corpus). `tests/fuzz/run.sh SECONDS [READER...]`; a find ends it with its input in build-asan/finds.
set -eu
cd "$(dirname "$0")/../.."
seconds=${1:?seconds for each reader}
shift
readers=${*:-arm cell measurements foreign urdf hole-map work-list selection formula campaign mesh stl project cache yaml-edit}
out=build-asan
mkdir -p $out/finds
for reader in $readers; do
  corpus=$out/corpus/$reader
  mkdir -p "$corpus"
  case $reader in
    arm) cp app/cells/*-arm.yaml "$corpus" ;;
    cell | yaml-edit) cp app/cells/*.yaml "$corpus" ;;
    urdf) cp tests/app/urdf/*.urdf "$corpus" ;;
    hole-map) cp app/cells/sheets/*.csv "$corpus" 2> /dev/null || true ;;
  esac
  [ -d tests/fuzz/corpus/$reader ] && cp tests/fuzz/corpus/$reader/* "$corpus"
  leaks=1
  case $reader in
    urdf | stl) leaks=0 ;; # urdfdom itself leaks robots whose links go round in a ring, assimp the object of an STL text
  esac
  echo "== $reader"
  ASAN_OPTIONS=detect_leaks=$leaks TUBEPLAN_READER=$reader $out/tests/fuzz/fuzz_readers "$corpus" -detect_leaks=$leaks -max_total_time="$seconds" -timeout=20 -rss_limit_mb=4096 \
    -max_len=20000 -print_final_stats=1 -verbosity=0 -artifact_prefix=$out/finds/$reader- 2>&1 | grep -E "ERROR|SUMMARY|stat::number_of|runtime error|Test unit" || true
  rm -rf /dev/shm/tubeplan-fuzz-$$
done
