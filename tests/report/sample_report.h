#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "report/report.h"

namespace mdbd::test {

/// A name with everything that HTML, JSON, XML and terminals trip over.
inline const std::string hostile_name =
    "<script>alert('&\"')</script>\x1b[2J\xff\xef\xbf\xbf\xc3 Stühle\n.off";

/// A report with every kind of block, hostile texts everywhere, gaps and absurd values.
inline Report make_sample_report() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const std::string& name = hostile_name;
  Report report;
  report.title = "Retrieval on " + name;
  report.summary = "Found " + name;
  report.provenance = {{"command", "mdbd-evaluate " + name}, {name, "1"}};
  report.notes = {"1 model failed: " + name};
  report.data = {{"models", {{{"name", name}, {"distance", nan}}}}, {"title", "not this one"}};

  Section first{name, {Paragraph{name}}};
  first.blocks.push_back(Table{name, {name, "distance"}, {{name, "0.5"}, {"short row"}}, true});
  first.blocks.push_back(LineChart{
      name, name, name, {{name, {0, 1, nan, 2}, {1, infinity, 3, 4, 5}}, {name, {}, {}}}});
  first.blocks.push_back(LineChart{"unit", "x", "y", {{"a", {0, 0.5, 1}, {1, 0.5, 0}}}, true});
  first.blocks.push_back(
      LineChart{"log", "x", "y", {{"a", {0, 1, 1000}, {1, 2, -1e300}}}, false, true});
  Section second{"Bars", {}};
  BarChart few{name, name, {name, "b"}, {}, {{name, {1, nan, 7}}, {"other", {-2}}}};
  BarChart many{
      "many", "y", {}, {{name, 600}, {"none", 0}, {"too many", 900}}, {{"a", {}}, {name, {}}}};
  for (std::size_t i = 0; i < 1000; ++i) {
    many.categories.push_back(name);
    many.series[i % 2].values.push_back(std::sin(static_cast<double>(i)));
  }
  second.blocks = {few, many, BarChart{"empty", "y", {}, {}, {}}, LineChart{"empty", "x", "y", {}}};
  Section third{"Matrices", {}};
  third.blocks.push_back(MatrixPicture{name, 2, {0, nan, infinity, 1}, {{name, 1}, {"b", 1}}});
  third.blocks.push_back(MatrixPicture{"empty", 0, {}, {}});
  third.blocks.push_back(ConfusionMatrix{name, {name, "b"}, {{1, 2}, {0, 0}}});
  report.sections = {first, second, third};
  return report;
}

}  // namespace mdbd::test
