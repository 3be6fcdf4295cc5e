# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""The tree keeps the rules of rules.py, and each rule finds a fault that is put in on purpose."""

import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess

import pytest

import rules
from tree import ROOT, Tree


@pytest.fixture(scope="session")
def tree():
    return Tree(ROOT)


@pytest.fixture
def copy(tmp_path):
    for name in ("common", "driver", "utils"):
        shutil.copytree(ROOT / name, tmp_path / name, ignore=shutil.ignore_patterns("__pycache__"))
    return Tree(tmp_path)


def put(tree, path, text):
    (tree.root / path).write_text(text, encoding="utf-8")


@pytest.mark.parametrize("rule", rules.ALL, ids=lambda rule: rule.__name__)
def test_the_tree_keeps_the_rule(tree, rule):
    faults = rule(tree)
    assert not faults, "\n".join(faults)


def test_the_include_matrix(tree, capsys):
    with capsys.disabled():
        print("\n" + rules.matrix_table(tree))
    assert {"base", "tiling", "simplify", "source", "sink"} <= rules.matrix(tree)[pathlib.Path("common/pyramid")]


# ---- Faults put in on purpose -----------------------------------------------------------------------


def test_an_upward_include_is_found(copy):
    put(copy, "common/base/upward.h", '#pragma once\n#include "pyramid/report.h"\n')
    assert any("upward.h" in fault and "pyramid is above base" in fault for fault in rules.upward_includes(copy))


def test_a_header_of_a_folder_that_is_not_linked_is_found(copy):
    put(copy, "common/run/only_header.h", '#pragma once\n#include "geo/vec3.h"\n')
    assert rules.unlinked_includes(copy) == ["common/run includes geo/ but its CMakeLists.txt does not depend on it"]


def test_a_second_type_of_one_name_is_found(copy):
    put(copy, "common/mesh/second.h", "namespace qmesh {\nclass NodePositions {\n};\n}\n")
    assert any(fault.startswith("NodePositions ") for fault in rules.repeated_types(copy))


def test_a_type_in_an_anonymous_namespace_is_its_own(copy):
    put(copy, "common/mesh/second.cpp", "namespace qmesh {\nnamespace {\nclass NodePositions {\n};\n}\n}\n")
    assert not rules.repeated_types(copy)


def test_a_foreign_header_in_the_wrong_folder_is_found(copy):
    put(copy, "common/mesh/second.h", "#pragma once\n#include <gdal_priv.h>\n#include <CGAL/Surface_mesh.h>\n")
    assert len(rules.foreign_headers(copy)) == 2


def test_a_long_function_and_a_long_file_are_found(copy):
    put(copy, "common/mesh/second.cpp", "void f() {\n" + "  g();\n" * 61 + "}\n" + "\n" * 340)
    assert rules.long_functions(copy) == ["common/mesh/second.cpp:1: a function of 61 lines; at most 60"]
    assert rules.long_files(copy) == ["common/mesh/second.cpp has 403 lines; at most 400"]


def test_a_crowded_folder_is_found(copy):
    for k in range(41):
        put(copy, f"common/geo/file_{k}.h", "#pragma once\n")
    assert any(fault.startswith("common/geo holds") for fault in rules.crowded_folders(copy))


def test_an_installed_header_with_a_private_one_is_found(copy):
    put(copy, "common/codec/second.h", '#pragma once\n#include "codec/json_reading.h"\n')
    assert any("second.h" in fault for fault in rules.private_headers(copy))


# ---- Tools ------------------------------------------------------------------------------------------


def unformatted(files):
    """Those of the files that clang-format would change."""
    done = subprocess.run(["clang-format", "--dry-run", "--ferror-limit=1", *map(str, files)], capture_output=True,
                          text=True, check=True)
    return sorted(set(re.findall(r"^(.*?):\d+:\d+: warning: code should be clang-formatted", done.stderr, re.M)))


def test_clang_format_is_the_one_the_tree_is_formatted_with():
    text = subprocess.run(["clang-format", "--version"], capture_output=True, text=True, check=True).stdout
    assert " version 14." in text, f"the files are formatted by clang-format 14, this is: {text}"


def test_every_file_is_formatted(tree):
    files = [tree.root / path for path in tree.files("common", "driver", "utils", "autotest")]
    assert unformatted(files) == []


def test_an_unformatted_file_is_found(tmp_path):
    shutil.copy(ROOT / ".clang-format", tmp_path)
    file = tmp_path / "second.cpp"
    file.write_text("int  f( ){return 1;}\n", encoding="utf-8")
    assert unformatted([file]) == [str(file)]


# ---- Headers that are installed ---------------------------------------------------------------------


@pytest.fixture(scope="session")
def installed(tmp_path_factory):
    """The headers as `cmake --install` lays them out."""
    folder = tmp_path_factory.mktemp("include")
    folders = [path.name for path in (ROOT / "common").iterdir() if path.is_dir()]
    subprocess.run(["cmake", "-D", f"folders={';'.join(folders)}", "-D", f"source={ROOT / 'common'}", "-D",
                    f"staging={folder / 'staging'}", "-D", f"destination={folder / 'qmesh'}", "-P",
                    ROOT / "cmake" / "InstallHeaders.cmake"], check=True, capture_output=True)
    return folder


def gdal_flags():
    done = subprocess.run(["gdal-config", "--cflags"], capture_output=True, text=True, check=True)
    return done.stdout.split()


def compile_alone(folder, header):
    """What the compiler says to a file that includes nothing but this header."""
    done = subprocess.run(["c++", "-std=c++17", "-fsyntax-only", "-Wall", "-Wextra", f"-I{folder}", *gdal_flags(), "-x",
                           "c++", "-"], input=f"#include <{header.relative_to(folder)}>\n", capture_output=True,
                          text=True, check=False)
    return done.stderr if done.returncode != 0 else ""


def test_every_installed_header_compiles_alone(installed):
    headers = sorted((installed / "qmesh").rglob("*.h"))
    assert len(headers) > 50
    assert not [h for h in headers if h.name == "json_reading.h"]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        faults = list(pool.map(lambda header: compile_alone(installed, header), headers))
    assert not any(faults), "\n".join(fault for fault in faults if fault)
