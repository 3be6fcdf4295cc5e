// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "qmesh_errors.h"

#include <cpl_error.h>

#include "options/creation_options.h"
#include "simplify/simplifier.h"

namespace
{

CPLErrorNum ErrorNumber(qmesh::Code eCode)
{
    switch (eCode)
    {
        case qmesh::Code::usage:
            return CPLE_IllegalArg;
        case qmesh::Code::interrupted:
            return CPLE_UserInterrupt;
        case qmesh::Code::output:
            return CPLE_FileIO;
        default:
            return CPLE_AppDefined;
    }
}

} // namespace

const qmesh::OptionTable &QMESHOptionTable()
{
    static const qmesh::OptionTable oTable(qmesh::simplifierChoices());
    return oTable;
}

void QMESHReportError(const qmesh::Status &oStatus)
{
    CPLError(CE_Failure, ErrorNumber(oStatus.code()), "QMESH: %s",
             qmesh::inCreationWords(QMESHOptionTable(), oStatus.message()).c_str());
}

void QMESHReportWarning(const std::string &osSentence)
{
    CPLError(CE_Warning, CPLE_AppDefined, "QMESH: %s",
             qmesh::inCreationWords(QMESHOptionTable(), osSentence).c_str());
}
