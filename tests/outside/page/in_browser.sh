#!/bin/sh
# A page in a headless browser, driven by a script for Node.js:  in_browser.sh SCRIPT.mjs ARGUMENTS...
# BOXPROBE_BROWSER=firefox takes Debian's Firefox in place of Chromium.
browser=chromium
[ "$BOXPROBE_BROWSER" = firefox ] && browser=firefox-esr
for program in node $browser; do
  command -v $program >/dev/null || { echo "left out: $program is not installed (packages nodejs, $browser)"; exit 77; }
done
exec node "$@"
