#include "evaluation/measures/vector_distance.h"

#include <cmath>

namespace mdbd {
namespace {

double contribution(VectorNorm norm, double a, double b) {
  const double difference = a - b;
  if (norm == VectorNorm::l1) return std::abs(difference);
  if (norm == VectorNorm::l2) return difference * difference;
  return a + b > 0 ? difference * difference / (a + b) : 0.0;
}

}  // namespace

std::string_view to_string(VectorNorm norm) {
  if (norm == VectorNorm::l1) return "l1";
  return norm == VectorNorm::l2 ? "l2" : "chi_square";
}

double vector_distance(std::span<const float> a, std::span<const float> b,
                       std::span<const DistanceTerm> terms) {
  double distance = 0.0;
  for (const DistanceTerm& term : terms) {
    double sum = 0.0;
    for (std::size_t i = term.first; i < term.first + term.count; ++i) {
      sum += contribution(term.norm, static_cast<double>(a[i]), static_cast<double>(b[i]));
    }
    distance += term.weight * (term.norm == VectorNorm::l2 ? std::sqrt(sum) : sum);
  }
  return distance;
}

DistanceMatrix vector_distances(std::span<const std::vector<float>> vectors,
                                std::span<const DistanceTerm> terms) {
  DistanceMatrix matrix(vectors.size());
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      matrix(i, j) = matrix(j, i) = vector_distance(vectors[i], vectors[j], terms);
    }
  }
  return matrix;
}

}  // namespace mdbd
