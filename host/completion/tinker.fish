# Completion of tinker in fish. Verbs and options are read from the help, so that this file knows none.
function __tinker_verbs
    tinker --help 2>/dev/null | string replace -rf '^  ([a-z]+) +(.*)' '$1\t$2'
end

function __tinker_options
    set -l words (commandline -opc)
    tinker $words[2] --help 2>/dev/null | string replace -rf '^  (?:-., )?(--[a-z-]+=?)\S* +(.*)' '$1\t$2'
end

function __tinker_plugins_verbs
    echo list
    tinker plugins --help 2>/dev/null | string match -v '  tinker *' | string replace -rf '^  ([a-z][a-z-]+) +(.*)' '$1\t$2'
end

function __tinker_types
    tinker plugins 2>/dev/null | tail -n +2 | string replace -rf '^(\S+)  +(.*)' '$1\t$2'
end

function __tinker_methods
    echo auto
    tinker plugins 2>/dev/null | string replace -rf '^(\S+) +(.*)  integrator  .*' '$1\t$2'
end

complete -c tinker -n '__fish_seen_subcommand_from plugins; and __fish_is_nth_token 2' -f -a '(__tinker_plugins_verbs)'
complete -c tinker -n '__fish_seen_subcommand_from show; and __fish_is_nth_token 3' -f -a '(__tinker_types)'
complete -c tinker -l method -x -a '(__tinker_methods)'
complete -c tinker -n '__fish_is_nth_token 1; or __fish_seen_subcommand_from help' -f -a '(__tinker_verbs)'
complete -c tinker -n '__fish_is_nth_token 1' -f -a help -d 'show the help of a verb'
complete -c tinker -n 'not __fish_is_nth_token 1; and string match -q -- "-*" (commandline -ct)' -a '(__tinker_options)'
