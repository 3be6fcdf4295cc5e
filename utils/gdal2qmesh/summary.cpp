// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include "summary.h"

#include <cstdarg>
#include <cstdio>

#include "console/console.h"

namespace qmesh {

namespace {

__attribute__((format(printf, 1, 2))) std::string format(const char* pattern, ...) {
  char text[256];
  va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(text, sizeof text, pattern, arguments);
  va_end(arguments);
  return text;
}

std::string sizeText(std::uint64_t bytes) {
  if (bytes < 10'000)
    return std::to_string(bytes) + " bytes";
  if (bytes < 10'000'000)
    return format("%.1f kB", double(bytes) / 1e3);
  if (bytes < 10'000'000'000)
    return format("%.1f MB", double(bytes) / 1e6);
  return format("%.1f GB", double(bytes) / 1e9);
}

std::string runTimeText(double seconds) {
  return seconds < 60 ? format("%.1f s", seconds) : durationText(seconds);
}

std::string zoomsText(int first, int last) {
  return first == last ? format("zoom %d", first) : format("zooms %d-%d", first, last);
}

} // namespace

std::string startLine(const BuildOptions& options, const PyramidPlan& plan,
                      const BlockPlan& blocks) {
  return options.input.path + " -> " + options.output.path + ": " +
         zoomsText(plan.minZoom, plan.maxZoom) +
         format(", %llu tiles, ", static_cast<unsigned long long>(plan.tileCount())) + "method " +
         options.method.name +
         format(", %d thread%s", blocks.threads, blocks.threads == 1 ? "" : "s");
}

std::vector<std::string> reportLines(const BuildOptions& options, const BuildReport& report) {
  const LevelStats total = report.total();
  const LevelStats& finest = report.levels[std::size_t(report.maxZoom)];
  std::vector<std::string> lines;
  lines.push_back(format("%llu tiles, %llu triangles, ",
                         static_cast<unsigned long long>(total.tiles),
                         static_cast<unsigned long long>(total.triangles)) +
                  sizeText(total.bytes) + " in " + runTimeText(report.wallSeconds) +
                  format("; at zoom %d the largest error is %.3g m (rms %.3g m)", report.maxZoom,
                         finest.maxError, finest.rmsError()));
  if (options.output.preview != Preview::none)
    lines.push_back("to look at it: python3 -m http.server --directory '" + options.output.path +
                    "' 8000, then open http://localhost:8000/");
  return lines;
}

std::string levelTable(const BuildReport& report) {
  std::string text = "zoom      tiles    triangles       bytes  max error    reached        rms";
  for (int z = report.minZoom; z <= report.maxZoom; ++z) {
    const LevelStats& level = report.levels[std::size_t(z)];
    text += format("\n%4d %10llu %12llu %11llu %10.4g %10.4g %10.4g", z,
                   static_cast<unsigned long long>(level.tiles),
                   static_cast<unsigned long long>(level.triangles),
                   static_cast<unsigned long long>(level.bytes), report.maxErrors[std::size_t(z)],
                   level.maxError, level.rmsError());
  }
  return text;
}

std::string estimateTable(const PyramidPlan& plan, const BlockPlan& blocks,
                          const Estimate& estimate) {
  std::string text = "zoom      tiles  max error [m]   size (estimated)\n";
  for (int z = plan.minZoom; z <= plan.maxZoom; ++z) {
    const std::size_t k = std::size_t(z);
    text +=
        format("%4d %10llu %14.4g %18s\n", z, static_cast<unsigned long long>(plan.tiles.count(z)),
               plan.levels[k].maxError, sizeText(estimate.bytes[k]).c_str());
  }
  return text + format("total %9llu %33s, about %s with %d thread%s\n",
                       static_cast<unsigned long long>(plan.tileCount()),
                       sizeText(estimate.totalBytes()).c_str(),
                       durationText(estimate.seconds).c_str(), blocks.threads,
                       blocks.threads == 1 ? "" : "s");
}

} // namespace qmesh
