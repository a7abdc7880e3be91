#include "query/cluster_tree.h"

#include <utility>
#include <variant>

// kmeans_index.h does not include what it uses, so that random.h comes first.
// clang-format off
#include <flann/util/random.h>
#include <flann/algorithms/dist.h>
#include <flann/algorithms/kmeans_index.h>
// clang-format on

namespace mdbd {
namespace {

constexpr unsigned seed = 1;
constexpr int branching = 32;
constexpr int rounds = 5;

using L1Tree = flann::KMeansIndex<flann::L1<float>>;
using L2Tree = flann::KMeansIndex<flann::L2<float>>;

// FLANN's other choices of first centres seed themselves from a random device.
flann::KMeansIndexParams parameters() {
  return flann::KMeansIndexParams(branching, rounds, flann::FLANN_CENTERS_KMEANSPP);
}

}  // namespace

// By pointers: FLANN's copies of a tree that is not built read what was never set.
struct ClusterTree::Index {
  std::variant<std::unique_ptr<L1Tree>, std::unique_ptr<L2Tree>> tree;
};

ClusterTree::ClusterTree(std::vector<float> points, std::size_t dimension, PointNorm norm)
    : points_(std::move(points)) {
  index_ = std::make_unique<Index>();
  if (norm == PointNorm::l1) {
    index_->tree = std::make_unique<L1Tree>(parameters());
  } else {
    index_->tree = std::make_unique<L2Tree>(parameters());
  }
  flann::seed_random(seed);
  const flann::Matrix<float> matrix(points_.data(), points_.size() / dimension, dimension);
  std::visit([&](const auto& tree) { tree->buildIndex(matrix); }, index_->tree);
}

ClusterTree::~ClusterTree() = default;
ClusterTree::ClusterTree(ClusterTree&&) noexcept = default;
ClusterTree& ClusterTree::operator=(ClusterTree&&) noexcept = default;

std::vector<std::size_t> ClusterTree::find_near(std::span<const float> point, std::size_t count,
                                                int checks) const {
  std::vector<float> query(point.begin(), point.end());
  const flann::Matrix<float> matrix(query.data(), 1, query.size());
  std::vector<std::vector<std::size_t>> rows;
  std::vector<std::vector<float>> distances;
  std::visit(
      [&](const auto& tree) {
        tree->knnSearch(matrix, rows, distances, count, flann::SearchParams(checks));
      },
      index_->tree);
  return std::move(rows.front());
}

}  // namespace mdbd
