// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "qmesh_create_copy.h"

#include <algorithm>

#include <cpl_conv.h>
#include <cpl_string.h>

#include "options/creation_options.h"
#include "options/validate.h"
#include "pyramid/report.h"
#include "qmesh_errors.h"
#include "qmesh_files.h"
#include "qmesh_identify.h"
#include "run/make_terrain.h"
#include "sink/tileset_files.h"
#include "vsi/vsi_files.h"

namespace
{

using qmesh::Code;
using qmesh::Status;

/// What an input without a name is called in messages.
constexpr const char *pszUnnamed = "the source dataset";

bool IsAlpha(GDALDataset *poSrcDS, int nBand)
{
    return poSrcDS->GetRasterBand(nBand)->GetColorInterpretation() == GCI_AlphaBand;
}

/// One band of heights is written; an alpha band besides is its mask, so nothing is lost.
bool CheckBands(GDALDataset *poSrcDS, bool bStrict)
{
    const int nBands = poSrcDS->GetRasterCount();
    if (nBands == 0)
    {
        CPLError(CE_Failure, CPLE_NotSupported,
                 "QMESH: the source dataset has no raster band; terrain is made of one band of "
                 "heights");
        return false;
    }
    if (GDALDataTypeIsComplex(poSrcDS->GetRasterBand(1)->GetRasterDataType()))
    {
        CPLError(CE_Failure, CPLE_NotSupported,
                 "QMESH: band 1 has complex numbers, which cannot be heights");
        return false;
    }
    if (nBands == 1 || (nBands == 2 && IsAlpha(poSrcDS, 2)))
        return true;
    CPLError(bStrict ? CE_Failure : CE_Warning, CPLE_NotSupported,
             "QMESH: the source dataset has %d bands, and terrain is made of one: %s", nBands,
             bStrict ? "choose it with -b of gdal_translate" : "band 1 is taken");
    return !bStrict;
}

/// Whether the source's description names what it was opened from.
bool HasName(GDALDataset *poSrcDS)
{
    const char *pszName = poSrcDS->GetDescription();
    return pszName[0] != '\0' && pszName[0] != '<';
}

std::string BaseName(const std::string &osPath)
{
    const std::string osFile = osPath.substr(osPath.rfind('/') + 1);
    return osFile.substr(0, osFile.rfind('.'));
}

/// NUM_THREADS as GDAL users know it: the configuration option GDAL_NUM_THREADS stands in for it.
void ApplyThreadFallback(const std::vector<qmesh::Assignment> &aoGiven,
                         qmesh::BuildOptions &oOptions)
{
    const char *pszThreads = CPLGetConfigOption("GDAL_NUM_THREADS", nullptr);
    const qmesh::OptionRow *poRow = QMESHOptionTable().byName("num-threads");
    const bool bGiven =
        std::any_of(aoGiven.begin(), aoGiven.end(),
                    [&](const auto &oAssignment) { return oAssignment.row == poRow; });
    if (pszThreads == nullptr || bGiven)
        return;
    const Status oStatus = poRow->set(oOptions, pszThreads);
    if (!oStatus.ok())
        QMESHReportWarning(std::string("GDAL_NUM_THREADS=") + pszThreads +
                           " is passed over: " + oStatus.message());
}

Status ReadOptions(const char *pszFilename, GDALDataset *poSrcDS, CSLConstList papszOptions,
                   qmesh::BuildOptions &oOptions, std::vector<std::string> &aosWarnings)
{
    std::vector<std::string> aosPairs;
    for (CSLConstList papszIter = papszOptions; papszIter && *papszIter; ++papszIter)
        aosPairs.emplace_back(*papszIter);
    const auto oAssignments = qmesh::parseCreationOptions(QMESHOptionTable(), aosPairs);
    if (!oAssignments.ok())
        return oAssignments.status();
    ApplyThreadFallback(*oAssignments, oOptions);
    QMESH_RETURN_IF_ERROR(qmesh::applyAssignments(*oAssignments, oOptions));
    oOptions.output.path = QMESHFolderOf(pszFilename);
    oOptions.input.path = HasName(poSrcDS) ? poSrcDS->GetDescription() : pszUnnamed;
    if (!HasName(poSrcDS) && oOptions.output.title.empty())
        oOptions.output.title = BaseName(oOptions.output.path);
    return qmesh::validate(oOptions, aosWarnings);
}

/// An existing set is replaced; anything else that is not empty is refused.
Status CheckOutput(qmesh::BuildOptions &oOptions)
{
    if (oOptions.output.path.empty())
        return {Code::usage, "the output has no name; name a folder"};
    oOptions.output.overwrite =
        qmesh::holdsTileset(oOptions.output.path) || QMESHHasJustDeleted(oOptions.output.path);
    if (!oOptions.output.overwrite && qmesh::isFolder(oOptions.output.path) &&
        qmesh::holdsFiles(oOptions.output.path))
        return {Code::output, "'" + oOptions.output.path +
                                  "' is not empty and holds no quantized-mesh set that could be "
                                  "replaced; name another folder"};
    return {};
}

/// From the source to the finished set; warnings are reported on the way.
Status Build(const char *pszFilename, GDALDataset *poSrcDS, CSLConstList papszOptions,
             const qmesh::Progress &oProgress)
{
    qmesh::BuildOptions oOptions;
    std::vector<std::string> aosWarnings;
    Status oStatus = ReadOptions(pszFilename, poSrcDS, papszOptions, oOptions, aosWarnings);
    if (oStatus.ok())
        oStatus = CheckOutput(oOptions);
    if (!oStatus.ok())
        return oStatus;
    if (!oProgress(0))
        return {Code::interrupted, "stopped before the work began"};
    const auto oPlan = qmesh::planTerrain(oOptions, poSrcDS, aosWarnings);
    for (const std::string &osWarning : aosWarnings)
        QMESHReportWarning(osWarning);
    if (!oPlan.ok())
        return oPlan.status();
    auto oOutput = qmesh::openOutput(oOptions);
    if (!oOutput.ok())
        return oOutput.status();
    const auto oReport = qmesh::makeTerrain(oOptions, *oPlan, *oOutput, {}, oProgress);
    if (!oReport.ok())
        return oReport.status();
    qmesh::removeNotes(oOptions.output.path);
    for (const std::string &osWarning : qmesh::reportWarnings(*oReport))
        QMESHReportWarning(osWarning);
    return {};
}

/// Nothing may leave a driver as an exception.
Status BuildSafely(const char *pszFilename, GDALDataset *poSrcDS, CSLConstList papszOptions,
                   const qmesh::Progress &oProgress)
{
    try
    {
        return Build(pszFilename, poSrcDS, papszOptions, oProgress);
    }
    catch (const std::exception &oFault)
    {
        return {Code::internal, std::string("a fault of the driver: ") + oFault.what()};
    }
}

} // namespace

GDALDataset *QMESHCreateCopy(const char *pszFilename, GDALDataset *poSrcDS, int bStrict,
                             QMESH_OPTION_LIST papszOptions, GDALProgressFunc pfnProgress,
                             void *pProgressData)
{
    if (!CheckBands(poSrcDS, bStrict != FALSE))
        return nullptr;
    const auto oProgress = [&](double dfDone)
    { return pfnProgress == nullptr || pfnProgress(dfDone, "", pProgressData) != FALSE; };
    const Status oStatus = BuildSafely(pszFilename, poSrcDS, papszOptions, oProgress);
    if (!oStatus.ok())
    {
        QMESHReportError(oStatus);
        return nullptr;
    }
    const char *const apszDrivers[] = {"QMESH", nullptr};
    return GDALDataset::Open(QMESHFolderOf(pszFilename).c_str(),
                             GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR, apszDrivers);
}
