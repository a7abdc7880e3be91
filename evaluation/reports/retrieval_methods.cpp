#include "evaluation/reports/retrieval_methods.h"

#include <algorithm>

#include <fmt/format.h>

#include "evaluation/rivals/d2.h"
#include "evaluation/rivals/esf.h"
#include "evaluation/rivals/gasd.h"
#include "features/core/descriptor.h"
#include "features/core/errors.h"
#include "features/shape_io/read_mesh.h"

namespace fs = std::filesystem;

namespace mdbd {
namespace {

/// What the comparison needs to know of a rival.
struct Rival {
  std::string name;
  std::string parameters;
  std::vector<float> (*compute)(const TriangleMesh&, std::uint64_t seed);
  DistanceTerm term;
};

/// Each with the norm that serves it best; docs/evaluation.md has the numbers of the others.
std::vector<Rival> list_rivals() {
  return {{"ESF",
           fmt::format("{} points", esf_points),
           compute_esf,
           {.norm = VectorNorm::l1, .count = esf_size}},
          {"GASD",
           fmt::format("{} points", gasd_points),
           compute_gasd,
           {.norm = VectorNorm::chi_square, .count = gasd_size}},
          {"D2",
           fmt::format("{} bins up to {} means, {} pairs", d2_bins, d2_range, d2_pairs),
           compute_d2,
           {.norm = VectorNorm::l1, .count = d2_bins}}};
}

SignatureVectors compute_rival(const EvaluationInput& input, const CleanModels& clean,
                               const Rival& rival) {
  const FileSignature signature{
      .name = fmt::format("{}, {}, seed {}", rival.name, rival.parameters, input.seed),
      .compute = [&](const fs::path& path) {
        return rival.compute(read_mesh(path).mesh, input.seed);
      }};
  return input.cache.compute_signature(clean.models, signature);
}

void add_method(RetrievalComparison& comparison, std::string name,
                const ComparedSignature& signature, std::vector<DistanceTerm> terms) {
  std::vector<std::string> labels;
  for (const LabelledModel& model : comparison.models) labels.push_back(model.label);
  DistanceMatrix distances = vector_distances(signature.vectors, terms);
  RetrievalMeasures measures = measure_retrieval(distances, labels);
  comparison.methods.push_back({std::move(name), signature.name, std::move(terms),
                                std::move(distances), std::move(measures)});
}

/// mdbd-100 with the similarity distance (paper, section 5.2), and its parts.
void add_mdbd_methods(RetrievalComparison& comparison, const Recipe& recipe) {
  const auto radius_count = static_cast<std::size_t>(recipe.descriptor_balls);
  const auto walk_count = static_cast<std::size_t>(recipe.walk_steps);
  const DistanceTerm radii{.count = radius_count};
  const DistanceTerm walk{.first = radius_count, .count = walk_count};
  DistanceTerm weighted_walk = walk;
  weighted_walk.weight = recipe.walk_weight;
  const ComparedSignature& signature = comparison.signatures.front();
  add_method(comparison, signature.name, signature, {radii, weighted_walk});
  add_method(comparison, "radii alone", signature, {radii});
  add_method(comparison, "walk alone", signature, {walk});
}

}  // namespace

RetrievalComparison compare_retrieval(const EvaluationInput& input, bool has_rivals) {
  const CleanModels clean = describe_clean_models(input);
  const std::vector<Rival> rivals = has_rivals ? list_rivals() : std::vector<Rival>{};
  std::vector<SignatureVectors> computed;
  for (const Rival& rival : rivals) computed.push_back(compute_rival(input, clean, rival));

  RetrievalComparison comparison;
  comparison.signatures.push_back({std::string(signature_mdbd_100), {}});
  for (const Rival& rival : rivals) comparison.signatures.push_back({rival.name, {}});
  for (std::size_t i = 0; i < clean.models.size(); ++i) {
    const bool is_complete =
        std::ranges::all_of(computed, [&](const auto& vectors) { return vectors[i].has_value(); });
    if (!is_complete) {
      ++comparison.left_out;
      continue;
    }
    comparison.models.push_back(clean.models[i]);
    comparison.signatures.front().vectors.push_back(clean.descriptions[i].descriptor);
    for (std::size_t rival = 0; rival < rivals.size(); ++rival) {
      comparison.signatures[rival + 1].vectors.push_back(*computed[rival][i]);
    }
  }
  add_mdbd_methods(comparison, input.cache.recipe());
  for (std::size_t rival = 0; rival < rivals.size(); ++rival) {
    add_method(comparison, rivals[rival].name, comparison.signatures[rival + 1],
               {rivals[rival].term});
  }
  return comparison;
}

}  // namespace mdbd
