# Completion of tinker-gui in fish. Options are read from the help, so that this file knows none.
function __tinker_gui_options
    tinker-gui --help 2>/dev/null | string replace -rf '^  (?:-., )?(--[a-z-]+=?)\S* +(.*)' '$1\t$2'
end

complete -c tinker-gui -n 'string match -q -- "-*" (commandline -ct)' -a '(__tinker_gui_options)'
