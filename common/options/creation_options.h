// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#pragma once

#include <string>
#include <vector>

#include "options/assignment.h"
#include "options/option_table.h"

/// The option table as the GDAL driver has it: rows with isCreationOption().
namespace qmesh {

/// GDAL's DMD_CREATIONOPTIONLIST.
std::string creationOptionXml(const OptionTable& table);

/// Reads "NAME=VALUE" pairs, names in any case. Names that begin with '@',
/// QUIET_DELETE_ON_CREATE_COPY and APPEND_SUBDATASET are GDAL's own and passed over. Code::usage
/// where a name is unknown or belongs to the command only, a pair has no '=', or an option is set
/// twice to different values.
Result<std::vector<Assignment>> parseCreationOptions(const OptionTable& table,
                                                     const std::vector<std::string>& pairs);

/// A sentence made for the command line in the driver's words: "--max-error" becomes MAX_ERROR and
/// "-s" gdal_translate's -a_srs.
std::string inCreationWords(const OptionTable& table, const std::string& sentence);

} // namespace qmesh
