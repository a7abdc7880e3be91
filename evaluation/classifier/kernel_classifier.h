#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "evaluation/classifier/classifier.h"

namespace mdbd {

/// Among which kernels and ridges the validation rows choose.
struct KernelClassifierOptions {
  /// Squared widths of the Gaussian, relative to the median squared distance of the training rows.
  std::vector<double> widths{2.0, 1.0, 0.5};
  std::vector<double> ridges{0.1, 0.01, 0.001};  ///< added to the diagonal of the kernel
};

/// The classes of rows by regularised least squares in the space of a Gaussian kernel (Rifkin, Yeo,
/// Poggio, Regularized Least-Squares Classification, 2003): one regression for each class, the
/// largest value wins, the first of equal ones. Width and ridge are those with which most of the
/// validation rows are right, the first of equal ones in the order of the options, of which the
/// smoothest should come first. Nothing is random.
/// @param validation without rows, the first width and ridge are taken
/// @param class_count may exceed the classes that occur
/// @throws InvalidInput if there are no training rows, rows differ in length, a label is not below
///         class_count, or an option is not positive or has no value
std::vector<std::size_t> classify_by_kernel(const LabelledRows& training,
                                            const LabelledRows& validation, std::size_t class_count,
                                            std::span<const std::vector<double>> rows,
                                            const KernelClassifierOptions& options = {});

}  // namespace mdbd
