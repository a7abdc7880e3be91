#include "query/signature_metric.h"

#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "features/descriptor/chirality.h"
#include "features/descriptor/fused_signature.h"
#include "features/descriptor/similarity_distance.h"

namespace mdbd {
namespace {

class SimilarityMetric final : public SignatureMetric {
 public:
  SimilarityMetric(int radius_count, double walk_weight)
      : radius_count_(radius_count), walk_weight_(walk_weight) {}

  std::vector<MetricBlock> blocks(std::size_t size) const override {
    return {{.first = 0, .count = least_size(), .norm = PointNorm::l2},
            {.first = least_size(),
             .count = size - least_size(),
             .weight = walk_weight_,
             .norm = PointNorm::l2}};
  }

  std::vector<std::string_view> part_names() const override { return {"radii", "walk"}; }

  std::vector<double> parts(std::span<const float> f, std::span<const float> g) const override {
    const SimilarityDistance distance = similarity_distance(f, g, radius_count_, walk_weight_);
    return {distance.radii, distance.walk};
  }

  double distance(std::span<const float> f, std::span<const float> g) const override {
    return similarity_distance(f, g, radius_count_, walk_weight_).total;
  }

  std::string number_name(std::size_t index) const override {
    return index < least_size() ? fmt::format("radius {}", index + 1)
                                : fmt::format("walk sum {}", index + 1 - least_size());
  }

  std::size_t least_size() const override { return static_cast<std::size_t>(radius_count_); }

 private:
  int radius_count_;
  double walk_weight_;
};

std::string_view trait_name(SurroundingsTrait trait) {
  switch (trait) {
    case SurroundingsTrait::offset:
      return "offset";
    case SurroundingsTrait::fill:
      return "log2 of fill";
  }
  return "";
}

std::string solid_number_name(std::size_t index) {
  constexpr std::size_t degrees = solid_degree + 1;
  return fmt::format("solid at {:.1f}, degree {}", solid_shell_nodes.node(index / degrees),
                     index % degrees);
}

std::string surroundings_number_name(const Surroundings& kind, std::size_t index) {
  const std::size_t proportions = index / surroundings_nodes;
  return fmt::format("{}: width {:.2f}, thickness {:.2f}, {} {:.2f}", kind.name,
                     proportion_nodes.node(proportions / surroundings_nodes),
                     proportion_nodes.node(proportions % surroundings_nodes),
                     trait_name(kind.trait),
                     trait_nodes(kind.trait).node(index % surroundings_nodes));
}

class FusedMetric final : public SignatureMetric {
 public:
  std::vector<MetricBlock> blocks(std::size_t /*size*/) const override {
    return {{.first = 0, .count = fused_size, .norm = PointNorm::l1}};
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

  std::string number_name(std::size_t index) const override {
    if (index < solid_size) return solid_number_name(index);
    const std::size_t after = index - solid_size;
    return surroundings_number_name(surroundings_kinds.at(after / surroundings_size),
                                    after % surroundings_size);
  }

  std::size_t least_size() const override { return fused_size; }
};

class ChiralMetric final : public SignatureMetric {
 public:
  explicit ChiralMetric(std::unique_ptr<const SignatureMetric> base)
      : base_(std::move(base)), norm_(base_->blocks(base_->least_size()).front().norm) {}

  std::vector<MetricBlock> blocks(std::size_t size) const override {
    std::vector<MetricBlock> blocks = base_->blocks(size - chirality_size);
    for (MetricBlock& block : blocks) block.first += chirality_size;
    blocks.push_back({.first = 0, .count = chirality_size, .norm = norm_});
    return blocks;
  }

  std::vector<std::string_view> part_names() const override {
    std::vector<std::string_view> names = base_->part_names();
    names.emplace_back("chirality");
    return names;
  }

  std::vector<double> parts(std::span<const float> f, std::span<const float> g) const override {
    std::vector<double> parts = base_->parts(without_chirality(f), without_chirality(g));
    parts.push_back(chirality_distance(f, g));
    return parts;
  }

  double distance(std::span<const float> f, std::span<const float> g) const override {
    return base_->distance(without_chirality(f), without_chirality(g)) + chirality_distance(f, g);
  }

  std::string number_name(std::size_t index) const override {
    return index < chirality_size ? fmt::format("chirality {}", index + 1)
                                  : base_->number_name(index - chirality_size);
  }

  std::size_t least_size() const override { return base_->least_size() + chirality_size; }

 private:
  static std::span<const float> without_chirality(std::span<const float> vector) {
    return vector.subspan(chirality_size);
  }

  double chirality_distance(std::span<const float> f, std::span<const float> g) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < chirality_size; ++i) {
      const double difference = double{f[i]} - double{g[i]};
      sum += norm_ == PointNorm::l1 ? std::abs(difference) : difference * difference;
    }
    return norm_ == PointNorm::l1 ? sum : std::sqrt(sum);
  }

  std::unique_ptr<const SignatureMetric> base_;
  PointNorm norm_;
};

}  // namespace

std::unique_ptr<const SignatureMetric> similarity_metric(int radius_count, double walk_weight) {
  return std::make_unique<SimilarityMetric>(radius_count, walk_weight);
}

std::unique_ptr<const SignatureMetric> fused_metric() { return std::make_unique<FusedMetric>(); }

std::unique_ptr<const SignatureMetric> chiral_metric(std::unique_ptr<const SignatureMetric> base) {
  return std::make_unique<ChiralMetric>(std::move(base));
}

}  // namespace mdbd
