#!/bin/sh
# two_folders.sh FOLDER [TARGET]: checks that the package is reproducible. The last commit is built from scratch in two
# folders below FOLDER with names of different lengths, and the packages must be identical. With TARGET, only the
# library TARGET is built and compared, which is much quicker.
set -eu
source=$(realpath "$(dirname "$0")/../..")
mkdir -p "$1"
out=$(realpath "$1")
target=${2:-}
for folder in "$out/a" "$out/another-place"; do
  rm -rf "$folder"
  git clone -q "$source" "$folder"
  cmake -S "$folder" --preset release -DTUBEPLAN_TESTS=OFF > /dev/null
  if [ -n "$target" ]; then
    cmake --build "$folder/build" --target "$target" > /dev/null
  else
    cmake --build "$folder/build" --target installed > /dev/null
    (cd "$folder/build" && SOURCE_DATE_EPOCH=$(git -C .. log -1 --format=%ct) cpack -G DEB > /dev/null)
  fi
done
pattern=${target:+*lib$target.a}
for file in $(cd "$out/a/build" && find . -name "${pattern:-tubeplan_*.deb}" -not -path './_CPack*'); do
  cmp "$out/a/build/$file" "$out/another-place/build/$file"
  echo "$file: the same bytes, SHA-256 $(sha256sum < "$out/a/build/$file" | cut -c1-64)"
done
