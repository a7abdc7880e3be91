#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "store/vector_table.h"

namespace mdbd::test {

/// A row of a table that keeps what it consists of.
struct Model {
  std::int64_t shape_id = 0;
  std::string path;
  double scale = 0.0;
  std::vector<float> values;
};

inline VectorTable table_of(const std::vector<Model>& models) {
  VectorTableBuilder table;
  for (const Model& model : models) {
    table.append({model.shape_id, model.path, model.scale, model.values});
  }
  return table.take();
}

}  // namespace mdbd::test
