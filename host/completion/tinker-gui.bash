# Completion of tinker-gui in bash. Options are read from the help, so that this file knows none.
_tinker_gui()
{
    local word=${COMP_WORDS[COMP_CWORD]}
    COMPREPLY=()
    if [ "${word#-}" != "$word" ]; then
        mapfile -t COMPREPLY < <(compgen -W "$(tinker-gui --help 2>/dev/null |
            sed -n 's/^  \(-., \)\{0,1\}\(--[a-z-]*=\{0,1\}\).*/\2/p')" -- "$word")
        case ${COMPREPLY[0]-} in *=) compopt -o nospace 2>/dev/null ;; esac
    else
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
        compopt -o filenames 2>/dev/null
    fi
}
complete -F _tinker_gui tinker-gui
