"""What a user writes, with types: `mypy --strict` looks at it, and a test runs it."""

from typing import Dict, List

import numpy

import stridor


def louder(case: stridor.Case, preloads: List[float]) -> Dict[float, float]:
    """The velocity level of the joint for each preload [dB re 1e-9 m/s]."""
    levels: Dict[float, float] = {}
    for preload in preloads:
        case.contact.preload = preload
        motion: stridor.Motion = stridor.simulate(case)
        levels[preload] = motion.going.joint_level
    return levels


def main() -> None:
    case = stridor.case("squeal")
    case.contact.preload = "20 N"
    kind: str = case.drive.kind
    frequency: float = stridor.simulate(case).going.frequency
    print(kind, frequency, stridor.simulate(case).going.verdict.category, louder(case, [10.0, 20.0]))
    doe = stridor.evaluate(case, {"contact.preload": numpy.geomspace(5, 50, 3)}, directions=["going"])
    print(list(doe.category.values[0]))
    chart = stridor.chart(stridor.case("noise-chart"), x=stridor.axis("preload", 2, "4 kN", 3, scale="log"),
                          y=stridor.axis("mu_d", 0.1, 0.8, 3))
    counts: Dict[str, int] = chart.counts("going")
    cell: stridor.Case = chart.case_at(preload=900, kinetic_friction=0.5)
    print(counts, cell.text("contact.preload"), [line.first for line in chart.boundaries()])
    try:
        case.contact.kinetic_friction = 0.9
    except stridor.InputError as error:
        print(error.what, error.why, error.suggestion, error.place)


if __name__ == "__main__":
    main()
