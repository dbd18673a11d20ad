# Completion of tinker in bash. Verbs and options are read from the help, so that this file knows none.
_tinker()
{
    local word=${COMP_WORDS[COMP_CWORD]} verb=${COMP_WORDS[1]-} words option=
    COMPREPLY=()
    # Bash takes --method=rk apart at the sign.
    [ "$word" = = ] && option=${COMP_WORDS[COMP_CWORD-1]} && word=
    [ "${COMP_WORDS[COMP_CWORD-1]}" = = ] && option=${COMP_WORDS[COMP_CWORD-2]}
    case $word in --method=*) option=--method word=${word#*=} ;; esac
    [ "${COMP_WORDS[COMP_CWORD-1]}" = --method ] && option=--method
    if [ "$COMP_CWORD" -eq 1 ]; then
        words="$(tinker --help 2>/dev/null | sed -n 's/^  \([a-z]*\) .*/\1/p') help --help --version"
    elif [ "$verb" = help ]; then
        words=$(tinker --help 2>/dev/null | sed -n 's/^  \([a-z]*\) .*/\1/p')
    elif [ "$option" = --method ]; then
        words="auto $(tinker plugins 2>/dev/null | sed -n 's/^\([^ ]*\) .*  integrator  .*/\1/p')"
    elif [ "${word#-}" != "$word" ]; then
        words=$(tinker "$verb" --help 2>/dev/null | sed -n 's/^  \(-., \)\{0,1\}\(--[a-z-]*=\{0,1\}\).*/\2/p')
    elif [ "$verb" = plugins ] && [ "$COMP_CWORD" -eq 2 ]; then
        words="list $(tinker plugins --help 2>/dev/null | sed -n '/^Options/,$d;s/^  \([a-z][a-z-]*\) .*/\1/p' | grep -v tinker)"
    elif [ "$verb" = plugins ] && [ "${COMP_WORDS[2]}" = show ]; then
        words=$(tinker plugins 2>/dev/null | sed -n '1d;s/^\([^ ]*\)  .*/\1/p')
    else
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
        compopt -o filenames 2>/dev/null
        return
    fi
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
    case ${COMPREPLY[0]-} in *=) compopt -o nospace 2>/dev/null ;; esac
}
complete -F _tinker tinker
