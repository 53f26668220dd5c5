"""The core modules, and which tests must notice a fault in each: its own and those of the modules that use it."""

ENGINE = ["integration_test", "law_contract_test", "engine_contract_test", "verification_test"]
CELLS = [
    "sweep_test", "sweep_diagram_test", "sweep_following_test", "sweep_strokes_test", "advice_test", "hearing_test"
]

# The only list; `./dev coverage` and `./dev mutate` read it. Targets of CMake, in any order.
CORE = {
    "model": ["model_test", *ENGINE, "analysis_test"],
    "integration": [*ENGINE, "analysis_test"],
    "analysis": ["analysis_test", "classification_test", "engine_contract_test", *CELLS],
    "classification": ["classification_test", *CELLS],
    "sweep": CELLS,
    "advice": ["advice_test", "verification_advice_test"],
    "hearing": ["hearing_test"],
}

# It holds every result's bits, and so notices what moves any of them; it cannot say what is wrong.
GOLDEN = "golden_test"
