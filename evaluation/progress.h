#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mdbd {

/// Hears about an evaluation while it goes on, and can end it.
class EvaluationProgress {
 public:
  virtual ~EvaluationProgress() = default;
  /// Not called if everything is in the cache.
  /// @param stage what is being computed: "clean models", "noise 0.5 %"
  /// @param models how many must be computed
  virtual void on_stage(const std::string& stage, std::size_t models) = 0;
  virtual void on_model_done(bool has_failed) = 0;
  /// New failures only, in the order in which they happen.
  /// @param stage the variant or signature; empty for the models as they are
  virtual void on_failure(std::string_view stage, std::string_view model,
                          std::string_view reason) = 0;
  virtual void on_wait() = 0;  ///< about ten times a second
  /// True ends the evaluation: models in flight are finished and stored, no other is started.
  virtual bool is_interrupted() = 0;
};

}  // namespace mdbd
