#!/usr/bin/zsh -f
# What zsh completes where one word alone fits: a shell of its own gets the keys, and is asked for its line.
#   test-completion.zsh FOLDER-OF-TINKER FOLDER-OF-COMPLETIONS
zmodload zsh/zpty zsh/zselect
integer number=0 failed=0
export TERM=dumb HOME=$(mktemp -d) # nothing of the user's

# What the shell says up to a text that fits the pattern, as `line`: false if none has come after 20 seconds.
says() {
    float waited=0
    local piece
    line=
    while [[ $line != $~1 ]]; do
        zpty -r shell piece && { line+=$piece; continue }
        zselect -t 5
        (( (waited += 0.05) < 20 )) || return 1
    done
}

# Keys into a new shell, and the line that stands then, as `line`.
line_after() {
    zpty -b shell "zsh -f -i"
    {
        zpty -w shell "PATH=$folder:$folder/../gui:\$PATH PS1= PS2= RPS1=; unsetopt zle_bracketed_paste prompt_cr prompt_sp; stty -echo"
        zpty -w shell "fpath=($completions \$fpath); autoload -U compinit; compinit -D"
        zpty -w shell "tell() { print -r -- \"line<\$BUFFER>\"; BUFFER=; }; zle -N tell; bindkey '^T' tell '^I' complete-word"
        zpty -w shell "print rea''dy"
        says '*ready*' || return 1
        zpty -n -w shell "$1"$'\t\x14'
        says '*line<*>*'
    } always {
        zpty -d shell
    }
}

# Asked for in up to three shells: one that is held up by other processes can lose keys that were typed ahead.
completes() {
    local line
    number+=1
    repeat 3; do
        line_after "$2" && break
    done
    line=${${line##*line<}%%>*}
    if [[ $line == "$1" ]]; then
        print "ok $number - $2"
    else
        print -r "not ok $number - $2: $line"
        failed=1
    fi
}

folder=$1
completions=$2
completes 'tinker equations ' 'tinker eq'
completes 'tinker help trade ' 'tinker help tr'
completes 'tinker run --no-estimate ' 'tinker run --no'
completes 'tinker plugins show ' 'tinker plugins sh'
completes 'tinker plugins show support-motion ' 'tinker plugins show support-mot'
completes 'tinker run --method=newmark ' 'tinker run --method=newm'
[[ -x $folder/../gui/tinker-gui ]] && completes 'tinker-gui --screenshot ' 'tinker-gui --screens'
print "1..$number"
rm -rf $HOME
exit $failed
