#!/usr/bin/zsh -f
# What zsh completes where one word alone fits: a shell of its own gets the keys, and is asked for its line.
#   test-completion.zsh FOLDER-OF-TINKER FOLDER-OF-COMPLETIONS
zmodload zsh/zpty zsh/zselect
integer number=0 failed=0
export TERM=dumb HOME=$(mktemp -d) # nothing of the user's
zpty -b shell "zsh -f -i"
zpty -w shell "PATH=$1:$1/../gui:\$PATH PS1= PS2= RPS1=; unsetopt zle_bracketed_paste prompt_cr prompt_sp; stty -echo"
zpty -w shell "fpath=($2 \$fpath); autoload -U compinit; compinit -D"
zpty -w shell "tell() { print -r -- \"line<\$BUFFER>\"; BUFFER=; }; zle -N tell; bindkey '^T' tell '^I' complete-word"
zpty -w shell "print rea''dy"
until zpty -r shell line && [[ $line == *ready* ]]; do zselect -t 5; done

# What the shell says next of its line, as `line`: false if it says nothing for 30 seconds.
says_line() {
    float waited=0
    local piece
    line=
    while [[ $line != *'line<'*'>'* ]]; do
        zpty -r shell piece && { line+=$piece; continue }
        zselect -t 5
        (( (waited += 0.05) < 30 )) || return 1
    done
}

# The line that stands after the tabulator. A shell that another process holds up can lose keys that were typed ahead: asked three times.
completes() {
    local line
    number+=1
    repeat 3; do
        zpty -n -w shell $'\x15'"$2"$'\t\x14'
        says_line && break
    done
    line=${${line##*line<}%%>*}
    if [[ $line == "$1" ]]; then
        print "ok $number - $2"
    else
        print -r "not ok $number - $2: $line"
        failed=1
    fi
}

completes 'tinker equations ' 'tinker eq'
completes 'tinker help trade ' 'tinker help tr'
completes 'tinker run --no-estimate ' 'tinker run --no'
completes 'tinker plugins show ' 'tinker plugins sh'
completes 'tinker plugins show support-motion ' 'tinker plugins show support-mot'
completes 'tinker run --method=newmark ' 'tinker run --method=newm'
[[ -x $1/../gui/tinker-gui ]] && completes 'tinker-gui --screenshot ' 'tinker-gui --screens'
print "1..$number"
zpty -d shell
rm -rf $HOME
exit $failed
