#include "features/decomposition/certificate.h"

#include <algorithm>

namespace mdbd {

Certificate check_certificate(const DistanceField& field, const BallDecomposition& decomposition) {
  const std::vector<Ball>& balls = decomposition.balls;
  std::vector<DistanceQuery> queries;
  for (const Ball& ball : balls) queries.push_back({.point = ball.center});
  std::vector<DistanceSample> samples(queries.size());
  field.measure(queries, samples);

  Certificate certificate;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const double outside = balls[i].radius - samples[i].distance;
    certificate.containment_violation =
        std::max(certificate.containment_violation, outside / decomposition.scale);
    certificate.maximality_gap =
        std::max(certificate.maximality_gap, decomposition.upper_bounds[i] / balls[i].radius - 1.0);
    for (std::size_t j = 0; j < i; ++j) {
      const double overlap =
          balls[i].radius + balls[j].radius - (balls[i].center - balls[j].center).norm();
      certificate.overlap_violation =
          std::max(certificate.overlap_violation, overlap / decomposition.scale);
    }
  }
  return certificate;
}

}  // namespace mdbd
