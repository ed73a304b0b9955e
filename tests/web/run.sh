#!/bin/sh
# End-to-end tests of the page in a real browser. Exits with 77, naming the missing software, if this machine lacks any.
# Environment: TUBEPLAN (the program), TUBEPLAN_WEB (a folder with the page's packages), TUBEPLAN_PAGE (a built page to
# show instead of the program's embedded page), TUBEPLAN_CHROMIUM (the browser). TUBEPLAN_SLOWNESS=N runs the page N
# times slower; TUBEPLAN_JITTER=MS delays each request and answer by up to MS milliseconds.
set -u
here=$(cd "$(dirname "$0")" && pwd)
skip() { echo "skipped: $1"; exit 77; }

command -v node > /dev/null || skip "node is not installed (apt-get install nodejs)"
command -v npm > /dev/null || skip "npm is not installed (apt-get install npm)"
[ -x "${TUBEPLAN_CHROMIUM:-/usr/bin/chromium}" ] || skip "Chromium is not installed (apt-get install chromium)"
"${TUBEPLAN:?the program}" serve --help > /dev/null 2>&1 || skip "this tubeplan has no command serve"
if [ ! -d "${TUBEPLAN_WEB:-none}/node_modules/playwright-core" ]; then
  TUBEPLAN_WEB=$(cd "$here/../../app/web" && pwd)
  [ -d "$TUBEPLAN_WEB/node_modules/playwright-core" ] || (cd "$TUBEPLAN_WEB" && npm ci --no-audit --no-fund > /dev/null 2>&1) ||
    skip "npm ci failed: the packages of app/web cannot be had here"
fi
export TUBEPLAN TUBEPLAN_WEB
exec node --test "$here"/*.test.mjs
