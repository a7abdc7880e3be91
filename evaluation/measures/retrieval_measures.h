#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "evaluation/distance_matrix.h"

/// How well a distance finds the models of a query's class: the measures of the Princeton Shape
/// Benchmark (Shilane, Min, Kazhdan, Funkhouser, The Princeton Shape Benchmark, SMI 2004, section
/// 4) and average precision.
///
/// Every model queries all the others and is left out of its own answer. Answers are ordered by
/// distance; at equal distance by the order of the models.
namespace mdbd {

/// So many recall levels has a precision-recall curve: 1/20, 2/20 … 1.
inline constexpr std::size_t recall_levels = 20;

/// So many answers count for the E-measure.
inline constexpr std::size_t e_measure_answers = 32;

/// All from 0 to 1, 1 is best. C is the class of the query, the query included.
struct RetrievalScores {
  double nearest_neighbour = 0.0;  ///< 1 if the first answer is in C, else 0
  double first_tier = 0.0;   ///< share of the |C| - 1 others found in the first |C| - 1 answers
  double second_tier = 0.0;  ///< the same in the first 2 (|C| - 1) answers
  /// 2 / (1/P + 1/R) with the precision P and the recall R of the first 32 answers, or of all if
  /// there are fewer; 0 if none of them is in C.
  double e_measure = 0.0;
  /// Discounted cumulative gain of the whole answer, G_1 + sum of G_i / log2 i, divided by that of
  /// the best answer; this holds the |C| - 1 other models of C, for the query is left out.
  double discounted_gain = 0.0;
  double average_precision = 0.0;  ///< mean of the precision at each model of C in the answer
  /// precision[l] is the best precision at a recall of at least (l + 1) / 20.
  std::array<double, recall_levels> precision{};
};

/// The mean scores of the queries of one class.
struct ClassRetrieval {
  std::string label;
  std::size_t models = 0;  ///< all of them are queries
  RetrievalScores mean;
};

struct RetrievalMeasures {
  std::size_t queries = 0;     ///< models whose class has other models
  std::size_t left_out = 0;    ///< models alone in their class: only answers, never queries
  RetrievalScores mean;        ///< over queries ("micro average")
  RetrievalScores class_mean;  ///< over the means of classes ("macro average")
  std::vector<ClassRetrieval> classes;  ///< of two models or more, ordered by label
};

/// All other models, nearest first.
/// @pre no distance is NaN
std::vector<std::size_t> rank_models(const DistanceMatrix& distances, std::size_t query);

/// @param labels the class of each model
/// @throws InvalidInput if a distance is not finite, the sizes differ, or no class has two models
RetrievalMeasures measure_retrieval(const DistanceMatrix& distances,
                                    const std::vector<std::string>& labels);

}  // namespace mdbd
