#include "query/signature_metric.h"

#include <numeric>

#include "features/descriptor/fused_signature.h"
#include "features/descriptor/similarity_distance.h"

namespace mdbd {
namespace {

class SimilarityMetric final : public SignatureMetric {
 public:
  SimilarityMetric(int radius_count, double walk_weight)
      : radius_count_(radius_count), walk_weight_(walk_weight) {}

  PointNorm norm() const override { return PointNorm::l2; }

  std::vector<float> point(std::span<const float> vector) const override {
    std::vector<float> result(vector.begin(), vector.end());
    for (std::size_t i = least_size(); i < result.size(); ++i) {
      result[i] = static_cast<float>(walk_weight_ * result[i]);
    }
    return result;
  }

  std::vector<std::string_view> part_names() const override { return {"radii", "walk"}; }

  std::vector<double> parts(std::span<const float> f, std::span<const float> g) const override {
    const SimilarityDistance distance = similarity_distance(f, g, radius_count_, walk_weight_);
    return {distance.radii, distance.walk};
  }

  double distance(std::span<const float> f, std::span<const float> g) const override {
    return similarity_distance(f, g, radius_count_, walk_weight_).total;
  }

  std::size_t least_size() const override { return static_cast<std::size_t>(radius_count_); }

 private:
  int radius_count_;
  double walk_weight_;
};

class FusedMetric final : public SignatureMetric {
 public:
  PointNorm norm() const override { return PointNorm::l1; }

  std::vector<float> point(std::span<const float> vector) const override {
    return {vector.begin(), vector.end()};
  }

  std::vector<std::string_view> part_names() const override {
    std::vector<std::string_view> names;
    for (const SignaturePart& part : fused_parts) names.push_back(part.name);
    return names;
  }

  std::vector<double> parts(std::span<const float> f, std::span<const float> g) const override {
    const auto distances = fused_part_distances(f, g);
    return {distances.begin(), distances.end()};
  }

  double distance(std::span<const float> f, std::span<const float> g) const override {
    const auto distances = fused_part_distances(f, g);
    return std::accumulate(distances.begin(), distances.end(), 0.0);
  }

  std::size_t least_size() const override { return fused_size; }
};

}  // namespace

std::unique_ptr<const SignatureMetric> similarity_metric(int radius_count, double walk_weight) {
  return std::make_unique<SimilarityMetric>(radius_count, walk_weight);
}

std::unique_ptr<const SignatureMetric> fused_metric() { return std::make_unique<FusedMetric>(); }

}  // namespace mdbd
