#include "evaluation/measures/retrieval_measures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "features/core/errors.h"

namespace mdbd {
namespace {

void check(const DistanceMatrix& distances, const std::vector<std::string>& labels) {
  if (distances.size() != labels.size()) {
    throw InvalidInput(
        fmt::format("retrieval: {} models but {} labels", distances.size(), labels.size()));
  }
  for (std::size_t i = 0; i < distances.size(); ++i) {
    for (std::size_t j = 0; j < distances.size(); ++j) {
      if (!std::isfinite(distances(i, j))) {
        throw InvalidInput(
            fmt::format("retrieval: the distance from model {} to model {} is not finite", i, j));
      }
    }
  }
}

/// For each answer whether it is in the query's class.
std::vector<bool> find_hits(const DistanceMatrix& distances, const std::vector<std::string>& labels,
                            std::size_t query) {
  std::vector<bool> hits;
  for (const std::size_t model : rank_models(distances, query)) {
    hits.push_back(labels[model] == labels[query]);
  }
  return hits;
}

std::size_t count_hits(const std::vector<bool>& hits, std::size_t answers) {
  const auto end = hits.begin() + static_cast<std::ptrdiff_t>(std::min(answers, hits.size()));
  return static_cast<std::size_t>(std::count(hits.begin(), end, true));
}

double ratio(std::size_t part, std::size_t whole) {
  return static_cast<double>(part) / static_cast<double>(whole);
}

double e_measure(const std::vector<bool>& hits, std::size_t relevant) {
  const std::size_t answers = std::min(hits.size(), e_measure_answers);
  const std::size_t found = count_hits(hits, answers);
  if (found == 0) return 0.0;
  return 2.0 / (1.0 / ratio(found, answers) + 1.0 / ratio(found, relevant));
}

/// What a hit at a rank, counted from 1, is worth.
double gain(std::size_t rank) { return rank == 1 ? 1.0 : 1.0 / std::log2(rank); }

double discounted_gain(const std::vector<bool>& hits, std::size_t relevant) {
  double sum = 0.0;
  double best = 0.0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i]) sum += gain(i + 1);
    if (i < relevant) best += gain(i + 1);
  }
  return sum / best;
}

/// The precision at each hit.
std::vector<double> precisions_at_hits(const std::vector<bool>& hits) {
  std::vector<double> precisions;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i]) precisions.push_back(ratio(precisions.size() + 1, i + 1));
  }
  return precisions;
}

std::array<double, recall_levels> interpolate(std::vector<double> precisions) {
  for (std::size_t i = precisions.size() - 1; i-- > 0;) {
    precisions[i] = std::max(precisions[i], precisions[i + 1]);
  }
  std::array<double, recall_levels> curve{};
  for (std::size_t level = 0; level < recall_levels; ++level) {
    // The first hit with a recall of at least (level + 1) / 20, in integers.
    const std::size_t hits = ((level + 1) * precisions.size() + recall_levels - 1) / recall_levels;
    curve[level] = precisions[hits - 1];
  }
  return curve;
}

/// @pre relevant, the number of hits, is not 0
RetrievalScores score_query(const std::vector<bool>& hits, std::size_t relevant) {
  const std::vector<double> precisions = precisions_at_hits(hits);
  RetrievalScores scores;
  scores.nearest_neighbour = hits.front() ? 1.0 : 0.0;
  scores.first_tier = ratio(count_hits(hits, relevant), relevant);
  scores.second_tier = ratio(count_hits(hits, 2 * relevant), relevant);
  scores.e_measure = e_measure(hits, relevant);
  scores.discounted_gain = discounted_gain(hits, relevant);
  scores.average_precision =
      std::accumulate(precisions.begin(), precisions.end(), 0.0) / static_cast<double>(relevant);
  scores.precision = interpolate(precisions);
  return scores;
}

/// The mean of some scores.
class Mean {
 public:
  void add(const RetrievalScores& scores) {
    for (const auto field : fields) sum_.*field += scores.*field;
    for (std::size_t i = 0; i < recall_levels; ++i) sum_.precision[i] += scores.precision[i];
    ++count_;
  }

  RetrievalScores get() const {
    RetrievalScores mean = sum_;
    for (const auto field : fields) mean.*field /= count_;
    for (double& precision : mean.precision) precision /= count_;
    return mean;
  }

 private:
  static constexpr std::array fields = {
      &RetrievalScores::nearest_neighbour, &RetrievalScores::first_tier,
      &RetrievalScores::second_tier,       &RetrievalScores::e_measure,
      &RetrievalScores::discounted_gain,   &RetrievalScores::average_precision};

  RetrievalScores sum_;
  double count_ = 0.0;
};

}  // namespace

std::vector<std::size_t> rank_models(const DistanceMatrix& distances, std::size_t query) {
  std::vector<std::size_t> ranking(distances.size());
  std::iota(ranking.begin(), ranking.end(), 0);
  ranking.erase(ranking.begin() + static_cast<std::ptrdiff_t>(query));
  std::ranges::stable_sort(ranking, {}, [&](std::size_t model) { return distances(query, model); });
  return ranking;
}

RetrievalMeasures measure_retrieval(const DistanceMatrix& distances,
                                    const std::vector<std::string>& labels) {
  check(distances, labels);
  std::map<std::string, std::vector<std::size_t>> classes;
  for (std::size_t i = 0; i < labels.size(); ++i) classes[labels[i]].push_back(i);

  RetrievalMeasures measures;
  Mean all;
  Mean class_means;
  for (const auto& [label, members] : classes) {
    if (members.size() == 1) {
      ++measures.left_out;
      continue;
    }
    Mean mean;
    for (const std::size_t query : members) {
      const RetrievalScores scores =
          score_query(find_hits(distances, labels, query), members.size() - 1);
      mean.add(scores);
      all.add(scores);
    }
    class_means.add(mean.get());
    measures.classes.push_back({label, members.size(), mean.get()});
    measures.queries += members.size();
  }
  if (measures.queries == 0) {
    throw InvalidInput("retrieval: no class has two models, so nothing can be queried");
  }
  measures.mean = all.get();
  measures.class_mean = class_means.get();
  return measures;
}

}  // namespace mdbd
