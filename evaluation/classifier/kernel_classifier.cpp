#include "evaluation/classifier/kernel_classifier.h"

#include <algorithm>

#include <Eigen/Cholesky>

#include "features/core/errors.h"

namespace mdbd {
namespace {

using Rows = std::span<const std::vector<double>>;

void require_valid(const LabelledRows& data, std::size_t class_count, std::size_t columns) {
  if (data.rows.size() != data.labels.size()) {
    throw InvalidInput("rows and labels differ in number");
  }
  for (const std::size_t label : data.labels) {
    if (label >= class_count) throw InvalidInput("a label is not below the number of classes");
  }
  for (const std::vector<double>& row : data.rows) {
    if (row.size() != columns) throw InvalidInput("rows of features differ in length");
  }
}

void require_positive(std::span<const double> values) {
  if (values.empty() || !std::ranges::all_of(values, [](double value) { return value > 0; })) {
    throw InvalidInput("an option of the kernel is out of range");
  }
}

Eigen::MatrixXd to_matrix(Rows rows, std::size_t columns) {
  Eigen::MatrixXd matrix(rows.size(), columns);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() != columns) throw InvalidInput("rows of features differ in length");
    matrix.row(static_cast<Eigen::Index>(i)) =
        Eigen::Map<const Eigen::RowVectorXd>(rows[i].data(), static_cast<Eigen::Index>(columns));
  }
  return matrix;
}

Eigen::MatrixXd squared_distances(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd distances(a.rows(), b.rows());
  for (Eigen::Index j = 0; j < b.rows(); ++j) {
    distances.col(j) = (a.rowwise() - b.row(j)).rowwise().squaredNorm();
  }
  return distances;
}

/// Of all pairs of different rows; 1 if that is 0.
double median_of_pairs(const Eigen::MatrixXd& distances) {
  std::vector<double> values;
  for (Eigen::Index j = 0; j < distances.cols(); ++j) {
    for (Eigen::Index i = 0; i < j; ++i) values.push_back(distances(i, j));
  }
  if (values.empty()) return 1.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle > 0 ? *middle : 1.0;
}

Eigen::MatrixXd kernel_of(const Eigen::MatrixXd& squared_distances, double squared_width) {
  return (squared_distances.array() / -squared_width).exp();
}

/// The class of the largest value of each row.
std::vector<std::size_t> winners(const Eigen::MatrixXd& values) {
  std::vector<std::size_t> classes;
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    Eigen::Index winner = 0;
    values.row(i).maxCoeff(&winner);
    classes.push_back(static_cast<std::size_t>(winner));
  }
  return classes;
}

std::size_t count_right(std::span<const std::size_t> found, std::span<const std::size_t> labels) {
  std::size_t right = 0;
  for (std::size_t i = 0; i < found.size(); ++i) right += found[i] == labels[i] ? 1 : 0;
  return right;
}

/// 1 in the column of each row's class.
Eigen::MatrixXd indicators(std::span<const std::size_t> labels, std::size_t class_count) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(labels.size()),
                                                 static_cast<Eigen::Index>(class_count));
  for (std::size_t i = 0; i < labels.size(); ++i) {
    result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(labels[i])) = 1.0;
  }
  return result;
}

}  // namespace

std::vector<std::size_t> classify_by_kernel(const LabelledRows& training,
                                            const LabelledRows& validation, std::size_t class_count,
                                            std::span<const std::vector<double>> rows,
                                            const KernelClassifierOptions& options) {
  if (training.rows.empty()) throw InvalidInput("there are no rows to train on");
  const std::size_t columns = training.rows.front().size();
  require_valid(training, class_count, columns);
  require_valid(validation, class_count, columns);
  require_positive(options.widths);
  require_positive(options.ridges);

  const Eigen::MatrixXd known = to_matrix(training.rows, columns);
  const Eigen::MatrixXd among = squared_distances(known, known);
  const Eigen::MatrixXd to_validation =
      squared_distances(to_matrix(validation.rows, columns), known);
  const Eigen::MatrixXd to_rows = squared_distances(to_matrix(rows, columns), known);
  const Eigen::MatrixXd targets = indicators(training.labels, class_count);
  const double median = median_of_pairs(among);

  std::vector<std::size_t> best;
  std::ptrdiff_t most_right = -1;
  for (const double width : options.widths) {
    const Eigen::MatrixXd kernel = kernel_of(among, width * median);
    for (const double ridge : options.ridges) {
      Eigen::MatrixXd regularised = kernel;
      regularised.diagonal().array() += ridge;
      const Eigen::MatrixXd weights = regularised.ldlt().solve(targets);
      const auto right = static_cast<std::ptrdiff_t>(count_right(
          winners(kernel_of(to_validation, width * median) * weights), validation.labels));
      if (right <= most_right) continue;
      most_right = right;
      best = winners(kernel_of(to_rows, width * median) * weights);
    }
  }
  return best;
}

}  // namespace mdbd
