#!/usr/bin/env python3
"""Seeds single faults into the core modules and counts those that the tests notice.

An operator, a comparison, a sign or a constant of one line changes. The tests of the module and of those that use it
are linked and run one by one, the quickest first and the golden results last, until one fails. A mutant is also killed
when a test takes ten times the processor time that it should. One that does not compile counts for nothing; another
takes its place.

Works on a copy of the sources (BUILD/source): an interruption leaves the checkout as it was. A seed gives the same
mutants while their lines stay the same.
"""

import argparse
import collections
import hashlib
import os
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import time
from typing import NamedTuple

from core import CORE, GOLDEN

ROOT = pathlib.Path(__file__).resolve().parents[2]
MEMORY = 8 << 30  # [byte] that a test may take: a loop that a mutant made endless must not take the machine's
PATIENCE = 900.0  # [s] that a test may take on a busy machine: a thread may wait for ever and take no processor time

# what may stand for what; each pattern takes one group
SWAPS = [
    (re.compile(r" (\+) "), ["-"]),
    (re.compile(r" (-) "), ["+"]),
    (re.compile(r" (\*) "), ["/"]),
    (re.compile(r" (/) "), ["*"]),
    (re.compile(r" (<) "), ["<=", ">"]),
    (re.compile(r" (>) "), [">=", "<"]),
    (re.compile(r" (<=) "), ["<", ">"]),
    (re.compile(r" (>=) "), [">", "<"]),
    (re.compile(r" (==) "), ["!="]),
    (re.compile(r" (!=) "), ["=="]),
    (re.compile(r" (&&) "), ["||"]),
    (re.compile(r" (\|\|) "), ["&&"]),
    (re.compile(r" (\+=) "), ["-="]),
    (re.compile(r" (-=) "), ["+="]),
    (re.compile(r"[(=,] ?(-)(?=\w)"), [""]),  # a sign
    (re.compile(r"(?<![\w.])(\d+\.\d+(?:e-?\d+)?)(?![\w.])"), ["constant"]),
]


class Mutant(NamedTuple):
    rank: str  # a number that it keeps while its line stays in its file
    module: str
    path: pathlib.Path  # below the root
    begin: int  # where in its text
    end: int
    new: str
    line: int  # its number


def places(text: str):
    """Where a mutation fits: (number of the line, its begin, begin and end in it, replacements). Not in comments,
    includes, strings."""
    begin = 0
    for number, line in enumerate(text.splitlines(keepends=True), 1):
        code = line.split("//")[0]
        skip = code.lstrip().startswith(("#", "*", "/*", "template", "using", "static_assert", "STRIDOR_E"))
        if not skip and '"' not in code and "operator" not in code:
            for pattern, replacements in SWAPS:
                for match in pattern.finditer(code):
                    new = replacements
                    if new == ["constant"]:
                        value = float(match[1])
                        new = ["1.0" if value == 0.0 else f"{1.5 * value:.17g}"]
                    yield number, begin, *match.span(1), new
        begin += len(line)


def mutants(seed: int) -> list[Mutant]:
    """One for each place, in the order of the seed. A line that moves with its file to another folder keeps its own."""
    found = []
    seen: collections.Counter = collections.Counter()
    for module in CORE:
        for path in sorted((ROOT / "src/stridor" / module).rglob("*")):
            if path.suffix not in (".cpp", ".hpp", ".inl"):
                continue
            text = path.read_text()
            for number, begin, first, last, new in places(text):
                line = text[begin:].partition("\n")[0]
                name = f"{seed} {path.name} {line.strip()} {first - len(line) + len(line.lstrip())}"
                seen[name] += 1
                rank = hashlib.sha256(f"{name} {seen[name]}".encode()).hexdigest()
                found.append(Mutant(rank[:8], module, path.relative_to(ROOT), begin + first, begin + last,
                                    new[int(rank, 16) % len(new)], number))
    return sorted(found)


class Workshop:
    """A copy of the checkout with its build, in which sources may change."""

    def __init__(self, folder: pathlib.Path, jobs: str):
        self.source = folder / "source"
        self.build = folder / "build"
        self.jobs = jobs
        self.seconds: dict[str, float] = {}  # of processor time that each test takes without a fault
        listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                                check=True, capture_output=True, text=True).stdout
        wanted = {name for name in listed.split("\0") if name and (ROOT / name).is_file()}
        for name in wanted:
            origin, copy = ROOT / name, self.source / name
            if not copy.exists() or copy.read_bytes() != origin.read_bytes():
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(origin, copy)
        # source by source, so that a mutant costs its own compilation and some links
        subprocess.run(["cmake", "-S", self.source, "-B", self.build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug",
                        "-DCMAKE_CXX_FLAGS_DEBUG=-O1", "-DSTRIDOR_CHECKS=OFF"], check=True, stdout=subprocess.DEVNULL)

    def compiles(self, *targets: str) -> bool:
        return subprocess.run(["ninja", "-C", self.build, "-j", self.jobs, *targets],
                              capture_output=True).returncode == 0

    def passes(self, target: str) -> bool:
        """Runs a test. The first time, on the unchanged sources, it also learns how long that takes."""
        program = next(path for path in self.build.glob(f"tests/**/{target}") if path.is_file())
        most = int(10.0 * self.seconds[target] + 10.0) if target in self.seconds else resource.RLIM_INFINITY
        before = os.times()

        def limit():
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
            resource.setrlimit(resource.RLIMIT_CPU, (most, most))

        try:
            done = subprocess.run([program, "--gtest_brief=1", "--gtest_fail_fast"], cwd=self.build, timeout=PATIENCE,
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=limit)
        except subprocess.TimeoutExpired:
            return False
        after = os.times()
        self.seconds.setdefault(target, after.children_user + after.children_system - before.children_user -
                                before.children_system)
        return done.returncode == 0

    def tests(self, module: str) -> list[str]:
        return [*sorted(CORE[module], key=self.seconds.__getitem__), GOLDEN]

    def fate(self, module: str) -> str:
        """What becomes of the mutant in the sources: `does not compile`, the test that kills it, or `SURVIVED`."""
        if not self.compiles("stridor_" + module):
            return "does not compile"
        for target in self.tests(module):
            if not self.compiles(target):
                return "does not compile"
            if not self.passes(target):
                return target
        return "SURVIVED"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mutants", nargs="?", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--skip", type=int, default=0, metavar="N", help="begin after the first N of the seed")
    parser.add_argument("--only", nargs="+", metavar="K", help="only the mutants of these numbers")
    parser.add_argument("--list", action="store_true", help="print them and do nothing")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build-mutants")
    options = parser.parse_args()

    known = mutants(options.seed)
    chosen = [mutant for mutant in known if not options.only or mutant.rank in options.only][options.skip:]
    shop = None
    if not options.list:
        began = time.monotonic()
        shop = Workshop(options.build.resolve(), os.environ.get("STRIDOR_JOBS", str(os.cpu_count())))
        targets = sorted({GOLDEN, *(target for tests in CORE.values() for target in tests)})
        if not shop.compiles(*targets):
            sys.exit("the sources do not compile without a mutant")
        for target in targets:
            if not shop.passes(target):
                sys.exit(f"{target} fails without a mutant")
        print(f"built in {time.monotonic() - began:.0f} s", flush=True)

    began = time.monotonic()
    fates: dict[str, int] = {}
    counted = 0
    for mutant in chosen:
        if counted == options.mutants:
            break
        text = (ROOT / mutant.path).read_text()
        what = (f"{mutant.rank}  {mutant.path}:{mutant.line}: `{text[mutant.begin:mutant.end]}` becomes "
                f"`{mutant.new}`")
        if options.list:
            print(what)
            counted += 1
            continue
        file = shop.source / mutant.path
        try:
            file.write_text(text[:mutant.begin] + mutant.new + text[mutant.end:])
            fate = shop.fate(mutant.module)
        finally:
            file.write_text(text)
        fates[fate] = fates.get(fate, 0) + 1
        counted += fate != "does not compile"
        print(f"{time.monotonic() - began:5.0f} s  {fate:<22} {what}", flush=True)
    if not options.list:
        print(f"{counted - fates.get('SURVIVED', 0)} of {counted} mutants killed, {fates.get(GOLDEN, 0)} of them by "
              f"{GOLDEN} alone; {fates.get('does not compile', 0)} more do not compile; {len(known)} places known, "
              f"seed {options.seed}; {time.monotonic() - began:.0f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
