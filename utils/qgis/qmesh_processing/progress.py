# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
"""Reads what the commands print. Knows nothing of QGIS."""

import codecs

# "0...10...20 ... 100": three dots between two tens, a tick each 2.5 %.
_PIECES = [str(tick // 4 * 10) if tick % 4 == 0 else "." for tick in range(41)]
LINE = "".join(_PIECES)
_ENDS = {}
for _tick, _piece in enumerate(_PIECES):
    _ENDS[len("".join(_PIECES[: _tick + 1]))] = 2.5 * _tick


class LineReader:
    """One stream of a command, in pieces of any size: `progress(percent)` as the line of GDAL's kind grows,
    `warning(text)` for lines "NAME: warning: text", `other(text)` for other lines; errors are kept in `errors`. The
    usage line before a usage error is dropped."""

    def __init__(self, progress, warning, other):
        self._progress = progress
        self._warning = warning
        self._other = other
        self._open = ""
        self._decoder = codecs.getincrementaldecoder("utf-8")("replace")
        self._percent = -1.0
        self.errors = []

    def feed(self, data):
        self._open += self._decoder.decode(bytes(data))
        while "\n" in self._open:
            text, self._open = self._open.split("\n", 1)
            self._take(text.rstrip("\r"))
            self._percent = -1.0
        self._is_progress(self._open)

    def finish(self):
        """A last line without a line end."""
        if self._open:
            self._take(self._open)
        self._open = ""

    def _take(self, text):
        _, is_error, error = text.partition(": error: ")
        _, is_warning, warning = text.partition(": warning: ")
        if self._is_progress(text):
            return
        if is_error:
            self.errors.append(error)
        elif is_warning:
            self._warning(warning)
        elif text and not text.startswith("usage: "):
            self._other(text)

    def _is_progress(self, text):
        """Tells the progress that a line, whole or not, stands for; False where it is another line, "0 errors" say."""
        ticks, _, rest = text.partition(" ")
        if not ticks.startswith("0.") or not LINE.startswith(ticks) or not "- done.".startswith(rest):
            return False
        percent = max(p for end, p in _ENDS.items() if end <= len(ticks))
        if percent > self._percent:
            self._percent = percent
            self._progress(percent)
        return True
