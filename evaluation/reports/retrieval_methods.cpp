#include "evaluation/reports/retrieval_methods.h"

#include <algorithm>

#include <fmt/format.h>

#include "evaluation/rivals/d2.h"
#include "evaluation/rivals/distance_harmonics.h"
#include "evaluation/rivals/esf.h"
#include "evaluation/rivals/gasd.h"
#include "evaluation/signature_terms.h"
#include "features/core/errors.h"
#include "features/descriptor/fused_signature.h"
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
           {.norm = VectorNorm::l1, .count = d2_bins}},
          {"SH of distances",
           fmt::format("{} spheres, degree {}, Gaussian", distance_shells, distance_degree),
           [](const TriangleMesh& mesh, std::uint64_t) { return compute_distance_harmonics(mesh); },
           {.norm = VectorNorm::l1, .count = distance_harmonics_size}}};
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
                const ComparedSignature& signature, std::vector<DistanceTerm> terms,
                bool is_rival = false) {
  std::vector<std::string> labels;
  for (const LabelledModel& model : comparison.models) labels.push_back(model.label);
  DistanceMatrix distances = vector_distances(signature.vectors, terms);
  RetrievalMeasures measures = measure_retrieval(distances, labels);
  comparison.methods.push_back({std::move(name), signature.name, is_rival, std::move(terms),
                                std::move(distances), std::move(measures)});
}

constexpr std::size_t own_signatures = 2;

/// mdbd-100 with the similarity distance (paper, section 5.2), its parts, and mdbd-fused.
void add_own_methods(RetrievalComparison& comparison, const EvaluationInput& input) {
  const Recipe& recipe = input.cache.recipe();
  const std::vector<DistanceTerm> paper = signature_terms(SignatureKind::mdbd_100, recipe);
  const ComparedSignature& signature = comparison.signatures[0];
  add_method(comparison, signature.name, signature, paper);
  add_method(comparison, "radii alone", signature, {paper[0]});
  DistanceTerm walk = paper[1];
  walk.weight = 1.0;
  add_method(comparison, "walk alone", signature, {walk});
  const ComparedSignature& fused = comparison.signatures[1];
  add_method(comparison, fused.name, fused, signature_terms(SignatureKind::mdbd_fused, recipe));
  if (input.signature == SignatureKind::mdbd_fused) comparison.measured = 3;
}

}  // namespace

RetrievalComparison compare_retrieval(const EvaluationInput& input, bool has_rivals) {
  // mdbd-100 is stored; mdbd-fused follows from the balls.
  const CleanModels clean =
      describe_clean_models({input.collection, input.cache, input.seed, SignatureKind::mdbd_100});
  const std::vector<Rival> rivals = has_rivals ? list_rivals() : std::vector<Rival>{};
  std::vector<SignatureVectors> computed;
  for (const Rival& rival : rivals) computed.push_back(compute_rival(input, clean, rival));

  RetrievalComparison comparison;
  comparison.signatures = {{std::string(signature_mdbd_100), {}},
                           {std::string(signature_mdbd_fused), {}}};
  for (const Rival& rival : rivals) comparison.signatures.push_back({rival.name, {}});
  for (std::size_t i = 0; i < clean.models.size(); ++i) {
    const bool is_complete =
        std::ranges::all_of(computed, [&](const auto& vectors) { return vectors[i].has_value(); });
    if (!is_complete) {
      ++comparison.left_out;
      continue;
    }
    comparison.models.push_back(clean.models[i]);
    const DescribedModel& model = clean.descriptions[i];
    comparison.signatures[0].vectors.push_back(model.descriptor);
    comparison.signatures[1].vectors.push_back(compute_fused_signature(model.balls));
    for (std::size_t rival = 0; rival < rivals.size(); ++rival) {
      comparison.signatures[own_signatures + rival].vectors.push_back(*computed[rival][i]);
    }
  }
  add_own_methods(comparison, input);
  for (std::size_t rival = 0; rival < rivals.size(); ++rival) {
    add_method(comparison, rivals[rival].name, comparison.signatures[own_signatures + rival],
               {rivals[rival].term}, true);
  }
  return comparison;
}

}  // namespace mdbd
