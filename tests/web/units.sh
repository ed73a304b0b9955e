#!/bin/sh
# Unit tests of the page, with its packages in TUBEPLAN_WEB; tests that need the program use TUBEPLAN. Exits with 77 if
# npm or the packages are missing.
web=$(cd "$(dirname "$0")/../../app/web" && pwd)
export TUBEPLAN_CELLS="${web%/web}/cells" TUBEPLAN_PAGES="${web%/web}"
skip() { echo "skipped: $1"; exit 77; }
command -v npm > /dev/null || skip "npm is not installed (apt-get install npm)"
if [ -d "${TUBEPLAN_WEB:-none}/node_modules/vitest" ]; then
  rm -rf "$TUBEPLAN_WEB/tests" "$TUBEPLAN_WEB/../drawing" && cp -r "$web/tests" "$TUBEPLAN_WEB/" &&
    cp -r "$web/../drawing" "$TUBEPLAN_WEB/../" || exit 1
  web=$TUBEPLAN_WEB
fi
cd "$web" || exit 1
[ -d node_modules/vitest ] || npm ci --no-audit --no-fund > /dev/null 2>&1 || skip "npm ci failed: the packages of app/web cannot be had here"
exec npm test --silent
