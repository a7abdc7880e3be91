#include "query/compare_surfaces.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <string_view>
#include <thread>

#include "collection/discover.h"
#include "features/alignment/align_shapes.h"
#include "features/core/errors.h"
#include "features/shape.h"

namespace mdbd {
namespace {

constexpr std::chrono::milliseconds wait_interval{100};

// Between the samples of a cloud are gaps of up to so many of its spacings.
constexpr double largest_gap = 2.0;

/// A model as the store has it.
struct StoredModel {
  ShapeRecord record;
  std::vector<Ball> balls;
};

std::optional<StoredModel> read_model(const ShapeStore& store, std::int64_t id) {
  std::optional<ShapeRecord> record = store.find(id);
  if (!record || record->status == ShapeStatus::failed) return std::nullopt;
  return StoredModel{std::move(*record), store.data(id).balls};
}

/// The shape of which the store has the balls.
Shape read_shape(const StoredModel& model, const Recipe& recipe) {
  const std::array<std::filesystem::path, 1> path = {model.record.path};
  const Discovery found = discover(path);
  const bool is_unchanged = found.files.size() == 1 &&
                            found.files.front().size == model.record.file_size &&
                            found.files.front().modified_ns == model.record.modified_ns;
  if (!is_unchanged) throw InvalidInput("the file has changed since it was indexed");
  Shape shape = load_shape(path.front(), recipe);
  if (shape.field->dimension() != 3) throw InvalidInput("the domain is plane");
  return shape;
}

double measure_deviation(const StoredModel& first, const StoredModel& second,
                         const Recipe& recipe) {
  const Shape first_shape = read_shape(first, recipe);
  const Shape second_shape = read_shape(second, recipe);
  return align_shapes({*first_shape.field, first.balls, largest_gap * first_shape.least_radius},
                      {*second_shape.field, second.balls, largest_gap * second_shape.least_radius},
                      same_surface_deviation)
      .deviation;
}

/// A job of the pool; it sends nothing if the pair cannot be measured.
void send_deviation(const StoredModel& first, const StoredModel& second, const Recipe& recipe,
                    const SendOutput& send) {
  try {
    const double deviation = measure_deviation(first, second, recipe);
    send({reinterpret_cast<const char*>(&deviation), sizeof deviation});
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
  }
}

std::optional<double> received_deviation(const ProcessOutcome& outcome) {
  double deviation = 0.0;
  if (outcome.end != ProcessEnd::finished || outcome.output.size() != sizeof deviation) {
    return std::nullopt;
  }
  std::memcpy(&deviation, outcome.output.data(), sizeof deviation);
  return deviation;
}

}  // namespace

std::vector<std::optional<double>> compare_surfaces(const ShapeStore& store,
                                                    std::span<const ModelPair> pairs,
                                                    const ProcessLimits& limits,
                                                    ProgressBar& progress) {
  std::vector<std::optional<double>> deviations(pairs.size());
  ProcessPool pool(std::max(1U, std::thread::hardware_concurrency()), limits);
  progress.start(pairs.size());
  std::size_t next = 0;
  while (next < pairs.size() || !pool.is_empty()) {
    while (next < pairs.size() && !pool.is_full()) {
      const std::size_t job = next++;
      const auto first = read_model(store, pairs[job].first);
      const auto second = read_model(store, pairs[job].second);
      if (!first || !second) {
        progress.advance(true);
        continue;
      }
      preload_reader(first->record.path);
      preload_reader(second->record.path);
      pool.start(job, [&](const SendOutput& send) {
        send_deviation(*first, *second, store.recipe(), send);
      });
    }
    if (pool.is_empty()) break;
    for (const ProcessOutcome& outcome : pool.wait(wait_interval)) {
      deviations[outcome.job] = received_deviation(outcome);
      progress.advance(!deviations[outcome.job]);
    }
    progress.refresh();
  }
  return deviations;
}

}  // namespace mdbd
