// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>

#include "base/status.h"
#include "options/option_table.h"

/// The option table of this build; made once, free-threaded.
const qmesh::OptionTable &QMESHOptionTable();

/// One CPLError for a status that is not ok, in the driver's words (inCreationWords).
void QMESHReportError(const qmesh::Status &oStatus);

/// One CPLError of class CE_Warning, in the driver's words.
void QMESHReportWarning(const std::string &osSentence);
