#!/bin/sh
# The page's own unit tests. Exit code 77 where npm or its packages are not on this machine.
web=$(cd "$(dirname "$0")/../../app/web" && pwd)
skip() { echo "skipped: $1"; exit 77; }
command -v npm > /dev/null || skip "npm is not installed (apt-get install npm)"
cd "$web" || exit 1
[ -d node_modules/vitest ] || npm ci --no-audit --no-fund > /dev/null 2>&1 || skip "npm ci failed: the packages of app/web cannot be had here"
exec npm test --silent
