#pragma once

#include <string>

#include "features/implicit/csg_distance_field.h"
#include "features/implicit/read_csg.h"

/// Solids as the documents of users.
namespace mdbd::test {

inline std::string csg_document(const std::string& solid) {
  return R"({"format": "mdbd-csg", "solid": )" + solid + "}";
}

inline CsgSolid csg_solid(const std::string& solid) { return read_csg(csg_document(solid)); }

inline CsgDistanceField csg_field(const std::string& solid) {
  return CsgDistanceField(csg_solid(solid));
}

inline const std::string l_shape =
    R"({"union": [{"box": {"min": [0, 0, 0], "max": [3, 1, 1]}},
                  {"box": {"min": [0, 1, 0], "max": [1, 3, 1]}}]})";
inline const std::string bored_block =
    R"({"difference": [{"box": {"min": [-2, -1, -1], "max": [2, 1, 1]}},
                       {"cylinder": {"from": [0, 0, -2], "to": [0, 0, 2], "radius": 0.5}}]})";
inline const std::string moon =
    R"({"difference": [{"sphere": {"radius": 1}},
                       {"sphere": {"center": [0.8, 0, 0], "radius": 0.7}}]})";
inline const std::string crossed_cylinders =
    R"({"intersection": [{"cylinder": {"from": [-2, 0, 0], "to": [2, 0, 0], "radius": 1}},
                         {"cylinder": {"from": [0, -2, 0], "to": [0, 2, 0], "radius": 1}}]})";
inline const std::string capsule =
    R"({"union": [{"cylinder": {"from": [0, 0, -1], "to": [0, 0, 1], "radius": 0.5}},
                  {"sphere": {"center": [0, 0, 1], "radius": 0.5}},
                  {"sphere": {"center": [0, 0, -1], "radius": 0.5}}]})";

}  // namespace mdbd::test
