#include "query/sketch_tree.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <variant>

#include <flann/algorithms/dist.h>
#include <flann/algorithms/kdtree_single_index.h>

#include "features/core/errors.h"

namespace mdbd {
namespace {

using L1Tree = flann::KDTreeSingleIndex<flann::L1<float>>;
using L2Tree = flann::KDTreeSingleIndex<flann::L2<float>>;

constexpr int leaf_size = 32;

template <typename Trees, typename Action>
void on_tree(Trees& trees, const Action& action) {
  if (auto* const l1 = std::get_if<L1Tree>(&trees)) action(*l1);
  if (auto* const l2 = std::get_if<L2Tree>(&trees)) action(*l2);
}

// The radius in FLANN's terms, in which L2 is squared and what is as far as the limit is left out.
float to_limit(double radius, PointNorm norm) {
  constexpr double largest = std::numeric_limits<float>::max();
  const double limit =
      (norm == PointNorm::l2 ? radius * radius : radius) * (1.0 + 2.0 * single_precision_margin) +
      std::numeric_limits<float>::min();
  return limit < largest ? static_cast<float>(limit) : std::numeric_limits<float>::infinity();
}

/// Takes FLANN's candidates one by one instead of keeping them.
class VisitedSet final : public flann::ResultSet<float> {
 public:
  VisitedSet(const SketchTree::Visitor& visitor, PointNorm norm, double radius)
      : visitor_(visitor), norm_(norm), limit_(to_limit(radius, norm)) {}

  bool full() const override { return true; }
  void addPoint(float /*distance*/, std::size_t row) override {
    limit_ = to_limit(visitor_(row), norm_);
  }
  float worstDist() const override { return limit_; }

 private:
  const SketchTree::Visitor& visitor_;
  PointNorm norm_;
  float limit_;
};

}  // namespace

struct SketchTree::Index {
  explicit Index(PointNorm point_norm) : norm(point_norm) {
    const flann::KDTreeSingleIndexParams parameters(leaf_size);
    if (norm == PointNorm::l1) tree.emplace<L1Tree>(parameters);
    if (norm == PointNorm::l2) tree.emplace<L2Tree>(parameters);
  }

  PointNorm norm;
  /// In place: FLANN cannot copy a tree that is not built.
  std::variant<std::monostate, L1Tree, L2Tree> tree;
};

SketchTree::SketchTree(std::vector<float> points, std::size_t dimension, PointNorm norm)
    : index_(std::make_unique<Index>(norm)) {
  if (dimension == 0 || points.empty() || points.size() % dimension != 0) {
    throw InvalidInput(std::to_string(points.size()) + " numbers are no points of dimension " +
                       std::to_string(dimension));
  }
  // The tree copies the points in its own order, after which only its copy is read.
  const flann::Matrix<float> matrix(points.data(), points.size() / dimension, dimension);
  on_tree(index_->tree, [&](auto& tree) { tree.buildIndex(matrix); });
}

SketchTree::~SketchTree() = default;
SketchTree::SketchTree(SketchTree&&) noexcept = default;
SketchTree& SketchTree::operator=(SketchTree&&) noexcept = default;

void SketchTree::visit_within(std::span<const float> query, double radius,
                              const Visitor& visitor) const {
  VisitedSet visited(visitor, index_->norm, radius);
  on_tree(index_->tree, [&](const auto& tree) {
    tree.findNeighbors(visited, query.data(), flann::SearchParams());
  });
}

}  // namespace mdbd
