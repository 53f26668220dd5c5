# bash completion of stridor; made by `stridor completion bash`
_stridor() {
    local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} options=""
    if ((COMP_CWORD == 1)); then
        COMPREPLY=($(compgen -W "init check simulate stability advise chart merge chart-status report figure listen rig convert library analyse classify evaluate compare match structure explore verify completion help --help --version" -- "$word"))
        return
    fi
    if [[ $previous == --set ]]; then
        COMPREPLY=($(compgen -W "title= joint.mass= joint.axial_stiffness= joint.flexural_stiffness= joint.axial_damping= joint.flexural_damping= joint.incidence_angle= plate.mass= plate.stiffness= plate.damping= structure.stiffness_scale= structure.damping_scale= structure.mass= structure.stiffness= structure.damping_ratio= structure.damping= structure.coupling= structure.frequency= structure.impedance= structure.length= structure.bridge_resistance= structure.position= structure.mass_per_length= structure.bending_stiffness= structure.axial_stiffness= structure.incidence_angle= contact.preload= contact.friction= contact.static_friction= contact.kinetic_friction= contact.static_friction_coming= contact.kinetic_friction_coming= contact.impact= contact.restitution= temperature.value= drive.kind= drive.amplitude= drive.frequency= drive.velocity= drive.force= drive.ramp= drive.file= run.duration= run.window= run.initial= run.perturbation= run.engine= run.early_ending= run.step= run.formulation= run.massless_above= run.beta_2= verdict.start= verdict.settling= verdict.reversal= verdict.quiet_slip= verdict.creak_stick= verdict.least_releases= verdict.squeal_regularity= verdict.squeal_beats= verdict.squeal_repetition= verdict.squeal_frequency= verdict.least_intervals= verdict.lock_force= verdict.least_distance=" -- "$word"))
        compopt -o nospace
        return
    fi
    if [[ $previous == @(--over|--tolerance) && ${COMP_WORDS[1]} == @(advise|stability) ]]; then
        COMPREPLY=($(compgen -W "joint.mass= joint.axial_stiffness= joint.flexural_stiffness= joint.axial_damping= joint.flexural_damping= joint.incidence_angle= plate.mass= plate.stiffness= plate.damping= structure.stiffness_scale= structure.damping_scale= structure.mass= structure.stiffness= structure.damping_ratio= structure.damping= structure.coupling= structure.frequency= structure.impedance= structure.length= structure.bridge_resistance= structure.position= structure.mass_per_length= structure.bending_stiffness= structure.axial_stiffness= structure.incidence_angle= contact.preload= contact.static_friction= contact.kinetic_friction= contact.static_friction_coming= contact.kinetic_friction_coming= contact.restitution= temperature.value= drive.amplitude= drive.frequency= drive.velocity= drive.force= drive.ramp= run.duration= run.window= run.perturbation= run.step= run.massless_above= run.beta_2= verdict.start= verdict.settling= verdict.reversal= verdict.quiet_slip= verdict.creak_stick= verdict.least_releases= verdict.squeal_regularity= verdict.squeal_beats= verdict.squeal_repetition= verdict.squeal_frequency= verdict.least_intervals= verdict.lock_force= verdict.least_distance=" -- "$word"))
        compopt -o nospace
        return
    fi
    if [[ ${COMP_WORDS[1]} == init && COMP_CWORD -eq 2 ]]; then
        COMPREPLY=($(compgen -W "squeal squeak creak quiet noise-chart rate-map weatherstrip weatherstrip-shaken glass-run clip wiper brake-pad two-lips chain string schema" -- "$word"))
        return
    fi
    case ${COMP_WORDS[1]} in
        init) options="--help --output --force" ;;
        check) options="--help --set --json" ;;
        simulate) options="--help --set --no-early --json --trace --trace-from --trace-to --trace-interval --history --figure --zoom --title --width" ;;
        stability) options="--help --set --over --figure --title --width --csv --modes --json" ;;
        advise) options="--help --set --over --tolerance --samples --seed --direction --start --threads --json" ;;
        chart) options="--help --set --no-early --x --y --out --files --figures --threads --preview --json --shard --slurm --title --width --time" ;;
        merge) options="--help" ;;
        chart-status) options="--help --json --lacking" ;;
        report) options="--help --set --no-early --output --x --y --points --author --part --longest --no-chart --no-advice --direction --start --threads" ;;
        figure) options="--help" ;;
        listen) options="--help --set --cell --direction --judged --output --of --quantity --component --rate --seconds --level --full-scale --high-pass --fade --json" ;;
        rig) options="--help" ;;
        convert) options="--help --full-scale --channel --dataset --rate --format --bits --json" ;;
        library) options="--help" ;;
        analyse) options="--help --full-scale --channel --dataset --rate --set --a-weighting --field --figure --title --width --json" ;;
        classify) options="--help --full-scale --channel --dataset --rate --set --json" ;;
        evaluate) options="--help --planes --set --of --perturb-every --recordings --labels --csv --threads --json" ;;
        compare) options="--help --label --library --of --quantity --json" ;;
        match) options="--help --chart --set --best --every --store --out --with-level --threads --library --of --quantity --json" ;;
        structure) options="--help" ;;
        explore) options="--help --set --port --no-browser --unix-socket --library --threads --address --allow-remote --host-name --frame" ;;
        verify) options="--help" ;;
        completion) options="--help" ;;
    esac
    if [[ ${COMP_WORDS[1]} == figure ]]; then
        if ((COMP_CWORD == 2)); then
            COMPREPLY=($(compgen -W "paper friction-law contact-states mode-shapes modal-spectrum compare --help" -- "$word"))
            return
        fi
        case ${COMP_WORDS[2]} in
            paper) options="--help --out --threads --title --width" ;;
            friction-law) options="--help --set --output --title --width" ;;
            contact-states) options="--help --set --output --title --width" ;;
            mode-shapes) options="--help --set --output --title --width --mesh" ;;
            modal-spectrum) options="--help --set --output --title --width --of --component" ;;
            compare) options="--help --label --library --of --quantity --detail --output --title --width" ;;
        esac
    fi
    if [[ ${COMP_WORDS[1]} == rig ]]; then
        if ((COMP_CWORD == 2)); then
            COMPREPLY=($(compgen -W "friction sensitivity --help" -- "$word"))
            return
        fi
        case ${COMP_WORDS[2]} in
            friction) options="--help --preload --channel --velocity-channel --normal-channel --velocity --full-scale --least-drop --longest-drop --into --json" ;;
            sensitivity) options="--help --over --where --search --bins --by --records --figure --title --width --json --library" ;;
        esac
    fi
    if [[ ${COMP_WORDS[1]} == library ]]; then
        if ((COMP_CWORD == 2)); then
            COMPREPLY=($(compgen -W "add judge starter list show edit remove export import check fields words --help" -- "$word"))
            return
        fi
        case ${COMP_WORDS[2]} in
            add) options="--help --library --system --parts --materials --operation --recorded --denomination --preload --velocity --velocity-profile --temperature --humidity --sensor --calibration --date --author --licence --notes --case --figure --channel --full-scale --no-verdict --again --json" ;;
            judge) options="--help --library --where --search --channel --full-scale --all --json" ;;
            starter) options="--help --library --json" ;;
            list) options="--help --library --where --search --sort --columns --limit --json --csv" ;;
            show) options="--help --library --json --field --audio" ;;
            edit) options="--help --library --system --parts --materials --operation --recorded --denomination --preload --velocity --velocity-profile --temperature --humidity --sensor --calibration --date --author --licence --notes --case --figure" ;;
            remove) options="--help --library" ;;
            export) options="--help --library --where --search" ;;
            import) options="--help --library" ;;
            check) options="--help --library --repair" ;;
            fields) options="--help --library" ;;
            words) options="--help --library" ;;
        esac
    fi
    if [[ ${COMP_WORDS[1]} == structure ]]; then
        if ((COMP_CWORD == 2)); then
            COMPREPLY=($(compgen -W "info check reduce --help" -- "$word"))
            return
        fi
        case ${COMP_WORDS[2]} in
            info) options="--help --stiffness --mass --damping --labels --units --solver --json" ;;
            check) options="--help --stiffness --mass --damping --labels --units --solver --modes --contact --normal --friction --json" ;;
            reduce) options="--help --stiffness --mass --damping --labels --units --solver --boundary --recover --modes --below --normal --method --inertia --output --json" ;;
        esac
    fi
    if [[ ${COMP_WORDS[1]} == library && $word != -* ]]; then
        local field="" line place library=()
        for ((place = 2; place < COMP_CWORD; place++)); do
            [[ ${COMP_WORDS[place]} == --library ]] && library=(--library "${COMP_WORDS[place+1]}")
        done
        case $previous in
            --system|--parts|--materials|--operation|--recorded|--denomination|--sensor|--author|--licence) field=${previous#--} ;;
            --*) ;;
            *) [[ ${COMP_WORDS[2]} == @(show|edit|judge|remove) ]] && field=id ;;
        esac
        if [[ -n $field ]]; then
            COMPREPLY=()
            while IFS= read -r line; do
                [[ $line == "$word"* ]] && COMPREPLY+=("$(printf '%q' "$line")")
            done < <("${COMP_WORDS[0]}" library words "$field" "${library[@]}" 2>/dev/null)
            return
        fi
    fi
    if [[ $word == -* ]]; then
        COMPREPLY=($(compgen -W "$options" -- "$word"))
    else
        COMPREPLY=($(compgen -f -- "$word"))
        compopt -o filenames
    fi
}
complete -F _stridor stridor
