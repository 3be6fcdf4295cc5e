# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The documentation builds without a warning, its links lead somewhere, its tables are what the programs say."""

import re
import subprocess
import sys

import pytest
from conftest import ROOT, pages


@pytest.fixture(scope="session")
def built(tmp_path_factory):
    output = tmp_path_factory.mktemp("docs")
    run = subprocess.run([ROOT / "docs/build.sh", output], capture_output=True, text=True, timeout=600)
    assert run.returncode == 0, run.stdout + run.stderr
    return output


def test_every_page_is_in_the_html(built):
    for page in pages():
        if page.parent == ROOT / "docs" or "algorithms" in page.parts:
            html = built / "html" / page.relative_to(ROOT / "docs").with_suffix(".html")
            assert html.exists(), f"{page} is in no toctree"


def test_links_and_pictures_of_the_html_exist(built):
    missing = []
    for page in (built / "html").rglob("*.html"):
        text = page.read_text()
        for target in re.findall(r'(?:href|src)="([^"]+)"', text):
            path, _, anchor = target.partition("#")
            if "://" in path or path.startswith(("mailto:", "data:")):
                continue
            file = (page.parent / path.split("?")[0]).resolve() if path else page
            if file.is_dir():
                file = file / "index.html"
            if not file.exists():
                missing.append(f"{page.name}: {target}")
            elif anchor and file.suffix == ".html" and f'id="{anchor}"' not in file.read_text():
                missing.append(f"{page.name}: {target}")
    assert not missing, missing


@pytest.mark.parametrize("page", pages(), ids=lambda page: str(page.relative_to(ROOT)))
def test_links_between_the_sources_exist(page):
    """So that they also work where the sources are read, in the repository."""
    for target in re.findall(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", re.sub(r"```.*?```", "", page.read_text(), flags=re.S)):
        if "://" not in target:
            assert (page.parent / target).exists(), f"{page.name} links to {target}"


def test_option_tables_are_what_the_programs_say():
    run = subprocess.run(
        [sys.executable, ROOT / "docs/make_reference.py", "--check"], capture_output=True, text=True
    )
    assert run.returncode == 0, run.stdout + run.stderr


@pytest.mark.parametrize("name", ["gdal2qmesh", "qmeshinfo"])
def test_man_pages_render(built, name):
    page = built / "man" / f"{name}.1"
    run = subprocess.run(["man", "--warnings", "-l", page], capture_output=True, text=True,
                         env={"MANWIDTH": "100", "PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8"})
    assert run.returncode == 0
    for word in (name, {"gdal2qmesh": "--max-error", "qmeshinfo": "--validate"}[name], "EXIT CODES"):
        assert word in run.stdout
    assert "troff:" not in run.stderr, run.stderr
