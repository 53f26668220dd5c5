"""The examples of the documentation do what they say."""

import doctest
import re

import pytest
from conftest import ROOT, needed

BLOCK = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
PAGES = ["docs/guide/python.md", "docs/guide/first-hour-researcher.md", "README.md"]


@pytest.mark.parametrize("page", PAGES)
def test_examples_of_a_page(page):
    needed("xarray"), needed("netCDF4"), needed("pandas"), needed("matplotlib").use("agg")
    text = (ROOT / page).read_text(encoding="utf-8")
    # all blocks of a page are one session
    session = "\n".join(block for block in BLOCK.findall(text) if ">>>" in block)
    assert session, f"{page} has no example"
    test = doctest.DocTestParser().get_doctest(session, {}, page, page, 0)
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
    runner.run(test)
    assert runner.failures == 0
