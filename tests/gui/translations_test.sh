#!/usr/bin/env bash
# Are the translations up to date with the source? translations_test.sh PROJECT: runs lupdate into copies; a text of the
# source that the committed files lack, or one that they have too many, fails with its line. Without lupdate: left out.
set -euo pipefail
project=$1
PATH=/usr/lib/qt6/bin:/usr/lib64/qt6/bin:/usr/lib/qt5/bin:/usr/lib64/qt5/bin:$PATH
lupdate=$(command -v lupdate || command -v lupdate-qt6 || command -v lupdate-qt5) ||
  { echo "left out: lupdate is not installed (package qttools5-dev-tools)"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0
sources() { awk '/<name>/ {context = $0} /<source>/, /<\/source>/ {print context, $0}' "$1" | sort; }
for language in de zh_CN; do
  committed=$project/app/gui/translations/boxprobe_$language.ts
  copy=$folder/boxprobe_$language.ts
  cp "$committed" "$copy"
  (cd "$project" && "$lupdate" app filters -I . -extensions cpp,h -no-obsolete -locations none -ts "$copy") >"$folder/log" 2>&1 ||
    { cat "$folder/log"; exit 1; }
  if ! diff <(sources "$committed") <(sources "$copy") >"$folder/difference"; then
    echo "boxprobe_$language.ts: not up to date (<: no longer in the source, >: not yet translated); see app/gui/translations/README.md"
    cat "$folder/difference"
    failed=1
  fi
  if grep -n 'type="' "$copy"; then
    echo "boxprobe_$language.ts: these are unfinished"
    failed=1
  fi
done
exit $failed
