# bash completion of stridor: it asks the program
_stridor() {
    local also word meaning
    COMPREPLY=()
    {
        read -r also
        while IFS=$'\t' read -r word meaning; do
            [[ $word == --*=?* ]] && word=${word#*=}  # a word ends at "="
            COMPREPLY+=("$(printf '%q' "$word")")
        done
    } < <("$1" completion bash -- "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
    [[ ${COMPREPLY[*]} == *= ]] && compopt -o nospace
    [[ $also == nothing ]] && return
    compopt -o filenames
    local action=-f
    [[ $also == folders ]] && action=-d
    mapfile -t COMPREPLY < <(compgen $action -- "$2")
}
complete -F _stridor stridor
