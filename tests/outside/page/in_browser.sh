#!/bin/sh
# A page in headless Chromium, driven by a script for Node.js:  in_browser.sh SCRIPT.mjs ARGUMENTS...
for program in node chromium; do
  command -v $program >/dev/null || { echo "left out: $program is not installed (packages nodejs, chromium)"; exit 77; }
done
exec node "$@"
