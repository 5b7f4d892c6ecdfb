# Completion for bash. Sub-commands and options come from the program's own --help, and so are always those it has.
_boxprobe_commands() {
  boxprobe --help 2>/dev/null | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\+\) .*/\1/p'
}
_boxprobe_options() {
  boxprobe "$@" --help 2>/dev/null | grep -oE '^  (-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+'
}
_boxprobe() {
  local current=${COMP_WORDS[COMP_CWORD]} command=() commands
  commands=$(_boxprobe_commands)
  [[ $COMP_CWORD -gt 1 && " ${commands//$'\n'/ } " == *" ${COMP_WORDS[1]} "* ]] && command=("${COMP_WORDS[1]}")
  if [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_boxprobe_options "${command[@]}")" -- "$current")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
    [[ $COMP_CWORD -eq 1 ]] && mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -W "$commands" -- "$current")
  fi
  return 0
}
complete -o filenames -F _boxprobe boxprobe
