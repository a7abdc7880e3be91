#include "collection/isolated.h"

#include <new>
#include <utility>

#include <fmt/format.h>

#include "collection/model_job.h"
#include "features/core/errors.h"

namespace mdbd {
namespace {

// The first byte of what a computation sends.
constexpr char sent_value = 'v';
constexpr char sent_invalid_input = 'i';
constexpr char sent_io_error = 'e';

std::string run_computation(const std::filesystem::path& file,
                            const std::function<std::string()>& compute) {
  try {
    return sent_value + compute();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const IoError& error) {
    return sent_io_error + std::string(error.what());
  } catch (const InvalidInput& error) {
    return sent_invalid_input + std::string(error.what());
  } catch (const std::exception& error) {
    return sent_invalid_input +
           fmt::format("{}: unexpected failure: {}", file.string(), error.what());
  }
}

ProcessOutcome run_process(const std::filesystem::path& file, const ProcessLimits& limits,
                           const ProcessWork& work) {
  constexpr std::chrono::milliseconds interval{1000};
  preload_reader(file);
  ProcessPool pool(1, limits);
  pool.start(0, work);
  while (true) {
    auto outcomes = pool.wait(interval);
    if (!outcomes.empty()) return std::move(outcomes.front());
  }
}

}  // namespace

std::string compute_isolated(const std::filesystem::path& file, const ProcessLimits& limits,
                             const std::function<std::string()>& compute) {
  ProcessOutcome outcome = run_process(
      file, limits, [&](const SendOutput& send) { send(run_computation(file, compute)); });
  if (outcome.end != ProcessEnd::finished || outcome.output.empty()) {
    throw InvalidInput(fmt::format("{}: {}", file.string(), outcome.reason));
  }
  const std::string content = outcome.output.substr(1);
  if (outcome.output[0] == sent_io_error) throw IoError(content);
  if (outcome.output[0] == sent_invalid_input) throw InvalidInput(content);
  return content;
}

ShapeDescription describe_isolated(const std::filesystem::path& file, const Recipe& recipe,
                                   const ProcessLimits& limits, bool has_thumbnail) {
  const DescribeFunction describe = [&](const std::filesystem::path& path) {
    return has_thumbnail ? describe_with_thumbnail(path, recipe) : describe_file(path, recipe);
  };
  ModelResult result = read_model_result(run_process(
      file, limits, [&](const SendOutput& send) { run_model_job(file, {}, describe, send); }));
  const ShapeRecord& record = result.record;
  if (record.failure == FailureKind::unreadable) throw IoError(record.reason);
  if (record.status == ShapeStatus::failed) throw InvalidInput(record.reason);
  ShapeDescription description;
  description.format = record.format;
  description.representation = record.representation;
  description.statistics = record.statistics;
  description.decomposition.balls = std::move(result.data.balls);
  description.decomposition.scale = record.scale;
  description.descriptor.values = std::move(result.data.signature);
  description.descriptor.radius_count = recipe.descriptor_balls;
  description.descriptor.walk_is_defined = record.walk_is_defined;
  description.fused = std::move(result.data.fused);
  description.thumbnail = std::move(result.data.thumbnail);
  return description;
}

}  // namespace mdbd
