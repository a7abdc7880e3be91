#include "features/decomposition/max_min_program.h"

#include <algorithm>
#include <array>
#include <limits>

namespace mdbd {
namespace {

constexpr int columns = 4;  // as many variables are nonbasic at any time
constexpr int max_rows = max_min_capacity + 3;
constexpr int max_pivots = 64;
constexpr double pivot_tolerance = 1e-11;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Maximise t with t <= f_i(s). In u = s + half_size (so 0 <= u <= size) and slacks
// z_i = f_i(u) - t >= 0. Variables 0, 1, 2 are u, variable 3 + i is z_i. Each basic variable and t
// are affine in the nonbasic ones, which are all zero: a variable at its upper bound is replaced by
// its complement ("flipped").
class Simplex {
 public:
  Simplex(std::span<const AffineFunction> functions, double half_size)
      : size_(2 * half_size), half_size_(half_size) {
    const Eigen::Vector3d corner = Eigen::Vector3d::Constant(-half_size);
    const auto at_corner = [&](const AffineFunction& f) { return f.offset + f.slope.dot(corner); };
    int lowest = 0;
    for (int i = 1; i < static_cast<int>(functions.size()); ++i) {
      if (at_corner(functions[i]) < at_corner(functions[lowest])) lowest = i;
    }
    // t = f_lowest - z_lowest is substituted everywhere.
    const AffineFunction& base = functions[lowest];
    nonbasic_ = {0, 1, 2, 3 + lowest};
    objective_ = {at_corner(base), {base.slope[0], base.slope[1], base.slope[2], -1.0}};
    for (int i = 0; i < static_cast<int>(functions.size()); ++i) {
      if (i == lowest) continue;
      const Eigen::Vector3d slope = functions[i].slope - base.slope;
      basic_[row_count_] = 3 + i;
      rows_[row_count_++] = {std::max(0.0, at_corner(functions[i]) - at_corner(base)),
                             {slope[0], slope[1], slope[2], 1.0}};
    }
  }

  bool solve() {
    for (int pivots = 0; pivots < max_pivots; ++pivots) {
      const int entering = choose_entering();
      if (entering < 0) return true;
      if (!advance(entering)) return false;
    }
    return false;
  }

  MaxMinSolution solution() const {
    MaxMinSolution solution{objective_.constant, Eigen::Vector3d::Zero(), 0};
    for (const int variable : nonbasic_) {
      set_coordinate(variable, 0.0, solution.point);
      if (variable >= 3) solution.binding |= 1U << (variable - 3);
    }
    for (int r = 0; r < row_count_; ++r) {
      set_coordinate(basic_[r], rows_[r].constant, solution.point);
    }
    return solution;
  }

 private:
  struct Row {
    double constant;
    std::array<double, columns> coefficients;
  };

  double upper_bound(int variable) const { return variable < 3 ? size_ : infinity; }

  void set_coordinate(int variable, double value, Eigen::Vector3d& point) const {
    if (variable >= 3) return;
    point[variable] = (flipped_[variable] ? size_ - value : value) - half_size_;
  }

  int choose_entering() const {
    int best = -1;
    double steepest = pivot_tolerance;
    for (int c = 0; c < columns; ++c) {
      if (objective_.coefficients[c] > steepest) {
        steepest = objective_.coefficients[c];
        best = c;
      }
    }
    return best;
  }

  // Increases the entering variable until it or a basic variable meets a bound; false if rounding
  // hides every bound.
  bool advance(int entering) {
    double step = upper_bound(nonbasic_[entering]);
    int leaving = -1;
    bool leaves_at_upper = false;
    for (int r = 0; r < row_count_; ++r) {
      const double rate = rows_[r].coefficients[entering];
      double limit = infinity;
      if (rate < -pivot_tolerance) {
        limit = rows_[r].constant / -rate;
      } else if (rate > pivot_tolerance) {
        limit = (upper_bound(basic_[r]) - rows_[r].constant) / rate;
      }
      if (limit < step) {
        step = std::max(0.0, limit);
        leaving = r;
        leaves_at_upper = rate > 0;
      }
    }
    if (step == infinity) return false;
    if (leaving < 0) {
      flip_nonbasic(entering);
    } else {
      if (leaves_at_upper) flip_basic(leaving);
      pivot(leaving, entering);
    }
    return true;
  }

  void flip_nonbasic(int column) {
    flipped_[nonbasic_[column]] = !flipped_[nonbasic_[column]];
    const auto substitute = [&](Row& row) {
      row.constant += row.coefficients[column] * size_;
      row.coefficients[column] = -row.coefficients[column];
    };
    substitute(objective_);
    std::for_each_n(rows_.begin(), row_count_, substitute);
  }

  void flip_basic(int r) {
    flipped_[basic_[r]] = !flipped_[basic_[r]];
    rows_[r].constant = size_ - rows_[r].constant;
    for (double& coefficient : rows_[r].coefficients) coefficient = -coefficient;
  }

  void pivot(int r, int column) {
    const double divisor = -1.0 / rows_[r].coefficients[column];
    Row solved = rows_[r];
    solved.coefficients[column] = -1.0;
    solved.constant *= divisor;
    for (double& coefficient : solved.coefficients) coefficient *= divisor;
    const auto substitute = [&](Row& row) {
      const double factor = row.coefficients[column];
      row.constant += factor * solved.constant;
      row.coefficients[column] = 0.0;
      for (int c = 0; c < columns; ++c) row.coefficients[c] += factor * solved.coefficients[c];
    };
    substitute(objective_);
    std::for_each_n(rows_.begin(), row_count_, substitute);
    rows_[r] = solved;
    std::swap(basic_[r], nonbasic_[column]);
  }

  double size_;
  double half_size_;
  int row_count_ = 0;
  std::array<Row, max_rows> rows_;
  std::array<int, max_rows> basic_;
  std::array<int, columns> nonbasic_;
  std::array<bool, 3> flipped_{};
  Row objective_;
};

// What each function alone allows.
MaxMinSolution separate_bound(std::span<const AffineFunction> functions, double half_size) {
  double value = infinity;
  for (const AffineFunction& f : functions) {
    value = std::min(value, f.offset + half_size * f.slope.lpNorm<1>());
  }
  return {value, Eigen::Vector3d::Zero(), 0};
}

}  // namespace

MaxMinSolution maximise_minimum(std::span<const AffineFunction> functions, double half_size) {
  Simplex simplex(functions, half_size);
  return simplex.solve() ? simplex.solution() : separate_bound(functions, half_size);
}

}  // namespace mdbd
