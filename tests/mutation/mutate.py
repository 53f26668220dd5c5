#!/usr/bin/env python3
"""Seeds single mutations into the core modules and counts those that the tests notice.

Usage: mutate.py [N] [--seed S] [--build FOLDER]. N mutants (default 100), the same ones for a seed: an operator, a
comparison, a sign or a constant of a line changes. Each is compiled with the tests of its module and those that use
it, which then run. Killed is a mutant that a test fails for, or that runs ten times as long as it should; one that
does not compile counts for nothing, and another takes its place. The source is put back whatever happens.

Works on a copy of the sources of its own (FOLDER/source), so that an interruption leaves the checkout as it was.
"""

import argparse
import pathlib
import random
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]

# the tests of a module, and those that use it, from the quick to the slow; targets, which are executables
TESTS = {
    "model": ["model_test", "law_contract_test", "integration_test", "verification_test", "golden_test"],
    "integration": ["integration_test", "law_contract_test", "engine_contract_test", "verification_test",
                    "golden_test"],
    "analysis": ["analysis_test", "classification_test", "verification_test", "golden_test"],
    "classification": ["classification_test", "sweep_test", "golden_test"],
    "sweep": ["sweep_test", "advice_test", "sweep_diagram_test", "golden_test"],
}

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


def sites(text: str):
    """Places of a source where a mutation fits: (begin, end, replacements). Comments, includes and strings are left."""
    begin = 0
    for line in text.splitlines(keepends=True):
        code = line.split("//")[0]
        skip = code.lstrip().startswith(("#", "*", "/*", "template", "using", "static_assert", "STRIDOR_E"))
        if not skip and '"' not in code and "operator" not in code:
            for pattern, replacements in SWAPS:
                for match in pattern.finditer(code):
                    new = replacements
                    if new == ["constant"]:
                        value = float(match[1])
                        new = ["1.0" if value == 0.0 else repr(1.5 * value)]
                    yield begin + match.start(1), begin + match.end(1), new
        begin += len(line)


def candidates():
    found = []
    for module in TESTS:
        for path in sorted((ROOT / "src/stridor" / module).rglob("*")):
            if path.suffix in (".cpp", ".hpp", ".inl"):
                relative = path.relative_to(ROOT)
                found += [(module, relative, *site) for site in sites(path.read_text())]
    return found


class Workshop:
    """A copy of the checkout with its build, in which sources may change."""

    def __init__(self, folder: pathlib.Path):
        self.source = folder / "source"
        self.build = folder / "build"
        self.source.mkdir(parents=True, exist_ok=True)
        listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                                check=True, capture_output=True, text=True).stdout
        for name in filter(None, listed.split("\0")):
            origin, copy = ROOT / name, self.source / name
            if not origin.is_file():
                continue
            if not copy.exists() or copy.read_bytes() != origin.read_bytes():
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(origin, copy)
        # unoptimised, source by source: a mutant costs its own compilation and the links
        subprocess.run(["cmake", "-S", self.source, "-B", self.build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug",
                        "-DCMAKE_CXX_FLAGS_DEBUG=-O1", "-DSTRIDOR_CHECKS=OFF", "-DSTRIDOR_PAGE=OFF"],
                       check=True, stdout=subprocess.DEVNULL)
        help_text = subprocess.run(["ninja", "-C", self.build, "-t", "targets", "all"], check=True,
                                   capture_output=True, text=True).stdout
        self.programs = {pathlib.PurePath(line.split(":")[0]).name: line.split(":")[0]
                         for line in help_text.splitlines() if re.match(r"\S+_test: phony|tests/\S+_test: CXX", line)
                         and "/" in line.split(":")[0]}
        self.seconds: dict[str, float] = {}

    def tests(self, module: str) -> list[str]:
        return [name for name in TESTS[module] if name in self.programs]

    def compiles(self, names: list[str]) -> bool:
        return subprocess.run(["ninja", "-C", self.build, *names], capture_output=True).returncode == 0

    def passes(self, name: str) -> bool:
        """Runs a test; the first time, on the unchanged source, it also says how long that takes."""
        began = time.monotonic()
        limit = 10.0 * self.seconds[name] + 10.0 if name in self.seconds else None
        try:
            done = subprocess.run([self.build / self.programs[name], "--gtest_brief=1", "--gtest_fail_fast"],
                                  cwd=self.build, capture_output=True, timeout=limit)
        except subprocess.TimeoutExpired:
            return False
        self.seconds.setdefault(name, time.monotonic() - began)
        return done.returncode == 0


def main() -> int:
    parser = argparse.ArgumentParser(description="counts the seeded mutants that the tests notice")
    parser.add_argument("mutants", nargs="?", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--module", choices=list(TESTS), help="only this one")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build-mutants")
    options = parser.parse_args()

    found = [c for c in candidates() if options.module in (None, c[0])]
    random.Random(options.seed).shuffle(found)
    shop = Workshop(options.build.resolve())
    modules = [options.module] if options.module else list(TESTS)
    names = sorted({name for module in modules for name in shop.tests(module)})
    if not shop.compiles(names):
        sys.exit("the unchanged sources do not compile")
    for name in names:
        if not shop.passes(name):
            sys.exit(f"{name} fails without a mutant")

    killed, survivors = 0, []
    for k, (module, path, begin, end, replacements) in enumerate(found):
        if killed + len(survivors) == options.mutants:
            break
        file = shop.source / path
        text = (ROOT / path).read_text()
        new = random.Random(f"{options.seed}-{k}").choice(replacements)
        file.write_text(text[:begin] + new + text[end:])
        line = text.count("\n", 0, begin) + 1
        what = f"{path}:{line}: {text[begin:end]} -> {new or 'nothing'}"
        try:
            if not shop.compiles(shop.tests(module)):
                print(f"does not compile  {what}", flush=True)
                continue
            noticed = next((name for name in shop.tests(module) if not shop.passes(name)), None)
        finally:
            file.write_text(text)
        if noticed:
            killed += 1
            print(f"killed            {what} [{noticed}]", flush=True)
        else:
            survivors.append(what)
            print(f"SURVIVED          {what}", flush=True)

    total = killed + len(survivors)
    print(f"{killed} of {total} mutants killed, {len(found)} places known, seed {options.seed}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
