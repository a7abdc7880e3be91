#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "features/decomposition/flat_piece.h"
#include "features/distance/distance_field.h"

namespace mdbd {

/// The flat pieces of the boundary that a search has met, each made once.
class FlatPieces {
 public:
  /// The piece that says most about the distances around a sample's closest point: the convex piece
  /// that the field hands out, or a hexagon in the flat disc around the point, where that reaches
  /// farther.
  /// @returns null if the boundary is not known to be flat there; else valid as long as this object
  const FlatPiece* around(const DistanceSample& sample);

 private:
  /// The hexagon in a disc.
  struct Disc {
    Eigen::Vector3d center;
    double clearance;  // of the centre from the sides
    std::unique_ptr<const FlatPiece> piece;
  };

  const FlatPiece* find_disc(const DistanceSample& sample);

  std::unordered_map<const Eigen::Vector3d*, std::unique_ptr<const FlatPiece>> polygons_;
  std::unordered_map<std::uint32_t, std::vector<Disc>> discs_;  // by region
};

}  // namespace mdbd
