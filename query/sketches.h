#pragma once

#include <span>

#include "query/metric_sketch.h"
#include "query/sketch_list.h"
#include "store/vector_table.h"

namespace mdbd {

/// Sketches of a collection, row by row, with the map that makes those of queries.
struct Sketches {
  MetricSketch map;
  SketchList list;
};

/// Takes as long as some twenty scans of the collection.
/// @pre as the constructor of MetricSketch
Sketches make_sketches(const VectorTable& collection, std::span<const MetricBlock> blocks);

}  // namespace mdbd
