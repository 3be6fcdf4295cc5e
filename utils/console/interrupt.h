// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

namespace qmesh {

/// Takes over the signals of the process, once, before threads start: SIGINT (Ctrl-C), SIGTERM and
/// SIGHUP (the terminal is closed) ask for a clean stop; another one more than a second later ends
/// the process at once with exit code 3. SIGXFSZ and SIGPIPE are ignored, so that a full file or a
/// closed pipe is a failed write with a message.
void installSignalHandlers();

/// Whether a signal has asked for a stop. Any thread may call it.
bool stopRequested();

} // namespace qmesh
