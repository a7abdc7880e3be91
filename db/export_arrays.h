#pragma once

#include <string>

#include "store/shape_store.h"

/// The numbers of a database for other programs, as the content of files. Models come in the order
/// of the vectors, which is that of their paths as in the files of balls; failed ones are left out.
/// CSV is RFC 4180 with plain line feeds, its numbers read back to the same bits.
namespace mdbd {

/// "id,path,scale": the models of the rows of vectors_to_npy(), below a header line.
std::string models_to_csv(const VectorTable& vectors);

/// "id,path,scale,v1,v2,…" below a header line; empty if there are no vectors.
std::string vectors_to_csv(const VectorTable& vectors);

/// A NumPy array (format version 1.0) of float32, a row for each model.
std::string vectors_to_npy(const VectorTable& vectors);

/// "id,path,ball,x,y,z,r" below a header line; balls in order of placement, from 1.
std::string balls_to_csv(const ShapeStore& store);

/// A NumPy array of records (id int64; x, y, z, r float64), one for each ball, those of a model
/// together and in order of placement.
std::string balls_to_npy(const ShapeStore& store);

}  // namespace mdbd
