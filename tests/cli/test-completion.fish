#!/usr/bin/fish
# What fish completes: verbs, options of a verb, methods, types.
#   test-completion.fish FOLDER-OF-TINKER FOLDER-OF-COMPLETIONS
set -gx PATH $argv[1] $argv[1]/../gui $PATH
source $argv[2]/tinker.fish
source $argv[2]/tinker-gui.fish
set -g number 0
set -g failed 0

# What is expected for a line, the words separated by blanks; descriptions are left out.
function completes
    set number (math $number + 1)
    set -l found (complete -C $argv[2] | string replace -r '\t.*' '')
    if test "$found" = $argv[1]
        echo "ok $number - $argv[2]"
    else
        echo "not ok $number - $argv[2]: $found"
        set failed 1
    end
end

completes 'plan plugins' 'tinker pl'
completes trade 'tinker help tr'
completes --duration= 'tinker run --dur'
completes --no-estimate 'tinker run --no'
completes show 'tinker plugins sh'
completes 'support support-motion support-turn' 'tinker plugins show supp'
completes '--method=verlet --method=verlet6' 'tinker run --method=verl'
if type -q tinker-gui
    completes --screenshot= 'tinker-gui --screens'
end
echo "1..$number"
exit $failed
