# Written by python/tests/write_stubs.py: the sections of a case and the figures of a verdict.

from typing import Any, Dict, Union, overload

class Section:
    def __init__(self, case: Any, prefix: str) -> None: ...
    def __getattr__(self, name: str) -> Any: ...
    def __setattr__(self, name: str, value: object) -> None: ...
    def __getitem__(self, name: str) -> Any: ...

class Quantity:
    def __init__(self, name: str, document: str) -> None: ...
    @overload
    def __get__(self, section: None, owner: object = ...) -> Quantity: ...
    @overload
    def __get__(self, section: Section, owner: object = ...) -> float: ...
    def __set__(self, section: Section, value: Union[float, str]) -> None: ...

class Word(Quantity):
    def __init__(self, name: str, document: str) -> None: ...
    @overload  # type: ignore[override]
    def __get__(self, section: None, owner: object = ...) -> Word: ...
    @overload
    def __get__(self, section: Section, owner: object = ...) -> str: ...
    def __set__(self, section: Section, value: str) -> None: ...  # type: ignore[override]

class Joint(Section):
    mass: Quantity
    axial_stiffness: Quantity
    flexural_stiffness: Quantity
    axial_damping: Quantity
    flexural_damping: Quantity
    incidence_angle: Quantity
    stiffening: Word
    axial_cubic: Quantity
    flexural_cubic: Quantity
    axial_force: Word
    initial_tangential: Quantity
    initial_normal: Quantity
    initial_tangential_velocity: Quantity
    initial_normal_velocity: Quantity
    def __getitem__(self, name: str) -> Joint: ...

class Plate(Section):
    mass: Quantity
    stiffness: Quantity
    damping: Quantity
    initial_normal: Quantity
    initial_normal_velocity: Quantity
    def __getitem__(self, name: str) -> Plate: ...

class Structure(Section):
    stiffness_scale: Quantity
    damping_scale: Quantity
    spring_scale: Quantity
    mass: Quantity
    stiffness: Quantity
    damping_ratio: Quantity
    damping: Quantity
    coupling: Quantity
    frequency: Quantity
    impedance: Quantity
    length: Quantity
    bridge_resistance: Quantity
    position: Quantity
    mass_per_length: Quantity
    bending_stiffness: Quantity
    axial_stiffness: Quantity
    incidence_angle: Quantity
    def __getitem__(self, name: str) -> Structure: ...

class Contact(Section):
    preload: Quantity
    friction: Word
    static_friction: Quantity
    kinetic_friction: Quantity
    friction_slope: Quantity
    stribeck_velocity: Quantity
    stribeck_exponent: Quantity
    viscous_friction: Quantity
    bristle_stiffness: Quantity
    bristle_damping: Quantity
    direct_effect: Quantity
    evolution_effect: Quantity
    slip_length: Quantity
    reference_velocity: Quantity
    friction_table: Word
    interpolation: Word
    static_friction_coming: Quantity
    kinetic_friction_coming: Quantity
    regularisation: Quantity
    rest: Word
    rest_growth: Quantity
    rest_time: Quantity
    rest_exponent: Quantity
    initial_rest: Quantity
    pair: Word
    humidity: Quantity
    impact: Word
    restitution: Quantity
    initial_state: Word
    initial_friction_state: Quantity
    def __getitem__(self, name: str) -> Contact: ...

class Temperature(Section):
    value: Quantity
    def __getitem__(self, name: str) -> Temperature: ...

class Drive(Section):
    kind: Word
    amplitude: Quantity
    frequency: Quantity
    velocity: Quantity
    force: Quantity
    ramp: Quantity
    phase: Quantity
    file: Word
    def __getitem__(self, name: str) -> Drive: ...

class Run(Section):
    duration: Quantity
    window: Quantity
    initial: Word
    perturbation: Quantity
    engine: Word
    early_ending: Word
    step: Quantity
    formulation: Word
    massless_above: Quantity
    beta_2: Quantity
    def __getitem__(self, name: str) -> Run: ...

class Verdict(Section):
    start: Quantity
    settling: Quantity
    reversal: Quantity
    quiet_slip: Quantity
    creak_stick: Quantity
    least_releases: Quantity
    squeal_regularity: Quantity
    squeal_beats: Quantity
    squeal_repetition: Quantity
    squeal_frequency: Quantity
    least_intervals: Quantity
    lock_force: Quantity
    least_distance: Quantity
    creeping: Word
    creep_speed: Quantity
    def __getitem__(self, name: str) -> Verdict: ...

class Figures:
    _figures: Dict[str, float]
    def __init__(self, figures: Dict[str, float]) -> None: ...
    def __getattr__(self, name: str) -> float: ...
    @property
    def slip(self) -> float: ...
    @property
    def stick(self) -> float: ...
    @property
    def separation(self) -> float: ...
    @property
    def judged_slip(self) -> float: ...
    @property
    def judged_stick(self) -> float: ...
    @property
    def judged_separation(self) -> float: ...
    @property
    def regularity(self) -> float: ...
    @property
    def repetition(self) -> float: ...
    @property
    def variation(self) -> float: ...
    @property
    def intervals(self) -> float: ...
    @property
    def releases(self) -> float: ...
    @property
    def lag(self) -> float: ...
    @property
    def period(self) -> float: ...
    @property
    def frequency(self) -> float: ...
    @property
    def preload(self) -> float: ...
    @property
    def largest_normal_force(self) -> float: ...
    @property
    def drag_from(self) -> float: ...
    @property
    def drag_to(self) -> float: ...
    @property
    def drag_way(self) -> float: ...
    @property
    def drag_slope(self) -> float: ...
    @property
    def joint_rms(self) -> float: ...
    @property
    def joint_peak(self) -> float: ...
    @property
    def joint_level(self) -> float: ...
    @property
    def joint_peak_level(self) -> float: ...
    @property
    def plate_rms(self) -> float: ...
    @property
    def plate_peak(self) -> float: ...
    @property
    def plate_level(self) -> float: ...
    @property
    def plate_peak_level(self) -> float: ...
