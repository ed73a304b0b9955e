#!/bin/sh
# The page end to end in a real browser. Exit code 77 where something that it needs is not on this machine, with its name.
# Environment: TUBEPLAN (the program), TUBEPLAN_PAGE (the built page; built here where it is not), TUBEPLAN_CHROMIUM.
set -u
here=$(cd "$(dirname "$0")" && pwd)
web=$(cd "$here/../../app/web" && pwd)
skip() { echo "skipped: $1"; exit 77; }

command -v node > /dev/null || skip "node is not installed (apt-get install nodejs)"
command -v npm > /dev/null || skip "npm is not installed (apt-get install npm)"
browser=${TUBEPLAN_CHROMIUM:-/usr/bin/chromium}
[ -x "$browser" ] || skip "Chromium is not installed (apt-get install chromium)"
"${TUBEPLAN:?the program}" serve --help > /dev/null 2>&1 || skip "this tubeplan has no command serve"

if [ ! -d "$web/node_modules/playwright-core" ]; then
  (cd "$web" && npm ci --no-audit --no-fund > /dev/null 2>&1) || skip "npm ci failed: the packages of app/web cannot be had here"
fi
if [ ! -f "${TUBEPLAN_PAGE:-none}/index.html" ]; then
  TUBEPLAN_PAGE=$(mktemp -d)
  trap 'rm -rf "$TUBEPLAN_PAGE"' EXIT
  (cd "$web" && npm run build -- --outDir "$TUBEPLAN_PAGE" --logLevel warn) || exit 1
fi
export TUBEPLAN TUBEPLAN_PAGE
node --test --test-reporter=spec "$here"/*.test.mjs
