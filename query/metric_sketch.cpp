#include "query/metric_sketch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/Eigenvalues>

namespace mdbd {
namespace {

constexpr std::size_t largest_sample = 2048;
constexpr int line_rounds = 12;

/// Rows of a sample less their mean, with the weight of the block.
Eigen::MatrixXd sample_block(const VectorTable& collection, const MetricBlock& block) {
  const std::size_t rows = std::min(collection.size(), largest_sample);
  Eigen::MatrixXd sample(rows, block.count);
  for (std::size_t row = 0; row < rows; ++row) {
    const std::span<const float> values = collection.values(row * collection.size() / rows);
    for (std::size_t i = 0; i < block.count; ++i) {
      sample(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(i)) =
          block.weight * values[block.first + i];
    }
  }
  const Eigen::RowVectorXd mean = sample.colwise().mean();
  sample.rowwise() -= mean;
  return sample;
}

/// A direction in the space of a block, of which the sketch has one number.
struct Direction {
  double variance = 0.0;
  std::size_t first = 0;
  Eigen::VectorXd coefficients;
};

// For components within MetricSketch::largest_component all numbers stay far from overflow.
void append_principal_axes(const Eigen::MatrixXd& sample, const MetricBlock& block,
                           std::vector<Direction>& directions) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(sample.transpose() * sample);
  for (Eigen::Index i = 0; i < sample.cols(); ++i) {
    directions.push_back({.variance = solver.eigenvalues()[i],
                          .first = block.first,
                          .coefficients = block.weight * solver.eigenvectors().col(i)});
  }
}

std::vector<Direction> principal_axes(const VectorTable& collection,
                                      std::span<const MetricBlock> blocks, std::size_t size) {
  std::vector<Direction> directions;
  for (const MetricBlock& block : blocks) {
    if (block.count == 0 || block.weight == 0.0) continue;
    append_principal_axes(sample_block(collection, block), block, directions);
  }
  std::ranges::stable_sort(directions, std::ranges::greater{}, &Direction::variance);
  directions.resize(std::min(size, directions.size()));
  return directions;
}

/// Which sum a number enters, and with which sign.
struct Membership {
  std::size_t sum = 0;
  double sign = 1.0;
};

/// The line that each column is nearest to in direction.
std::vector<Membership> nearest_lines(const Eigen::MatrixXd& columns,
                                      const Eigen::MatrixXd& lines) {
  const Eigen::MatrixXd products = lines.transpose() * columns;
  std::vector<Membership> memberships(static_cast<std::size_t>(columns.cols()));
  for (Eigen::Index column = 0; column < columns.cols(); ++column) {
    Eigen::Index line = 0;
    products.col(column).cwiseAbs().maxCoeff(&line);
    memberships[static_cast<std::size_t>(column)] = {static_cast<std::size_t>(line),
                                                     products(line, column) < 0.0 ? -1.0 : 1.0};
  }
  return memberships;
}

/// Columns that vary the most, as first lines.
Eigen::MatrixXd first_lines(const Eigen::MatrixXd& columns, std::size_t size) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(columns.cols()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::ranges::greater{},
                           [&](Eigen::Index i) { return columns.col(i).squaredNorm(); });
  Eigen::MatrixXd lines(columns.rows(), size);
  for (std::size_t i = 0; i < size; ++i) {
    lines.col(static_cast<Eigen::Index>(i)) = columns.col(order[i]).normalized();
  }
  return lines;
}

std::vector<Membership> cluster_lines(const Eigen::MatrixXd& columns, std::size_t size) {
  Eigen::MatrixXd lines = first_lines(columns, size);
  std::vector<Membership> memberships = nearest_lines(columns, lines);
  for (int round = 0; round < line_rounds; ++round) {
    lines.setZero();
    for (std::size_t i = 0; i < memberships.size(); ++i) {
      lines.col(static_cast<Eigen::Index>(memberships[i].sum)) +=
          memberships[i].sign * columns.col(static_cast<Eigen::Index>(i));
    }
    for (auto line : lines.colwise()) line.normalize();
    memberships = nearest_lines(columns, lines);
  }
  return memberships;
}

std::vector<Direction> signed_sums(const VectorTable& collection,
                                   std::span<const MetricBlock> blocks, std::size_t size) {
  std::size_t end = 0;
  for (const MetricBlock& block : blocks) end = std::max(end, block.first + block.count);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(end));
  for (const MetricBlock& block : blocks) {
    weights.segment(static_cast<Eigen::Index>(block.first), static_cast<Eigen::Index>(block.count))
        .setConstant(block.weight);
  }
  const Eigen::MatrixXd columns =
      sample_block(collection, {.first = 0, .count = end, .norm = PointNorm::l1}) *
      weights.asDiagonal();
  size = std::min(size, end);
  std::vector<Direction> directions(
      size, {.coefficients = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(end))});
  const std::vector<Membership> memberships = cluster_lines(columns, size);
  for (std::size_t i = 0; i < end; ++i) {
    const auto index = static_cast<Eigen::Index>(i);
    directions[memberships[i].sum].coefficients[index] = memberships[i].sign * weights[index];
  }
  return directions;
}

}  // namespace

MetricSketch::MetricSketch(const VectorTable& collection, std::span<const MetricBlock> blocks,
                           std::size_t size)
    : norm_(blocks.front().norm) {
  for (const MetricBlock& block : blocks) largest_weight_ = std::max(largest_weight_, block.weight);
  const std::span<const float> origin = collection.values(collection.size() / 2);
  for (const Direction& direction : norm_ == PointNorm::l1
                                        ? signed_sums(collection, blocks, size)
                                        : principal_axes(collection, blocks, size)) {
    Axis axis;
    for (std::size_t i = 0; i < static_cast<std::size_t>(direction.coefficients.size()); ++i) {
      const double coefficient = direction.coefficients[static_cast<Eigen::Index>(i)];
      if (coefficient == 0.0) continue;
      axis.terms.push_back({direction.first + i, coefficient});
      axis.offset += coefficient * origin[direction.first + i];
    }
    axes_.push_back(std::move(axis));
  }
}

void MetricSketch::write(std::span<const float> vector, std::span<float> sketch) const {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    double sum = -axes_[i].offset;
    for (const Axis::Term& term : axes_[i].terms) sum += term.coefficient * vector[term.index];
    sketch[i] = static_cast<float>(sum);
  }
}

// A number of a sketch is at most the weighted magnitude of the vector and of the origin, the
// latter being one of the collection; its rounding to single precision dwarfs all others.
double MetricSketch::margin(double magnitude) const {
  constexpr double epsilon = std::numeric_limits<float>::epsilon();
  return 4.0 * epsilon * static_cast<double>(axes_.size()) * largest_weight_ * magnitude;
}

}  // namespace mdbd
