// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <cinttypes>
#include <cstdarg>
#include <cstdio>

#include "base/text.h"
#include "compare/compare.h"

namespace qmesh {

namespace {

constexpr CompareTarget kTargets[] = {CompareTarget::defaults, CompareTarget::count,
                                      CompareTarget::error};

__attribute__((format(printf, 1, 2))) std::string format(const char* pattern, ...) {
  char text[320];
  va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(text, sizeof text, pattern, arguments);
  va_end(arguments);
  return text;
}

std::string titleOf(const Comparison& comparison, CompareTarget target) {
  switch (target) {
  case CompareTarget::count:
    return format("At %" PRIu64 " triangles", comparison.triangles);
  case CompareTarget::error:
    return format("At a max error of %.4g m", comparison.maxError);
  case CompareTarget::defaults:
    break;
  }
  return "With the defaults";
}

std::string optionOf(const ComparedMethod& row) {
  if (row.option.empty())
    return row.reached ? "" : "not reached: no option for it";
  return "--" + row.option + format(" %.6g", parseNumber(row.value).value_or(0)) +
         (row.reached ? "" : " not reached");
}

std::string tableLine(const ComparedMethod& row) {
  const TinQuality& q = row.quality;
  return format("%-10s %9" PRIu64 " %9" PRIu64 " %9.4g %9.4g %9.4g %9.4g %9.4g %9.4g %7.3g %7.3g "
                "%8.4g  ",
                row.method.c_str(), row.triangles, row.bytes, q.height.max, q.rms(q.height),
                q.mean(q.height), q.distance.max, q.rms(q.distance), q.mean(q.distance), q.minAngle,
                q.meanAngle(), row.cpuSeconds * 1000) +
         optionOf(row) + "\n";
}

std::string number(double value) {
  return format("%.9g", value);
}

} // namespace

std::string comparisonTable(const Comparison& comparison) {
  std::string text;
  for (const CompareTarget target : kTargets) {
    text += (text.empty() ? "" : "\n") + titleOf(comparison, target) + "\n";
    text += format("%-10s %9s %9s %29s %29s %15s %8s\n", "", "", "", "height error [m]",
                   "distance from the mesh [m]", "angle [deg]", "CPU");
    text += format("%-10s %9s %9s %9s %9s %9s %9s %9s %9s %7s %7s %8s\n", "method", "triangles",
                   "bytes", "max", "rms", "mean", "max", "rms", "mean", "min", "mean", "ms");
    for (const ComparedMethod& row : comparison.targets[std::size_t(target)])
      text += tableLine(row);
  }
  return text;
}

std::string comparisonCsv(const Comparison& comparison) {
  std::string text = "target,method,option,value,reached,vertices,triangles,bytes,max_error,"
                     "rms_error,mean_error,max_distance,rms_distance,mean_distance,min_angle,"
                     "mean_min_angle\n";
  for (const CompareTarget target : kTargets) {
    for (const ComparedMethod& row : comparison.targets[std::size_t(target)]) {
      const TinQuality& q = row.quality;
      text += join({enumName(target), row.method, row.option, row.value, row.reached ? "yes" : "no",
                    std::to_string(row.vertices), std::to_string(row.triangles),
                    std::to_string(row.bytes), number(q.height.max), number(q.rms(q.height)),
                    number(q.mean(q.height)), number(q.distance.max), number(q.rms(q.distance)),
                    number(q.mean(q.distance)), number(q.minAngle), number(q.meanAngle())},
                   ",") +
              "\n";
    }
  }
  return text;
}

} // namespace qmesh
