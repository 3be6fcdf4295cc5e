# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Fixtures of the QGIS tests: qgis_process and QGIS itself, without a screen, in a home of their own.

QMESH_BUILD  the build folder with bin/, gdalplugins/ and qgis/plugins/ (default build of this tree)
"""

import os
import pathlib
import subprocess
import sys
import tempfile

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("QMESH_BUILD", ROOT / "build"))
DEM = ROOT / "data" / "jacksboro_srtm3.tif"
PLUGINS = BUILD / "qgis" / "plugins"
HOME = tempfile.TemporaryDirectory(prefix="qmesh-qgis-")

# Before anything of QGIS is imported.
(pathlib.Path(HOME.name) / "run").mkdir(mode=0o700)
os.environ.update(
    HOME=HOME.name,
    XDG_RUNTIME_DIR=HOME.name + "/run",
    QT_QPA_PLATFORM="offscreen",
    QGIS_PLUGINPATH=str(PLUGINS),
    PATH=f"{BUILD / 'bin'}{os.pathsep}{os.environ['PATH']}",
    PYTHONDONTWRITEBYTECODE="1",
)
for name in ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "GDAL_DRIVER_PATH"):
    os.environ.pop(name, None)
for folder in (PLUGINS, ROOT / "autotest"):
    sys.path.insert(0, str(folder))


class Process:
    """A finished qgis_process."""

    def __init__(self, done):
        self.code = done.returncode
        self.text = done.stdout.decode() + done.stderr.decode()
        self.results = {}
        _, _, results = done.stdout.decode().partition("Results\n")
        for line in results.splitlines():
            name, tab, value = line.partition(":\t")
            if tab:
                self.results[name] = value

    def succeeded(self):
        assert self.code == 0, self.text
        return self.results

    def failed(self, *words):
        assert self.code != 0, self.text
        for word in words:
            assert word in self.text, f"no {word!r} in: {self.text}"
        assert "Traceback" not in self.text, self.text


def qgis_process(*arguments, environment=None):
    done = subprocess.run(
        ["qgis_process.bin", *map(str, arguments)], stdin=subprocess.DEVNULL, capture_output=True, timeout=300,
        env={**os.environ, **(environment or {})}, check=False,
    )
    return Process(done)


@pytest.fixture(scope="session")
def enabled():
    """The plugin is enabled for every qgis_process of this session."""
    qgis_process("plugins", "enable", "qmesh_processing").succeeded()


@pytest.fixture(scope="session")
def run_process(enabled):
    """A function (algorithm, NAME=value...) -> Process of `qgis_process run`."""

    def run(algorithm, environment=None, **parameters):
        words = [f"{name}={value}" for name, value in parameters.items()]
        return qgis_process("run", algorithm, "--", *words, environment=environment)

    return run


def start_qgis(window=False):
    """QGIS with our plugin in this process: the application and the plugin."""
    from qgis.core import QgsApplication

    application = QgsApplication([], window)
    application.initQgis()
    sys.path.append(os.path.join(QgsApplication.pkgDataPath(), "python", "plugins"))
    from processing.core.Processing import Processing

    Processing.initialize()
    from qmesh_processing.plugin import QmeshPlugin

    plugin = QmeshPlugin(None)
    plugin.initProcessing()
    return application, plugin


@pytest.fixture(scope="session")
def qgis():
    application, plugin = start_qgis()
    yield application
    plugin.unload()


@pytest.fixture
def setting(qgis):
    """A function (name, value) that sets an option of the provider for one test."""
    from processing.core.ProcessingConfig import ProcessingConfig
    from qmesh_processing import places

    yield ProcessingConfig.setSettingValue
    for name in places.SETTINGS:
        ProcessingConfig.setSettingValue(name, "")


@pytest.fixture
def feedback(qgis):
    """Keeps what an algorithm says."""
    from qgis.core import QgsProcessingFeedback

    class Feedback(QgsProcessingFeedback):
        def __init__(self):
            super().__init__(False)
            self.warnings, self.lines, self.percents = [], [], []

        def setProgress(self, percent):
            # The signal would wait for this thread's event loop.
            self.percents.append(percent)
            super().setProgress(percent)

        def pushWarning(self, text):
            self.warnings.append(text)

        def pushConsoleInfo(self, text):
            self.lines.append(text)

        pushCommandInfo = pushInfo = pushConsoleInfo

    return Feedback()
