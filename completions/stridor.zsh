#compdef stridor
# zsh completion of stridor: it asks the program
_stridor() {
    local line word meaning also
    local -a whole keys
    for line in "${(@f)$(_call_program words ${(q)words[1]} completion zsh -- ${(q)words[2,CURRENT]})}"; do
        word=${${line%%$'\t'*}//:/\\:} meaning=${line#*$'\t'}
        case $line in
            nothing|files|folders) also=$line ;;
            *=$'\t'*) keys+=("$word${meaning:+:$meaning}") ;;
            *) whole+=("$word${meaning:+:$meaning}") ;;
        esac
    done
    _describe word whole -- keys -S ''
    compset -P '--*='
    [[ $also == files ]] && _files
    [[ $also == folders ]] && _files -/
}
if [[ $funcstack[1] == _stridor ]]; then
    _stridor "$@"
else
    compdef _stridor stridor
fi
