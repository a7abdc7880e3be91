#include "features/decomposition/max_min_program.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "features/core/vectorised.h"

namespace mdbd {
namespace {

constexpr int columns = 4;  // as many variables are nonbasic at any time
constexpr int lanes = 4;    // rows are worked on in groups of so many
constexpr int max_pivots = 64;
constexpr double pivot_tolerance = 1e-11;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Calls visit(r) for all rows, in groups of lanes.
template <int rows, typename Visitor>
MDBD_PART_OF_CALLER inline void for_each_row(Visitor&& visit) {
  static_assert(rows % lanes == 0);
  for (int begin = 0; begin < rows; begin += lanes) {
    MDBD_LANES
    for (int i = 0; i < lanes; ++i) visit(begin + i);
  }
}

// Maximise t with t <= f_i(s). In u, measured along the axes from the corner of the box where the
// function that allows the least is largest (so 0 <= u <= size), with slacks z_i = f_i(u) - t >= 0.
// Variables 0, 1, 2 are u, variable 3 + i is z_i. Each basic variable and t are affine in the
// nonbasic ones, which are all zero: a variable at its upper bound is replaced by its complement
// ("flipped"). The tableau is stored by columns of a fixed number of rows, enough for all
// functions; those beyond the last are zero.
template <int rows>
class Simplex {
 public:
  MDBD_PART_OF_CALLER Simplex(std::span<const AffineFunction> functions, double half_size)
      : size_(2 * half_size), half_size_(half_size) {
    choose_corner(functions);
    const auto count = static_cast<int>(functions.size());
    std::array<double, rows> at_corner{};
    int lowest = 0;
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector3d& slope = functions[i].slope;
      at_corner[i] =
          functions[i].offset - half_size * (direction_[0] * slope[0] + direction_[1] * slope[1] +
                                             direction_[2] * slope[2]);
      lowest = at_corner[i] < at_corner[lowest] ? i : lowest;
    }
    // t = f_lowest - z_lowest is substituted everywhere.
    const AffineFunction& base = functions[lowest];
    nonbasic_ = {0, 1, 2, 3 + lowest};
    objective_constant_ = at_corner[lowest];
    for (int c = 0; c < 3; ++c) objective_[c] = direction_[c] * base.slope[c];
    objective_[3] = -1.0;
    for (int i = 0; i < count; ++i) {
      basic_[row_count_] = 3 + i;
      upper_bound_[row_count_] = infinity;
      constants_[row_count_] = std::max(0.0, at_corner[i] - at_corner[lowest]);
      for (int c = 0; c < 3; ++c) {
        coefficients_[c][row_count_] = direction_[c] * (functions[i].slope[c] - base.slope[c]);
      }
      coefficients_[3][row_count_] = 1.0;
      row_count_ += i == lowest ? 0 : 1;
    }
    for (int r = row_count_; r < rows; ++r) {
      constants_[r] = 0.0;
      upper_bound_[r] = infinity;
      for (auto& column : coefficients_) column[r] = 0.0;
    }
  }

  MDBD_PART_OF_CALLER bool solve() {
    for (int pivots = 0; pivots < max_pivots; ++pivots) {
      const int entering = choose_entering();
      if (entering < 0) return true;
      if (!advance(entering)) return false;
    }
    return false;
  }

  MDBD_PART_OF_CALLER MaxMinSolution solution() const {
    std::array<double, 3 + rows> values{};
    for (int r = 0; r < row_count_; ++r) values[basic_[r]] = constants_[r];
    MaxMinSolution solution{objective_constant_, Eigen::Vector3d::Zero(), 0};
    for (int c = 0; c < 3; ++c) {
      const double along = flipped_[c] ? size_ - values[c] : values[c];
      solution.point[c] = direction_[c] * (along - half_size_);
    }
    std::uint64_t nonbasic = 0;
    for (const int variable : nonbasic_) nonbasic |= std::uint64_t{1} << variable;
    solution.binding = static_cast<std::uint32_t>(nonbasic >> 3);
    return solution;
  }

 private:
  using Column = std::array<double, rows>;

  MDBD_PART_OF_CALLER void choose_corner(std::span<const AffineFunction> functions) {
    double least = infinity;
    const AffineFunction* allows_least = functions.data();
    for (const AffineFunction& f : functions) {
      const double largest = f.offset + half_size_ * (std::abs(f.slope[0]) + std::abs(f.slope[1]) +
                                                      std::abs(f.slope[2]));
      allows_least = largest < least ? &f : allows_least;
      least = std::min(least, largest);
    }
    for (int c = 0; c < 3; ++c) direction_[c] = allows_least->slope[c] > 0 ? -1.0 : 1.0;
  }

  MDBD_PART_OF_CALLER int choose_entering() const {
    int best = -1;
    double steepest = pivot_tolerance;
    for (int c = 0; c < columns; ++c) {
      best = objective_[c] > steepest ? c : best;
      steepest = std::max(steepest, objective_[c]);
    }
    return best;
  }

  // Increases the entering variable until it or a basic variable meets a bound; false if rounding
  // hides every bound.
  MDBD_PART_OF_CALLER bool advance(int entering) {
    const Column& rates = coefficients_[entering];
    alignas(32) Column limits;
    for_each_row<rows>([&](int r) {
      const double rate = rates[r];
      const double room = rate < 0.0 ? constants_[r] : upper_bound_[r] - constants_[r];
      limits[r] = std::abs(rate) > pivot_tolerance ? room / std::abs(rate) : infinity;
    });
    double step = nonbasic_[entering] < 3 ? size_ : infinity;
    int leaving = -1;
    for (int r = 0; r < row_count_; ++r) {
      leaving = limits[r] < step ? r : leaving;
      step = std::min(step, std::max(0.0, limits[r]));
    }
    if (step == infinity) return false;
    if (leaving < 0) {
      flip_nonbasic(entering);
    } else {
      if (rates[leaving] > 0) flip_basic(leaving);
      pivot(leaving, entering);
    }
    return true;
  }

  MDBD_PART_OF_CALLER void flip_nonbasic(int c) {
    flipped_[nonbasic_[c]] = !flipped_[nonbasic_[c]];
    objective_constant_ += objective_[c] * size_;
    objective_[c] = -objective_[c];
    Column& column = coefficients_[c];
    for_each_row<rows>([&](int r) {
      constants_[r] += column[r] * size_;
      column[r] = -column[r];
    });
  }

  MDBD_PART_OF_CALLER void flip_basic(int r) {
    flipped_[basic_[r]] = !flipped_[basic_[r]];
    constants_[r] = size_ - constants_[r];
    for (auto& column : coefficients_) column[r] = -column[r];
  }

  MDBD_PART_OF_CALLER void pivot(int pivot_row, int c) {
    const double divisor = -1.0 / coefficients_[c][pivot_row];
    const double constant = constants_[pivot_row] * divisor;
    std::array<double, columns> solved;
    for (int k = 0; k < columns; ++k) solved[k] = coefficients_[k][pivot_row] * divisor;
    solved[c] = -divisor;
    alignas(32) Column factors;
    for_each_row<rows>([&](int r) {
      factors[r] = coefficients_[c][r];
      coefficients_[c][r] = 0.0;
      constants_[r] += factors[r] * constant;
    });
    const double objective_factor = std::exchange(objective_[c], 0.0);
    objective_constant_ += objective_factor * constant;
    for (int k = 0; k < columns; ++k) {
      Column& column = coefficients_[k];
      const double factor = solved[k];
      objective_[k] += objective_factor * factor;
      for_each_row<rows>([&](int r) { column[r] += factors[r] * factor; });
      column[pivot_row] = factor;
    }
    constants_[pivot_row] = constant;
    std::swap(basic_[pivot_row], nonbasic_[c]);
    upper_bound_[pivot_row] = basic_[pivot_row] < 3 ? size_ : infinity;
  }

  double size_;
  double half_size_;
  int row_count_ = 0;
  alignas(32) Column constants_;
  alignas(32) std::array<Column, columns> coefficients_;
  alignas(32) Column upper_bound_;
  std::array<int, rows> basic_;
  std::array<int, columns> nonbasic_;
  std::array<double, 3> direction_{1.0, 1.0, 1.0};  // of u, along each axis
  std::array<bool, 3> flipped_{};
  double objective_constant_ = 0.0;
  std::array<double, columns> objective_;
};

// What each function alone allows.
MaxMinSolution separate_bound(std::span<const AffineFunction> functions, double half_size) {
  double value = infinity;
  for (const AffineFunction& f : functions) {
    value = std::min(value, f.offset + half_size * f.slope.lpNorm<1>());
  }
  return {value, Eigen::Vector3d::Zero(), 0};
}

template <int rows>
MDBD_PART_OF_CALLER inline MaxMinSolution maximise_with(std::span<const AffineFunction> functions,
                                                        double half_size) {
  Simplex<rows> simplex(functions, half_size);
  return simplex.solve() ? simplex.solution() : separate_bound(functions, half_size);
}

}  // namespace

MDBD_VECTORISED
MaxMinSolution maximise_minimum(std::span<const AffineFunction> functions, double half_size) {
  const std::size_t count = functions.size();
  if (count <= 8) return maximise_with<8>(functions, half_size);
  if (count <= 16) return maximise_with<16>(functions, half_size);
  return maximise_with<max_min_capacity>(functions, half_size);
}

}  // namespace mdbd
