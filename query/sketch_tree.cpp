#include "query/sketch_tree.h"

#include <limits>
#include <string>

#include <flann/algorithms/dist.h>
#include <flann/algorithms/kdtree_single_index.h>

#include "features/core/errors.h"

namespace mdbd {
namespace {

constexpr int leaf_size = 32;

// How far rounding may move FLANN's distances, relatively: that of a box adds up along the way down
// to it, through more steps than a point has numbers.
constexpr double tree_margin = 1e-4;

// The radius in FLANN's terms, in which L2 is squared and what is as far as the limit is left out.
float to_limit(double radius) {
  const double limit =
      radius * radius * (1.0 + 2.0 * tree_margin) + std::numeric_limits<float>::min();
  return limit < std::numeric_limits<float>::max() ? static_cast<float>(limit)
                                                   : std::numeric_limits<float>::infinity();
}

/// Takes FLANN's candidates one by one instead of keeping them.
class VisitedSet final : public flann::ResultSet<float> {
 public:
  VisitedSet(const SketchTree::Visitor& visitor, double radius)
      : visitor_(visitor), limit_(to_limit(radius)) {}

  bool full() const override { return true; }
  void addPoint(float /*distance*/, std::size_t row) override { limit_ = to_limit(visitor_(row)); }
  float worstDist() const override { return limit_; }

 private:
  const SketchTree::Visitor& visitor_;
  float limit_;
};

}  // namespace

struct SketchTree::Index {
  flann::KDTreeSingleIndex<flann::L2<float>> tree{flann::KDTreeSingleIndexParams(leaf_size)};
};

SketchTree::SketchTree(std::vector<float> points, std::size_t dimension)
    : index_(std::make_unique<Index>()) {
  if (dimension == 0 || points.empty() || points.size() % dimension != 0) {
    throw InvalidInput(std::to_string(points.size()) + " numbers are no points of dimension " +
                       std::to_string(dimension));
  }
  // The tree copies the points in its own order, after which only its copy is read.
  index_->tree.buildIndex(
      flann::Matrix<float>(points.data(), points.size() / dimension, dimension));
}

SketchTree::~SketchTree() = default;
SketchTree::SketchTree(SketchTree&&) noexcept = default;
SketchTree& SketchTree::operator=(SketchTree&&) noexcept = default;

void SketchTree::visit_within(std::span<const float> query, double radius,
                              const Visitor& visitor) const {
  VisitedSet visited(visitor, radius);
  index_->tree.findNeighbors(visited, query.data(), flann::SearchParams());
}

}  // namespace mdbd
