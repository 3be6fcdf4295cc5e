// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "qmesh_open_options.h"

#include <vector>

#include <cpl_string.h>

#include "base/text.h"

namespace
{

using qmesh::Code;
using qmesh::Status;

/// A word of an option and what it sets.
struct Choice
{
    const char *pszWord;
    void (*pfnSet)(QMESHOpenOptions &oOptions);
};

/// An open option, said once.
struct OpenOption
{
    const char *pszName;
    const char *pszScope;
    const char *pszDefault; ///< null: none that is a word
    const char *pszDescription;
    std::vector<Choice> aoChoices; ///< none: a zoom
};

const std::vector<OpenOption> &Options()
{
    using qmesh::Fill;
    using qmesh::Registration;
    static const std::vector<OpenOption> aoOptions = {
        {"ZOOM", "raster,vector", nullptr, "Zoom level to open; the deepest one by default", {}},
        {"FILL",
         "raster",
         "NODATA",
         "What stands where the level has no tile: nothing, or the surface of the deepest coarser "
         "tile",
         {{"NODATA", [](QMESHOpenOptions &o) { o.eFill = Fill::nodata; }},
          {"PARENT", [](QMESHOpenOptions &o) { o.eFill = Fill::parent; }}}},
        {"REGISTRATION",
         "raster",
         "CELL",
         "Heights in the middle of N x N cells of a tile, with the coarser levels as overviews, or "
         "on the (N + 1) x (N + 1) nodes of their corners, without overviews",
         {{"CELL", [](QMESHOpenOptions &o) { o.eRegistration = Registration::cell; }},
          {"NODE", [](QMESHOpenOptions &o) { o.eRegistration = Registration::node; }}}},
        {"GEOMETRY",
         "vector",
         "TIN",
         "Features of the layer 'triangles': a TIN or a multipolygon for each tile, a polygon for "
         "each triangle, or no such layer",
         {{"TIN", [](QMESHOpenOptions &o) { o.eGeometry = QMESHGeometry::Tin; }},
          {"MULTIPOLYGON", [](QMESHOpenOptions &o) { o.eGeometry = QMESHGeometry::MultiPolygon; }},
          {"POLYGONS", [](QMESHOpenOptions &o) { o.eGeometry = QMESHGeometry::Polygons; }},
          {"POINTS", [](QMESHOpenOptions &o) { o.eGeometry = QMESHGeometry::Points; }}}},
    };
    return aoOptions;
}

Status WrongValue(const OpenOption &oOption, const char *pszValue)
{
    std::string osAllowed;
    for (const Choice &oChoice : oOption.aoChoices)
        osAllowed += std::string(osAllowed.empty() ? "" : ", ") + oChoice.pszWord;
    if (oOption.aoChoices.empty())
        osAllowed = "a whole number, 0 to " + std::to_string(qmesh::kMaxZoom);
    return {Code::usage, std::string("open option ") + oOption.pszName + "=" + pszValue +
                             ": the value must be " + (oOption.aoChoices.empty() ? "" : "one of ") +
                             osAllowed};
}

bool SetZoom(const char *pszValue, QMESHOpenOptions &oOptions)
{
    const auto oZoom = qmesh::parseInteger(pszValue);
    if (!oZoom || *oZoom < 0 || *oZoom > qmesh::kMaxZoom)
        return false;
    oOptions.oZoom = static_cast<int>(*oZoom);
    return true;
}

bool SetValue(const OpenOption &oOption, const char *pszValue, QMESHOpenOptions &oOptions)
{
    if (oOption.aoChoices.empty())
        return SetZoom(pszValue, oOptions);
    for (const Choice &oChoice : oOption.aoChoices)
    {
        if (!EQUAL(pszValue, oChoice.pszWord))
            continue;
        oChoice.pfnSet(oOptions);
        return true;
    }
    return false;
}

} // namespace

qmesh::Result<QMESHOpenOptions> QMESHParseOpenOptions(CSLConstList papszOptions)
{
    QMESHOpenOptions oOptions;
    for (const OpenOption &oOption : Options())
    {
        const char *pszValue = CSLFetchNameValue(papszOptions, oOption.pszName);
        if (pszValue != nullptr && !SetValue(oOption, pszValue, oOptions))
            return WrongValue(oOption, pszValue);
    }
    return oOptions;
}

std::string QMESHOpenOptionXml()
{
    std::string osXml = "<OpenOptionList>";
    for (const OpenOption &oOption : Options())
    {
        const bool bWords = !oOption.aoChoices.empty();
        osXml += std::string("<Option name='") + oOption.pszName + "' type='" +
                 (bWords ? "string-select" : "int") + "' scope='" + oOption.pszScope + "'";
        if (!bWords)
            osXml += " min='0' max='" + std::to_string(qmesh::kMaxZoom) + "'";
        if (oOption.pszDefault != nullptr)
            osXml += std::string(" default='") + oOption.pszDefault + "'";
        char *pszText = CPLEscapeString(oOption.pszDescription, -1, CPLES_XML);
        osXml += std::string(" description=\"") + pszText + "\">";
        CPLFree(pszText);
        for (const Choice &oChoice : oOption.aoChoices)
            osXml += std::string("<Value>") + oChoice.pszWord + "</Value>";
        osXml += "</Option>";
    }
    return osXml + "</OpenOptionList>";
}
