#!/bin/sh
# with_display.sh FIRST PROGRAM...: runs a program under a virtual X server of its own, whose number is the first free one
# of the ten from FIRST on. The server says by itself when it can be reached. (xvfb-run waits for a signal instead, which
# may come before it waits; then it waits forever.)
set -eu
number=$1
shift
last=$((number + 9))
folder=$(mktemp -d)
server=
clean_up() {
  if [ -n "$server" ]; then
    kill "$server" 2>/dev/null || :
    wait "$server" 2>/dev/null || :  # it takes its lock away
  fi
  rm -rf "$folder"
}
trap clean_up EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
mkfifo "$folder/ready"
while :; do
  Xvfb ":$number" -screen 0 1600x1000x24 -noreset -nolisten tcp -displayfd 3 3>"$folder/ready" >"$folder/log" 2>&1 &
  server=$!
  read -r shown <"$folder/ready" && break  # ends as well where the server does
  wait "$server" || :
  server=
  if [ "$number" -ge "$last" ]; then
    cat "$folder/log" >&2
    exit 1
  fi
  number=$((number + 1))
done
status=0
DISPLAY=":$number" "$@" || status=$?
exit "$status"
