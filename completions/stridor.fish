# fish completion of stridor: it asks the program
function __stridor
    set -l words (commandline -opc)
    set -l lines ($words[1] completion fish -- $words[2..] (commandline -ct) 2>/dev/null)
    string join -- \n $lines[2..]
    test "$lines[1]" = files; and __fish_complete_path (commandline -ct)
    test "$lines[1]" = folders; and __fish_complete_directories (commandline -ct)
end
complete -c stridor -f -a '(__stridor)'
