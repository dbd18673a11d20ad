# Completion of tinker in bash. Verbs and options are read from the help, so that this file knows none.
_tinker()
{
    local word=${COMP_WORDS[COMP_CWORD]} verb=${COMP_WORDS[1]-} words
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
        words="$(tinker --help 2>/dev/null | sed -n 's/^  \([a-z]*\) .*/\1/p') help --help --version"
    elif [ "$verb" = help ]; then
        words=$(tinker --help 2>/dev/null | sed -n 's/^  \([a-z]*\) .*/\1/p')
    elif [ "${word#-}" != "$word" ]; then
        words=$(tinker "$verb" --help 2>/dev/null | sed -n 's/^  \(-., \)\{0,1\}\(--[a-z-]*=\{0,1\}\).*/\2/p')
    else
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
        compopt -o filenames 2>/dev/null
        return
    fi
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
    case ${COMPREPLY[0]-} in *=) compopt -o nospace 2>/dev/null ;; esac
}
complete -F _tinker tinker
