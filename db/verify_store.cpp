#include "db/verify_store.h"

#include <cmath>
#include <span>

#include "features/core/errors.h"
#include "features/descriptor/compute_descriptor.h"
#include "features/descriptor/fused_signature.h"

namespace mdbd {
namespace {

constexpr float tolerance = 1e-5F;

bool is_near(std::span<const float> left, std::span<const float> right) {
  if (left.size() != right.size()) return false;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (!(std::abs(left[i] - right[i]) <= tolerance)) return false;
  }
  return true;
}

void verify_model(const ShapeStore& store, const ShapeRecord& record,
                  std::vector<std::string>& problems) {
  const ShapeData data = store.data(record.id);
  if (!(record.scale > 0.0)) {
    problems.push_back(record.path + ": its R is not above 0");
    return;
  }
  BallDecomposition decomposition;
  decomposition.balls = data.balls;
  decomposition.scale = record.scale;
  if (!is_near(data.signature, compute_descriptor(decomposition, store.recipe()).values)) {
    problems.push_back(record.path + ": its mdbd-100 is not that of its balls");
  }
  if (!data.fused.empty() && !is_near(data.fused, compute_fused_signature(data.balls))) {
    problems.push_back(record.path + ": its mdbd-fused is not that of its balls");
  }
}

}  // namespace

Verification verify_store(const ShapeStore& store) {
  Verification verification;
  for (const ShapeRecord& record : store.shapes()) {
    if (record.status == ShapeStatus::failed) continue;
    ++verification.models;
    try {
      verify_model(store, record, verification.problems);
    } catch (const StoreError& error) {
      verification.problems.emplace_back(error.what());
    }
  }
  return verification;
}

}  // namespace mdbd
