// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "validate/finding.h"

#include <algorithm>
#include <cassert>

namespace qmesh {

namespace {

constexpr Severity kError = Severity::error;
constexpr Severity kWarning = Severity::warning;
constexpr Severity kNote = Severity::note;

using Kinds = std::vector<FindingKind>;

Kinds layerKinds() {
  return {
      {101, kError, "layer.json is missing or empty",
       "Clients take a set without it for another format, or show nothing.",
       "Write a layer.json beside the zoom folders."},
      {102, kError, "layer.json is not JSON", "No client can read it.",
       "Repair the text; a JSON checker names the line."},
      {103, kError, "the format is not quantized-mesh-1.0",
       "CesiumJS refuses a layer.json without \"format\": \"quantized-mesh-1.0\".",
       "Write \"format\": \"quantized-mesh-1.0\"."},
      {104, kError, "the address of the tiles is missing",
       "Without \"tiles\", a list with one pattern at least, clients cannot ask for a tile.",
       "Write \"tiles\": [\"{z}/{x}/{y}.terrain\"]."},
      {105, kError, "the projection is unknown",
       "Clients know EPSG:4326 (two root tiles) and EPSG:3857 (one).",
       "Write \"projection\": \"EPSG:4326\" or \"EPSG:3857\", as the tiles are."},
      {106, kError, "the scheme is unknown",
       "Clients know \"tms\" (rows from the south) and \"slippyMap\" (from the north); \"xyz\" is "
       "an "
       "error in CesiumJS.",
       "Write \"scheme\": \"slippyMap\" for rows from the north, else \"tms\"."},
      {107, kWarning, "\"schema\" is written for \"scheme\"",
       "Clients pass over the key \"schema\" and count rows from the south.",
       "Rename the key to \"scheme\"."},
      {108, kError, "nothing says which tiles there are",
       "Without \"available\" and \"metadataAvailability\" every tile fails in CesiumJS.",
       "Write \"available\": for each level from 0 a list of rectangles of tiles."},
      {109, kError, "\"available\" is malformed",
       "A level is a list of objects startX, startY, endX, endY inside the level's matrix, rows "
       "from "
       "the south whatever the scheme.",
       "Write the rectangles anew from the tiles there are."},
      {110, kWarning, "a tile is listed twice",
       "Overlapping rectangles make clients slower and counts wrong.",
       "Write disjoint rectangles."},
      {111, kError, "a level between others has no tiles",
       "Clients go down level by level: nothing below the gap is ever shown, or tiles that do not "
       "exist "
       "are asked for.",
       "Make the level, or end the set above the gap."},
      {112, kError, "a root tile is not listed",
       "Its part of the globe stays empty: CesiumJS begins with all tiles of level 0, also over a "
       "\"parentUrl\".",
       "Make all tiles of level 0 (two for EPSG:4326, one for EPSG:3857) and list them."},
      {113, kError, "\"maxzoom\" is too small", "Levels deeper than it are hidden.",
       "Set it to the deepest level listed."},
      {114, kNote, "\"maxzoom\" is larger than the deepest level",
       "Programs that go by it expect detail that is not there.",
       "Set it to the deepest level listed."},
      {115, kWarning, "\"minzoom\" is not the first level",
       "Programs that go by it ask for tiles that are not there, or pass over some.",
       "Set it to the first level listed."},
      {116, kWarning, "the address has {version}, but there is no \"version\"",
       "The braces stay in the address, which some servers refuse.",
       "Write \"version\", or take {version} out of \"tiles\"."},
      {117, kError, "the address does not tell tiles apart",
       "A pattern needs {z}, {x} and {y} (or {reverseY}).",
       "Write \"tiles\": [\"{z}/{x}/{y}.terrain\"]."},
      {118, kWarning, "\"bounds\" are missing or malformed",
       "CesiumJS does not read them, other clients and GDAL do: west, south, east, north in "
       "degrees.",
       "Write \"bounds\" in degrees, whatever the projection."},
      {119, kWarning, "\"bounds\" leave out tiles",
       "Programs that go by them do not show the tiles outside.", "Write the box around the data."},
      {120, kWarning, "a word in \"extensions\" is unknown",
       "Clients ask for octvertexnormals, watermask and metadata only.",
       "Correct or remove the word in \"extensions\"."},
      {121, kWarning, "the extension has its old name",
       "\"vertexnormals\" makes CesiumJS read the lengths of extensions in the other byte order.",
       "Write \"octvertexnormals\" when the lengths are little-endian."},
      {122, kError, "\"metadataAvailability\" is not a number of levels",
       "It must be a whole number above 0.", "Correct or remove it."},
      {123, kNote, "there is no \"attribution\"",
       "Whom the heights belong to is not shown in the viewer.",
       "Write \"attribution\" (gdal2qmesh -c)."},
  };
}

Kinds formatKinds() {
  return {
      {201, kError, "the gzip stream is broken", "The tile cannot be unpacked.",
       "Copy or make the tile again."},
      {202, kError, "the file is no tile",
       "It holds text, another format or nothing: perhaps a server's message saved as a tile.",
       "Fetch or make the tile again."},
      {203, kError, "the tile is compressed twice",
       "Clients unpack it once and find no tile (\"Invalid typed array length\").",
       "Unpack it once; compress either the file or in the server, not both."},
      {204, kError, "the file ends too early", "Part of the tile is missing.",
       "Copy or make the tile again."},
      {205, kError, "a vertex is outside 0..32767",
       "Positions and heights are numbers from 0 to 32767, stored as zig-zag differences.",
       "Repair the program that encodes the tile."},
      {206, kError, "an index names no vertex",
       "Triangles are stored by high-water mark: each index is the highest so far minus the code.",
       "Renumber the vertices in order of first use before encoding."},
      {207, kError, "indices have the wrong width",
       "They take 16 bits up to 65536 vertices and 32 bits above, and are aligned to their size.",
       "Repair the program that encodes the tile."},
      {208, kError, "an edge list is wrong",
       "Clients hang the skirts on it: it must hold exactly the vertices on that edge, each once.",
       "List the vertices with u = 0 (west), v = 0 (south), u = 32767 (east), v = 32767 (north)."},
      {209, kError, "edge lists are exchanged",
       "The order is west, south, east, north; skirts hang in the wrong places.",
       "Write the lists in that order."},
      {210, kError, "an extension ends beyond the file", "The tile cannot be read to its end.",
       "Write an extension as id (1 byte), length (4 bytes, little-endian), data."},
      {211, kError, "the lengths of extensions are big-endian",
       "Clients read them little-endian and find none, or fail.",
       "Write them little-endian (or name the extension \"vertexnormals\", as old servers did)."},
      {212, kError, "normals have the wrong length",
       "octvertexnormals takes 2 bytes for each vertex.", "Write 2 bytes a vertex."},
      {213, kError, "the water mask has the wrong length",
       "It is 1 byte (all land or all water) or 256 x 256 bytes, north row first.",
       "Write 1 or 65536 bytes."},
      {214, kError, "the metadata is malformed",
       "The extension is a length (4 bytes) and JSON with \"available\" for the levels below.",
       "Write it anew (gdal2qmesh --metadata N)."},
      {215, kWarning, "an extension is there twice", "Which one counts depends on the client.",
       "Write it once."},
      {216, kNote, "an extension is unknown", "Clients pass over it.", "None is needed."},
      {217, kError, "the tile has exactly 65536 vertices",
       "CesiumJS reads its indices with one width and draws with the other.",
       "Leave one vertex out, or add one."},
      {218, kError, "the file cannot be read", "The system or the server refused it.",
       "Look at the rights of the file and the health of the disk or server."},
  };
}

Kinds meshKinds() {
  return {
      {301, kError, "a triangle has no area",
       "It costs memory, and its normal is not a number in some clients.",
       "Leave it out and keep the mesh closed."},
      {302, kError, "a triangle is clockwise", "It is not drawn: clients cull the back side.",
       "Write the corners counter-clockwise, seen from above."},
      {303, kError, "two vertices at one place", "The surface is torn or has a wall there.",
       "Merge them."},
      {304, kWarning, "a vertex is in no triangle", "It costs memory and widens the header.",
       "Leave it out."},
      {305, kError, "the mesh is not manifold",
       "An edge belongs to more than two triangles, or runs the same way in both.",
       "Triangulate the tile anew."},
      {306, kError, "a vertex lies inside another triangle's edge",
       "A T-vertex: hairline cracks flicker along the edge.", "Split the triangle at that vertex."},
      {307, kError, "the mesh does not cover its square exactly",
       "There are holes, overlaps, or the border is not reached.",
       "Triangulate the whole square from 0 to 32767."},
      {308, kWarning, "normals point into the ground",
       "Terrain is lit from below: normals must be earth-fixed and unit, not in the tile's own "
       "axes.",
       "Compute normals in earth-centred, earth-fixed axes."},
      {309, kWarning, "triangles are too large for the curve of the globe",
       "A facet lies deeper below the ellipsoid than the level's error.",
       "Divide low zooms by a grid (z0: 32 x 32 cells)."},
  };
}

Kinds headerKinds() {
  return {
      {401, kError, "a number of the header is not finite",
       "NaN or infinity makes tiles vanish in CesiumJS.", "Compute the header from the vertices."},
      {402, kError, "a vertex is outside the bounding sphere",
       "The tile vanishes while part of it is in view.",
       "Compute the sphere from the decoded vertices, in metres on the WGS 84 ellipsoid."},
      {403, kWarning, "the bounding sphere is too large", "Tiles out of view are loaded and drawn.",
       "Compute the sphere from the decoded vertices."},
      {404, kError, "the horizon point is too low",
       "The tile vanishes at the horizon while it is in view.",
       "Compute it from the decoded vertices in units of the ellipsoid's radii."},
      {405, kNote, "the horizon point is too high",
       "Tiles behind the horizon are loaded and drawn.",
       "Compute it from the decoded vertices in units of the ellipsoid's radii."},
      {406, kError, "the least height is above the greatest", "Heights are upside down.",
       "Exchange the two numbers, or encode the heights anew."},
      {407, kWarning, "the header's heights are much wider than the vertices'",
       "Heights are rounded more coarsely than they need to be.",
       "Take the least and greatest height of the tile's own vertices."},
      {408, kWarning, "heights are not on Earth",
       "Below -12000 m or above 9000 m: voids of the DEM were taken for heights, or feet for "
       "metres.",
       "Name the nodata value (gdal2qmesh -a) and fill voids."},
      {409, kWarning, "the centre is outside the bounding sphere",
       "CesiumJS does not use it, others place the tile by it.", "Write the centre of the tile."},
  };
}

Kinds seamKinds() {
  return {
      {501, kWarning, "neighbours have other vertices on their edge",
       "Hairline cracks and a visible line in the shading.",
       "Choose the vertices of an edge by that edge alone."},
      {502, kWarning, "neighbours' heights are rounded differently",
       "Gaps of more than 1 mm, yet within what the two tiles round heights to.",
       "Round heights on edges to steps that both tiles share."},
      {503, kError, "a crack between neighbours",
       "The surfaces are apart on the shared edge by more than rounding.",
       "Give both tiles the same heights on the edge; at the antimeridian too."},
      {504, kWarning, "neighbours have other normals on their edge",
       "A line in the shading of lit terrain.",
       "Compute normals from the DEM around the edge, not from one tile's triangles."},
      {505, kError, "the pole has several heights",
       "The vertices of a pole's row are one point: the surface is torn there.",
       "Give the whole row one height."},
  };
}

Kinds availabilityKinds() {
  return {
      {601, kError, "a listed tile is missing",
       "A 404 for clients; sampleTerrainMostDetailed gives undefined there.",
       "Make the tile, or take it out of \"available\"."},
      {602, kWarning, "a tile is not listed", "No client asks for it.",
       "List it in \"available\", or remove the file."},
      {603, kError, "a tile has no parent", "Clients go down level by level and never reach it.",
       "Make and list the tile above it."},
      {604, kError, "a tile has metadata, layer.json has no \"metadataAvailability\"",
       "CesiumJS throws at that tile.",
       "Write \"metadataAvailability\", or remove the extension from the tiles."},
      {605, kError, "metadata is missing",
       "\"metadataAvailability\": N promises it in the tiles of every N-th zoom.",
       "Write it (gdal2qmesh --metadata N), or remove the key."},
      {606, kError, "metadata and \"available\" contradict each other",
       "Clients ask for tiles that do not exist, or do not find those that do.",
       "Write both from the tiles there are, rows from the south."},
      {607, kError, "normals are announced but absent", "CesiumJS draws such terrain black.",
       "Write the normals, or take octvertexnormals out of \"extensions\"."},
      {608, kWarning, "normals are present but not announced", "Clients pass over them.",
       "Add octvertexnormals to \"extensions\"."},
      {609, kWarning, "a water mask is announced but absent", "Water is drawn as land.",
       "Write the masks, or take watermask out of \"extensions\"."},
      {610, kWarning, "a water mask is present but not announced", "Clients pass over it.",
       "Add watermask to \"extensions\"."},
      {611, kNote, "tiles are compressed",
       "The server must send Content-Encoding: gzip, or every tile fails (\"Invalid typed array "
       "length\").",
       "Set the header, or make the set with --compress none."},
      {612, kWarning, "some tiles are compressed and some are not",
       "A server sends one header for all of them, so some fail.", "Compress all tiles or none."},
  };
}

} // namespace

const std::vector<FindingKind>& findingKinds() {
  static const Kinds all = [] {
    Kinds kinds;
    for (const Kinds& group : {layerKinds(), formatKinds(), meshKinds(), headerKinds(), seamKinds(),
                               availabilityKinds()})
      kinds.insert(kinds.end(), group.begin(), group.end());
    return kinds;
  }();
  return all;
}

const FindingKind& findingKind(int code) {
  const Kinds& kinds = findingKinds();
  const auto found = std::lower_bound(kinds.begin(), kinds.end(), code,
                                      [](const FindingKind& a, int b) { return a.code < b; });
  assert(found != kinds.end() && found->code == code);
  return *found;
}

std::string codeText(int code) {
  return "QM" + std::to_string(code);
}

int codeOf(std::string_view text) {
  if (text.size() > 2 && equalIgnoringCase(text.substr(0, 2), "QM"))
    text.remove_prefix(2);
  for (const FindingKind& kind : findingKinds())
    if (std::to_string(kind.code) == text)
      return kind.code;
  return 0;
}

} // namespace qmesh
