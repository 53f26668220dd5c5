# bash completion of stridor; made by `stridor completion bash`
_stridor() {
    local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} options=""
    if ((COMP_CWORD == 1)); then
        COMPREPLY=($(compgen -W "init check simulate stability chart figure convert analyse classify verify completion --help --version" -- "$word"))
        return
    fi
    if [[ $previous == --set ]]; then
        COMPREPLY=($(compgen -W "title= joint.mass= joint.axial_stiffness= joint.flexural_stiffness= joint.axial_damping= joint.flexural_damping= joint.incidence_angle= plate.mass= plate.stiffness= plate.damping= contact.preload= contact.static_friction= contact.kinetic_friction= contact.impact= contact.restitution= drive.kind= drive.amplitude= drive.frequency= drive.velocity= drive.file= run.duration= run.window= run.initial= run.perturbation= run.engine= run.early_ending= run.step= run.beta_2= verdict.settling= verdict.reversal= verdict.quiet_slip= verdict.creak_stick= verdict.squeal_regularity= verdict.squeal_beats= verdict.least_intervals=" -- "$word"))
        compopt -o nospace
        return
    fi
    if [[ ${COMP_WORDS[1]} == init && COMP_CWORD -eq 2 ]]; then
        COMPREPLY=($(compgen -W "squeal squeak creak quiet noise-chart rate-map schema" -- "$word"))
        return
    fi
    case ${COMP_WORDS[1]} in
        init) options="--help --output" ;;
        check) options="--help --set --json" ;;
        simulate) options="--help --set --no-early --json --trace --trace-from --trace-to --trace-interval --history --figure --zoom" ;;
        stability) options="--help --set --over --figure --json" ;;
        chart) options="--help --set --no-early --out --threads --json" ;;
        figure) options="--help" ;;
        convert) options="--help --full-scale --format --bits --channel --dataset --rate --json" ;;
        analyse) options="--help --full-scale --channel --dataset --rate --set --a-weighting --figure --json" ;;
        classify) options="--help --full-scale --channel --dataset --rate --set --json" ;;
        verify) options="--help" ;;
        completion) options="--help" ;;
    esac
    if [[ $word == -* ]]; then
        COMPREPLY=($(compgen -W "$options" -- "$word"))
    else
        COMPREPLY=($(compgen -f -- "$word"))
        compopt -o filenames
    fi
}
complete -F _stridor stridor
