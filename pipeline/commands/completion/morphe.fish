# fish completion of morphe: the program says what a word may become, files are the rest.
function __morphe_complete
    set -l words (commandline -opc) (commandline -ct)
    $words[1] --complete $words[2..-1] 2>/dev/null
end
complete -c morphe -n 'test (count (commandline -opc)) -lt 2' -f
complete -c morphe -a '(__morphe_complete)'
