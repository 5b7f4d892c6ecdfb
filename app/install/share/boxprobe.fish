# Completion for fish. Sub-commands and options come from the program's own --help, and so are always those it has.
function __boxprobe_commands
    boxprobe --help 2>/dev/null | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\+\) \+\(.*\)/\1\t\2/p'
end
function __boxprobe_options
    set -l words (commandline -opc)
    set -l names (__boxprobe_commands | string replace -r '\t.*' '')
    set -l command
    if test (count $words) -gt 1; and contains -- $words[2] $names
        set command $words[2]
    end
    boxprobe $command --help 2>/dev/null | string match -rg '^  (?:-[a-z],)?(--[a-z-]+)'
end
complete -c boxprobe -n 'test (count (commandline -opc)) -eq 1' -a '(__boxprobe_commands)'
complete -c boxprobe -n 'string match -q -- "-*" (commandline -ct)' -a '(__boxprobe_options)'
