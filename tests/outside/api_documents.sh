#!/bin/sh
# The libraries' documentation by Doxygen, whose warnings are errors: api_documents.sh FOLDER, from the project's root.
set -eu
command -v doxygen >/dev/null || { echo "left out: package doxygen is not installed"; exit 77; }
mkdir -p "$1"
{ cat app/install/Doxyfile; echo "OUTPUT_DIRECTORY = $1"; } | doxygen -
test -s "$1/api/classboxprobe_1_1ActorProbes.html"
