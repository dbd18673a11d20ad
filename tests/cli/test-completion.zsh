#!/usr/bin/zsh -f
# What zsh completes where one word alone fits: a shell of its own gets the keys, and is asked for its line.
#   test-completion.zsh FOLDER-OF-TINKER FOLDER-OF-COMPLETIONS
zmodload zsh/zpty
integer number=0 failed=0
export TERM=dumb HOME=$(mktemp -d) # nothing of the user's
zpty shell "zsh -f -i"
zpty -w shell "PATH=$1:$1/../gui:\$PATH PS1= PS2= RPS1=; unsetopt zle_bracketed_paste prompt_cr prompt_sp; stty -echo"
zpty -w shell "fpath=($2 \$fpath); autoload -U compinit; compinit -D"
zpty -w shell "tell() { print -r -- \"line<\$BUFFER>\"; BUFFER=; }; zle -N tell; bindkey '^X' tell '^I' complete-word"
zpty -w shell "print rea''dy"
while zpty -r shell line && [[ $line != *ready* ]]; do :; done

# The line that stands after the tabulator.
completes() {
    local line
    number+=1
    zpty -n -w shell "$2"$'\t\x18'
    while zpty -r shell line && [[ $line != *'line<'*'>'* ]]; do :; done
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
