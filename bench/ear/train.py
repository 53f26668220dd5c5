"""Fits the ear of `stridor classify` and writes its numbers.

    python3 bench/ear/synthesise.py 150 FOLDER                 # 600 synthetic sounds with table.csv
    python3 bench/ear/train.py --clips FOLDER=TABLE.csv ... --synthetic FOLDER [--no-friction FOLDER=TABLE.csv] \
        [--degraded FOLDER] [--aside FOLDER=TABLE.csv ...] [--out src/stridor/classification/ear_weights.hpp]

TABLE.csv has the columns file, repository, label, expected ("squeak|creak") and confidence (high, low); files lie in
FOLDER by their last name, or as the table says. The figures come from `stridor classify --json`; the model is the
multinomial logistic regression of ear.hpp, with a quadratic penalty, in which rows of onsets argue for a creak more
than for anything else. A clip that may be several categories counts by the sum of their probabilities. Of the degraded
copies, those in two rooms are learnt from too. First the model is cross-validated: each repository is heard by a model
that has not met it, nor a copy of it. Then all is fitted. There is
no chance in it: the same clips give the same numbers.

Needs NumPy and SciPy (Debian: python3-scipy).
"""

import argparse
import csv
import json
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from scipy.optimize import minimize

import copies as same_sounds

HEARD = ["rubbing", "other", "squeal", "squeak", "creak"]
CATEGORIES = ["none", "squeal", "squeak", "creak"]
PENALTY = 8.0  # on the squares of the weights
NOISE = 4.5  # weight of a clip that is a noise, since there are five quiet ones to each
NO_FRICTION = 0.3  # weight of a clip that is no friction and has a tone or impulses: heavier ones hide noises
ROWS = {"train", "jerks", "joint_jerks"}  # figures of which the weight is greatest for a creak
LOW_CONFIDENCE = 0.5  # weight of a clip of which its label is not sure
SYNTHETIC = 0.5  # weight of all synthetic sounds over that of all clips
ROOMS, IN_A_ROOM = ["room_0.3_s", "room_0.8_s"], 0.3  # copies that are learnt from, and the weight of one
MOST_DEVIATIONS = 2.5  # as in ear.cpp
LEAST_SHARE, QUIET_DEPTH = 0.2, 25.0  # thresholds of the verdict of the whole
STANDING = {"train": ("row", 0.5), "tone_presence": ("line", 0.6)}  # figure: what stands in a sound from where on
RUBBING = re.compile(r"scrap|slid|drag|brush|sand|rubb|writ|eras|saw|zip|wip|plan|scratch", re.I)
CREAK = HEARD.index("creak")


def passages_of(program, path):
    run = subprocess.run([program, "classify", "--json", path], capture_output=True, text=True, check=True)
    document = json.loads(run.stdout)
    return document["channels"][document["channel"] - 1]["verdict"]["passages"]


def read_clips(program, folder, table, synthetic=False):
    with open(table, newline="") as text:
        rows = [dict(row, synthetic=synthetic) for row in csv.DictReader(text)]

    def path_of(row):
        whole = os.path.join(folder, row["file"])
        return whole if os.path.exists(whole) else os.path.join(folder, os.path.basename(row["file"]))

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        heard = pool.map(lambda row: passages_of(program, path_of(row)), rows)
    return [(row, passages) for row, passages in zip(rows, heard) if passages]


def accepted(row):
    """Which of HEARD a clip may be. Its label says whether its `none` is rubbing, unless it is known to be none."""
    result = np.zeros(len(HEARD))
    if row.get("no_friction"):
        result[1] = 1
        return result
    for word in row["expected"].split("|"):
        if word == "none":
            result[0 if RUBBING.search(row["label"]) else 1] = 1
        else:
            result[HEARD.index(word)] = 1
    return result


def design(clips, names):
    """Rows of figures, accepted outcomes, weights and clips, one per passage. A clip weighs one, shared by its
    passages' energy. A passage 3 dB below the loudest may be none, whatever the clip is."""
    figures, outcomes, weights, places = [], [], [], []
    for place, (row, passages) in enumerate(clips):
        energy = np.array([passage["energy"] for passage in passages])
        weight = LOW_CONFIDENCE if row["confidence"] == "low" else 1.0
        if not row["synthetic"] and "none" not in row["expected"].split("|"):
            weight *= NOISE
        if row.get("no_friction"):
            weight *= NO_FRICTION
        for passage, here in zip(passages, energy):
            share = here / max(energy.sum(), 1e-300)
            if share < 1e-3:
                continue
            outcome = accepted(row)
            if here < 0.5 * energy.max() and outcome[2:].any():
                outcome[:2] = 1
            figures.append([passage["figures"][name] for name in names])
            outcomes.append(outcome)
            weights.append(weight * share)
            places.append(place)
    return np.array(figures), np.array(outcomes), np.array(weights), np.array(places)


def softmax(sums):
    powers = np.exp(sums - sums.max(axis=1, keepdims=True))
    return powers / powers.sum(axis=1, keepdims=True)


class Model:
    def __init__(self, figures, outcomes, weights, names):
        self.mean = np.average(figures, axis=0, weights=weights)
        self.scale = np.sqrt(np.average((figures - self.mean) ** 2, axis=0, weights=weights))
        deviations = self.deviations(figures)
        shape = (figures.shape[1] + 1, len(HEARD))
        bounded = np.zeros(shape, bool)  # what a creak's weight exceeds another one's by, in place of that one
        bounded[[1 + names.index(name) for name in names if name in ROWS]] = True
        bounded[:, CREAK] = False

        def table_of(flat):
            table = flat.reshape(shape)
            return np.where(bounded, table[:, [CREAK]] - table, table)

        def loss(flat):
            table = table_of(flat)
            p = softmax(deviations @ table[1:] + table[0])
            likelihood = (p * outcomes).sum(axis=1) + 1e-12
            slope = (p - p * outcomes / likelihood[:, None]) * weights[:, None]
            gradient = np.vstack([slope.sum(axis=0), deviations.T @ slope + 2.0 * PENALTY * table[1:]])
            gradient[:, CREAK] += (gradient * bounded).sum(axis=1)
            gradient = np.where(bounded, -gradient, gradient)
            return -(weights * np.log(likelihood)).sum() + PENALTY * (table[1:] ** 2).sum(), gradient.ravel()

        options = {"maxiter": 5000, "ftol": 1e-12, "gtol": 1e-7}
        limits = [(0.0, None) if here else (None, None) for here in bounded.ravel()]
        found = minimize(loss, np.zeros(bounded.size), jac=True, method="L-BFGS-B", bounds=limits, options=options)
        self.table = table_of(found.x)

    def deviations(self, figures):
        return np.clip((figures - self.mean) / self.scale, -MOST_DEVIATIONS, MOST_DEVIATIONS)

    def probabilities(self, figures):
        """By category, shape [passage, 4]."""
        p = softmax(self.deviations(figures) @ self.table[1:] + self.table[0])
        return np.column_stack([p[:, 0] + p[:, 1], p[:, 2], p[:, 3], p[:, 4]])


def fitted(real, synthetic, names):
    figures, outcomes, weights = (np.concatenate([a, b]) for a, b in zip(real[:3], synthetic[:3]))
    weights[len(real[2]):] *= SYNTHETIC * real[2].sum() / synthetic[2].sum()
    return Model(figures, outcomes, weights, names)


def decide(probabilities, energy):
    """The category of a recording and its probability, as in recording_verdict.cpp."""
    category = probabilities.argmax(axis=1)
    category[energy < energy.max() * 10.0 ** (-QUIET_DEPTH / 10.0)] = 0
    shares = np.array([energy[category == c].sum() for c in range(4)]) / energy.sum()
    strongest = 1 + shares[1:].argmax()
    chosen = strongest if shares[strongest] >= LEAST_SHARE else 0
    heard_there = category == chosen
    return chosen, np.average(probabilities[heard_there, chosen], weights=energy[heard_there])


def with_copies(clips, copies, names):
    """Figures, outcomes, weights and repositories of clips and of lists of copies of them, by passage. The weights are
    scaled so that the penalty weighs as much as without copies."""
    lists = [clips, *copies]
    parts = [design(each, names) for each in lists]
    met = np.concatenate([np.array([row["repository"] for row, _ in each])[part[3]]
                          for each, part in zip(lists, parts)])
    weights = np.concatenate([part[2] * (IN_A_ROOM if k else 1.0) for k, part in enumerate(parts)])
    figures, outcomes = (np.concatenate([part[k] for part in parts]) for k in range(2))
    return figures, outcomes, weights / (1.0 + IN_A_ROOM * len(copies)), met


def cross_validated(clips, learnt, synthetic, names, others=()):
    """The verdicts on each clip by a model that has met no clip of its repository, nor a copy of one; likewise on lists
    of other clips of the same repositories, such as degraded copies. `learnt` is what with_copies returns."""
    figures, outcomes, weights, met = learnt
    repositories = np.array([row["repository"] for row, _ in clips])
    lists = [clips, *others]
    verdicts = [[None] * len(each) for each in lists]
    for repository in np.unique(repositories):
        known = met != repository
        model = fitted((figures[known], outcomes[known], weights[known]), synthetic, names)
        for each, said in zip(lists, verdicts):
            for place, (row, passages) in enumerate(each):
                if row["repository"] != repository:
                    continue
                p = model.probabilities(np.array([[one["figures"][name] for name in names] for one in passages]))
                said[place] = decide(p, np.array([one["energy"] for one in passages]))
    return verdicts


def standing(passages):
    """What stands in a recording, in its passages that are no background."""
    energy = np.array([passage["energy"] for passage in passages])
    heard = energy >= energy.max() * 10.0 ** (-QUIET_DEPTH / 10.0)
    return {what for figure, (what, least) in STANDING.items()
            if any(kept and one["figures"][figure] >= least for one, kept in zip(passages, heard))}


def quiet_shares(clips, verdicts):
    """How sure quiet is where a row or a line stands in the sound: the share of such verdicts that is right, with one
    right and one wrong one added (Laplace's rule)."""
    shares = {}
    for what, _ in STANDING.values():
        right = ["none" in row["expected"].split("|") for (row, passages), (category, _) in zip(clips, verdicts)
                 if category == 0 and what in standing(passages)]
        print(f"none where a {what} stands in the sound: {sum(right)} of {len(right)} right")
        shares[what] = (sum(right) + 1) / (len(right) + 2)
    return shares


def report(title, clips, verdicts):
    expected = [row["expected"].split("|") for row, _ in clips]
    heard = [CATEGORIES[category] for category, _ in verdicts]
    right = np.array([word in words for word, words in zip(heard, expected)])
    high = np.array([row["confidence"] == "high" for row, _ in clips])
    creak = np.array(["creak" in words and "none" not in words for words in expected])
    tone = np.array([set(words) <= {"squeal", "squeak"} for words in expected])
    single = np.array([words in (["squeal"], ["squeak"]) for words in expected])
    as_tone = np.array([word in ("squeal", "squeak") for word in heard])
    none = np.array([words == ["none"] for words in expected])

    def share(which):
        count = which.sum()
        return f"{right[which].sum()} of {count}" + (f" ({100 * right[which].mean():.0f} %)" if count else "")

    print(f"{title}: high confidence {share(high)}, all {share(right | ~right)}")
    print(f"  high confidence: creaks {share(high & creak)}, tones {share(high & tone)},"
          f" none {share(high & none)}; all: squeal against squeak, of those heard as tones: {share(single & as_tone)}")


def header(model, shares):
    def numbers(values):
        return ", ".join(repr(round(float(value), 4)) for value in values)

    rows = ",\n    ".join(f"std::array{{{numbers(model.table[1:, k])}}}" for k in range(len(HEARD)))
    count = model.table.shape[0] - 1
    standing_there = "\n".join(
        f"inline constexpr EarStanding ear_{what}{{{least}, {numbers([shares[what]])}}};  // {figure}"
        for figure, (what, least) in STANDING.items())
    return f"""#pragma once

#include <array>

/// The fitted numbers of the ear, by figure in the order of `ear_figures`, and by `EarOutcome`. bench/ear/train.py
/// writes this file.
namespace stridor::classification {{

/// What may stand in a sound that is heard as quiet.
struct EarStanding {{
    double least;  // [1] of its figure, from where on it stands there
    double right;  // [1] share of such verdicts that is right, by cross-validation over sources
}};
{standing_there}

inline constexpr std::array<double, {count}> ear_means{{{numbers(model.mean)}}};
inline constexpr std::array<double, {count}> ear_scales{{{numbers(model.scale)}}};
inline constexpr std::array<double, {len(HEARD)}> ear_biases{{{numbers(model.table[0])}}};
inline constexpr std::array<std::array<double, {count}>, {len(HEARD)}> ear_weights{{
    {rows},
}};

}}  // namespace stridor::classification
"""


def refuse_what_is_aside(learnt, aside):
    """Ends the program if a clip to learn from is one to check with: what was learnt is no test."""
    ones = [clip for pair in learnt for clip in same_sounds.clips_of(*pair.split("=", 1))] if aside else []
    others = [clip for pair in aside for clip in same_sounds.clips_of(*pair.split("=", 1))]
    found = list(same_sounds.copies(ones, others))
    for path, other, how in found:
        print(f"{path} is kept aside as {other} ({how})", file=sys.stderr)
    if found:
        sys.exit(f"{len(found)} of the clips to learn from are kept aside (what was learnt is no test). "
                 "Take them out of the table?")


def main():
    parser = argparse.ArgumentParser(description="Fits the ear and cross-validates it.")
    parser.add_argument("--program", default="build/stridor")
    parser.add_argument("--clips", action="append", required=True, metavar="FOLDER=TABLE.csv")
    parser.add_argument("--no-friction", action="append", default=[], metavar="FOLDER=TABLE.csv",
                        help="clips that are no friction, though they have a tone or impulses")
    parser.add_argument("--synthetic", required=True, metavar="FOLDER")
    parser.add_argument("--degraded", metavar="FOLDER",
                        help="copies by degrade.py, heard by the same models; those in rooms are learnt from")
    parser.add_argument("--aside", action="append", default=[], metavar="FOLDER=TABLE.csv",
                        help="clips kept aside to check with: a clip that is one of them, or a near copy, is refused")
    parser.add_argument("--out", metavar="FILE.hpp")
    options = parser.parse_args()
    pairs = [*options.clips, *options.no_friction]
    refuse_what_is_aside(pairs, options.aside)
    sets = [read_clips(options.program, *pair.split("=", 1)) for pair in pairs]
    none = {row["sha256"] for each in sets[len(options.clips):] for row, _ in each}
    made = read_clips(options.program, options.synthetic, os.path.join(options.synthetic, "table.csv"), True)
    names = list(made[0][1][0]["figures"])
    synthetic = design(made, names)[:3]
    clips = [clip for each in sets for clip in each]
    kinds = sorted(os.listdir(options.degraded)) if options.degraded else []
    copies = [read_clips(options.program, os.path.join(options.degraded, kind),
                         os.path.join(options.degraded, kind, "table.csv")) for kind in kinds]
    for row, _ in [clip for each in [clips, *copies] for clip in each]:
        row["no_friction"] = row["sha256"] in none
    learnt = with_copies(clips, [each for kind, each in zip(kinds, copies) if kind in ROOMS], names)
    verdicts, *of_copies = cross_validated(clips, learnt, synthetic, names, copies)
    first = 0
    for pair, each in zip(pairs, sets):
        report(pair, each, verdicts[first:first + len(each)])
        first += len(each)
    shares = None
    for kind, each, said in zip(["together", *kinds], [clips, *copies], [verdicts, *of_copies]):
        friction = [not row["no_friction"] for row, _ in each]
        of_friction = [[one for one, kept in zip(some, friction) if kept] for some in (each, said)]
        report(kind, *of_friction)
        shares = shares or quiet_shares(*of_friction)
    model = fitted(learnt[:3], synthetic, names)
    if options.out:
        with open(options.out, "w") as text:
            text.write(header(model, shares))


if __name__ == "__main__":
    main()
