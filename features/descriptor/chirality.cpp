#include "features/descriptor/chirality.h"

#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "features/descriptor/solid_frame.h"

namespace mdbd {
namespace {

constexpr std::array<double, 3> widths{0.5, 1.0, 2.0};
constexpr std::array<std::array<std::size_t, 2>, 3> pairs_of_widths{{{0, 1}, {0, 2}, {1, 2}}};

/// A tensor of degree 3 as a matrix for each value of its first index.
using Tensor = std::array<Eigen::Matrix3d, 3>;

/// The moments under one Gaussian.
struct Moments {
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Tensor tensor{Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero()};
};

// T_ijk less what has a trace: (u_k d_ij + u_j d_ik + u_i d_jk) / 5 with u the trace.
void remove_traces(Tensor& tensor) {
  const Eigen::Vector3d trace(tensor[0].trace(), tensor[1].trace(), tensor[2].trace());
  for (int i = 0; i < 3; ++i) {
    tensor[i].row(i) -= trace.transpose() / 5;
    tensor[i].col(i) -= trace / 5;
    tensor[i].diagonal().array() -= trace[i] / 5;
  }
}

/// @param balls in the frame of to_solid_frame()
Moments moments_of(std::span<const Ball> balls, double width) {
  Moments moments;
  double volume = 0.0;
  for (const Ball& ball : balls) {
    const Eigen::Vector3d& x = ball.center;
    const double ball_volume = ball.radius * ball.radius * ball.radius;
    const double weight = ball_volume * std::exp(-x.squaredNorm() / (2 * width * width));
    const Eigen::Matrix3d square = weight * x * x.transpose();
    volume += ball_volume;
    moments.vector += weight * x;
    moments.matrix += square;
    for (int i = 0; i < 3; ++i) moments.tensor[i] += x[i] * square;
  }
  moments.vector /= volume;
  moments.matrix /= volume;
  moments.matrix.diagonal().array() -= moments.matrix.trace() / 3;
  for (Eigen::Matrix3d& slice : moments.tensor) slice /= volume;
  remove_traces(moments.tensor);
  return moments;
}

double length(const Tensor& tensor) {
  return std::sqrt(tensor[0].squaredNorm() + tensor[1].squaredNorm() + tensor[2].squaredNorm());
}

/// The vector e_ijk M_jk.
Eigen::Vector3d axial(const Eigen::Matrix3d& m) {
  return {m(1, 2) - m(2, 1), m(2, 0) - m(0, 2), m(0, 1) - m(1, 0)};
}

/// The matrix A_ilm B_jlm.
Eigen::Matrix3d contract(const Tensor& a, const Tensor& b) {
  Eigen::Matrix3d result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result(i, j) = a[i].cwiseProduct(b[j]).sum();
  }
  return result;
}

/// T_ijk e_iab A_aj B_bk.
double contract(const Tensor& tensor, const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  double sum = 0.0;
  for (int j = 0; j < 3; ++j) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d cross = a.col(j).cross(b.col(k));
      for (int i = 0; i < 3; ++i) sum += tensor[i](j, k) * cross[i];
    }
  }
  return sum;
}

/// A product of the degree of one of its three factors.
float tempered(double product, double a, double b, double c) {
  const double lengths = std::cbrt(a * b * c);
  return lengths > 0 ? static_cast<float>(product / (lengths * lengths)) : 0.0F;
}

double dot(std::span<const float> f, std::span<const float> g) {
  double sum = 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) sum += static_cast<double>(f[i]) * g[i];
  return sum;
}

}  // namespace

std::string_view to_string(Hand hand) {
  switch (hand) {
    case Hand::none:
      return "none";
    case Hand::same:
      return "same";
    case Hand::mirrored:
      return "mirrored";
    case Hand::unclear:
      return "unclear";
  }
  return "";
}

std::vector<float> compute_chirality(std::span<const Ball> balls) {
  if (balls.empty()) return std::vector<float>(chirality_size, 0.0F);
  const std::vector<Ball> solid = to_solid_frame(balls);
  const std::array<Moments, 3> at{moments_of(solid, widths[0]), moments_of(solid, widths[1]),
                                  moments_of(solid, widths[2])};
  std::vector<float> result;
  result.reserve(chirality_size);
  result.push_back(tempered(at[0].vector.dot(at[1].vector.cross(at[2].vector)), at[0].vector.norm(),
                            at[1].vector.norm(), at[2].vector.norm()));
  for (const auto& [a, b] : pairs_of_widths) {
    const Eigen::Vector3d of_matrices = axial(at[a].matrix * at[b].matrix);
    const Eigen::Vector3d of_tensors = axial(contract(at[a].tensor, at[b].tensor));
    const std::array<double, 2> matrices{at[a].matrix.norm(), at[b].matrix.norm()};
    const std::array<double, 2> tensors{length(at[a].tensor), length(at[b].tensor)};
    for (const Moments& u : at) {
      result.push_back(
          tempered(u.vector.dot(of_matrices), u.vector.norm(), matrices[0], matrices[1]));
      result.push_back(tempered(contract(u.tensor, at[a].matrix, at[b].matrix), length(u.tensor),
                                matrices[0], matrices[1]));
      result.push_back(tempered(u.vector.dot(of_tensors), u.vector.norm(), tensors[0], tensors[1]));
    }
  }
  return result;
}

Hand compare_hands(std::span<const float> f, std::span<const float> g) {
  constexpr double least_cosine = 0.5;
  const double f_length = std::sqrt(dot(f, f));
  const double g_length = std::sqrt(dot(g, g));
  if (f_length < least_chirality || g_length < least_chirality) return Hand::none;
  const double cosine = dot(f, g) / (f_length * g_length);
  if (cosine > least_cosine) return Hand::same;
  return cosine < -least_cosine ? Hand::mirrored : Hand::unclear;
}

}  // namespace mdbd
