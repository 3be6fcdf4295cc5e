// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "export/mesh_writers.h"

#include <cmath>

#include "base/text.h"
#include "export/mesh_places.h"
#include "export/shading.h"

namespace qmesh {

namespace {

std::string rounded(double value, double perUnit) {
  const double whole = std::floor(value * perUnit + 0.5);
  return formatNumber(whole == 0 ? 0 : whole / perUnit);
}

std::string positionText(const Vec3& p, MeshFrame frame) {
  constexpr double kPerMetre = 1e4, kPerDegree = 1e9;
  const double across = frame == MeshFrame::lonlat ? kPerDegree : kPerMetre;
  return rounded(p.x, across) + " " + rounded(p.y, across) + " " + rounded(p.z, kPerMetre);
}

std::string normalText(const Vec3& n) {
  constexpr double kPerUnit = 1e6;
  return rounded(n.x, kPerUnit) + " " + rounded(n.y, kPerUnit) + " " + rounded(n.z, kPerUnit);
}

std::string frameSentence(const ExportMesh& mesh, MeshFrame frame) {
  std::string text = mesh.name.empty() ? "mesh" : mesh.name;
  for (char& c : text)
    if (c == '\n' || c == '\r')
      c = ' ';
  text += "; ";
  for (const EnumRow<MeshFrame>& row : EnumTable<MeshFrame>::kRows)
    if (row.value == frame)
      text += row.help;
  const GeoBox& box = mesh.box;
  return text + "; box " + formatNumber(box.west) + " " + formatNumber(box.south) + " " +
         formatNumber(box.east) + " " + formatNumber(box.north);
}

std::string triangleText(const std::array<std::uint32_t, 3>& triangle) {
  return std::to_string(triangle[0]) + " " + std::to_string(triangle[1]) + " " +
         std::to_string(triangle[2]);
}

std::string pointText(const Plan::Point& point) {
  constexpr double kPerPixel = 100;
  return rounded(point.x, kPerPixel) + " " + rounded(point.y, kPerPixel);
}

std::string xmlText(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return out;
}

} // namespace

std::string objText(const ExportMesh& mesh, MeshFrame frame) {
  std::string text = "# " + frameSentence(mesh, frame) + "\n";
  for (const Vec3& p : positionsIn(mesh, frame))
    text += "v " + positionText(p, frame) + "\n";
  for (const Vec3& n : normalsIn(mesh, frame))
    text += "vn " + normalText(n) + "\n";
  for (const auto& triangle : mesh.triangles) {
    text += "f";
    for (const std::uint32_t k : triangle) {
      const std::string number = std::to_string(k + 1);
      text += " " + (mesh.normals.empty() ? number : number + "//" + number);
    }
    text += "\n";
  }
  return text;
}

std::string plyText(const ExportMesh& mesh, MeshFrame frame) {
  const std::vector<Vec3> normals = normalsIn(mesh, frame);
  std::string text = "ply\nformat ascii 1.0\ncomment " + frameSentence(mesh, frame) + "\n";
  text += "element vertex " + std::to_string(mesh.vertices.size()) + "\n";
  for (const char* name : {"x", "y", "z"})
    text += std::string("property double ") + name + "\n";
  for (const char* name : {"nx", "ny", "nz"})
    text += normals.empty() ? "" : std::string("property float ") + name + "\n";
  text += "element face " + std::to_string(mesh.triangles.size()) + "\n";
  text += "property list uchar uint vertex_indices\nend_header\n";
  const std::vector<Vec3> positions = positionsIn(mesh, frame);
  for (std::size_t k = 0; k < positions.size(); ++k)
    text += positionText(positions[k], frame) +
            (normals.empty() ? "" : " " + normalText(normals[k])) + "\n";
  for (const auto& triangle : mesh.triangles)
    text += "3 " + triangleText(triangle) + "\n";
  return text;
}

std::string offText(const ExportMesh& mesh, MeshFrame frame) {
  std::string text = "OFF\n# " + frameSentence(mesh, frame) + "\n";
  text +=
      std::to_string(mesh.vertices.size()) + " " + std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Vec3& p : positionsIn(mesh, frame))
    text += positionText(p, frame) + "\n";
  for (const auto& triangle : mesh.triangles)
    text += "3 " + triangleText(triangle) + "\n";
  return text;
}

std::string svgText(const ExportMesh& mesh, const MeshDrawing& drawing) {
  const Plan plan = planOf(mesh, drawing.width);
  const std::vector<Rgb> colours = triangleColours(mesh, drawing.shade);
  const std::string w = std::to_string(plan.width), h = std::to_string(plan.height);
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h +
                     "\" viewBox=\"-2 -2 " + std::to_string(plan.width + 4) + " " +
                     std::to_string(plan.height + 4) + "\">\n";
  text += "<title>" + xmlText(mesh.name) + "</title>\n";
  text += "<g class=\"triangles\" stroke-width=\"0.6\" stroke-linejoin=\"round\"";
  text += drawing.lines ? " stroke=\"" + hexColour(kLineColour) + "\">\n" : ">\n";
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& triangle = mesh.triangles[t];
    const std::string fill = hexColour(colours[t]);
    text += "<path d=\"M" + pointText(plan.points[triangle[0]]) + "L" +
            pointText(plan.points[triangle[1]]) + " " + pointText(plan.points[triangle[2]]) +
            "Z\" fill=\"" + fill + (drawing.lines ? "\"/>\n" : "\" stroke=\"" + fill + "\"/>\n");
  }
  text += "</g>\n<path class=\"border\" fill=\"none\" stroke=\"" + hexColour(kBorderColour) +
          "\" stroke-width=\"2.5\" stroke-linecap=\"round\" d=\"";
  for (const Plan::Edge& edge : plan.border)
    text += "M" + pointText(plan.points[edge[0]]) + "L" + pointText(plan.points[edge[1]]);
  return text + "\"/>\n</svg>\n";
}

std::string meshText(const ExportMesh& mesh, MeshFormat format, MeshFrame frame) {
  switch (format) {
  case MeshFormat::obj:
    return objText(mesh, frame);
  case MeshFormat::off:
    return offText(mesh, frame);
  case MeshFormat::ply:
    break;
  }
  return plyText(mesh, frame);
}

} // namespace qmesh
