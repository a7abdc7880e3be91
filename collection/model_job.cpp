#include "collection/model_job.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <new>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "features/brep/read_brep.h"
#include "features/brep/solid_path.h"
#include "features/core/errors.h"
#include "features/shape_io/content_hash.h"
#include "picture/thumbnail.h"

using nlohmann::json;

namespace mdbd {
namespace {

constexpr std::size_t hash_length = 32;

// A job's output is the hash, then this object as CBOR, which keeps every bit of a double.
json encode(const ModelResult& result) {
  const ShapeRecord& record = result.record;
  const std::string& thumbnail = result.data.thumbnail;
  json balls = json::array();
  for (const Ball& ball : result.data.balls) {
    balls.insert(balls.end(), {ball.center.x(), ball.center.y(), ball.center.z(), ball.radius});
  }
  return {{"is_known", result.is_known},
          {"solids", result.solids},
          {"format", record.format},
          {"representation", record.representation},
          {"statistics", record.statistics},
          {"scale", record.scale},
          {"status", record.status},
          {"failure", record.failure},
          {"reason", record.reason},
          {"walk_is_defined", record.walk_is_defined},
          {"balls", std::move(balls)},
          {"signature", result.data.signature},
          {"fused", result.data.fused},
          {"thumbnail", json::binary({thumbnail.begin(), thumbnail.end()})}};
}

ModelResult decode(const json& object) {
  ModelResult result;
  ShapeRecord& record = result.record;
  object.at("is_known").get_to(result.is_known);
  object.at("solids").get_to(result.solids);
  object.at("format").get_to(record.format);
  object.at("representation").get_to(record.representation);
  object.at("statistics").get_to(record.statistics);
  object.at("scale").get_to(record.scale);
  object.at("status").get_to(record.status);
  object.at("failure").get_to(record.failure);
  object.at("reason").get_to(record.reason);
  object.at("walk_is_defined").get_to(record.walk_is_defined);
  object.at("signature").get_to(result.data.signature);
  object.at("fused").get_to(result.data.fused);
  const json::binary_t& thumbnail = object.at("thumbnail").get_binary();
  result.data.thumbnail.assign(thumbnail.begin(), thumbnail.end());
  const auto balls = object.at("balls").get<std::vector<double>>();
  for (std::size_t i = 0; i + 4 <= balls.size(); i += 4) {
    result.data.balls.push_back({{balls[i], balls[i + 1], balls[i + 2]}, balls[i + 3]});
  }
  return result;
}

ModelResult failed(FailureKind kind, std::string reason) {
  ModelResult result;
  result.record.status = ShapeStatus::failed;
  result.record.failure = kind;
  result.record.reason = std::move(reason);
  return result;
}

bool is_finite(const ShapeDescription& description) {
  const auto is_number = [](auto value) { return std::isfinite(value); };
  return is_number(description.decomposition.scale) &&
         std::ranges::all_of(description.descriptor.values, is_number) &&
         std::ranges::all_of(description.fused, is_number) &&
         std::ranges::all_of(description.decomposition.balls, [&](const Ball& ball) {
           return ball.center.allFinite() && is_number(ball.radius);
         });
}

ModelResult succeeded(ShapeDescription description) {
  // The store refuses such numbers, and one bad file must not stop a run.
  if (!is_finite(description)) return failed(FailureKind::content, "too large: numbers overflow");
  const BallDecomposition& decomposition = description.decomposition;
  ModelResult result;
  result.record.format = std::move(description.format);
  result.record.representation = std::move(description.representation);
  result.record.statistics = std::move(description.statistics);
  result.record.scale = decomposition.scale;
  result.record.walk_is_defined = description.descriptor.walk_is_defined;
  if (decomposition.termination != Termination::ball_count) {
    result.record.reason = fmt::format("{} balls: {}", decomposition.balls.size(),
                                       std::string_view(to_string(decomposition.termination)));
  }
  result.data.balls = decomposition.balls;
  result.data.signature = std::move(description.descriptor.values);
  result.data.fused = std::move(description.fused);
  result.data.thumbnail = std::move(description.thumbnail);
  return result;
}

/// Calls a function that returns a result; what it throws becomes one.
template <typename Function>
ModelResult catch_failures(const Function& function) {
  try {
    return function();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const InvalidInput& error) {
    return failed(FailureKind::content, error.what());
  } catch (const IoError& error) {
    return failed(FailureKind::unreadable, error.what());
  } catch (const std::exception& error) {
    return failed(FailureKind::crash, fmt::format("unexpected failure: {}", error.what()));
  } catch (...) {
    return failed(FailureKind::crash, "unexpected failure of an unknown kind");
  }
}

FailureKind failure_kind(ProcessEnd end) {
  return end == ProcessEnd::died ? FailureKind::crash : FailureKind::budget;
}

ModelResult read_output(const ProcessOutcome& outcome) {
  if (outcome.end != ProcessEnd::finished) return failed(failure_kind(outcome.end), outcome.reason);
  return catch_failures([&] {
    return decode(json::from_cbor(outcome.output.begin() + hash_length, outcome.output.end()));
  });
}

}  // namespace

ShapeDescription describe_with_thumbnail(const std::filesystem::path& path, const Recipe& recipe) {
  const Shape shape = load_shape(path, recipe);
  ShapeDescription description = describe_shape(shape, recipe);
  description.thumbnail = draw_thumbnail(shape.surface, description.decomposition.balls);
  return description;
}

std::string content_key(const std::string& content_hash, const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return content_hash + ending;
}

void run_model_job(const std::filesystem::path& path,
                   const std::unordered_set<std::string>& known_keys,
                   const DescribeFunction& describe, const SendOutput& send, bool is_per_solid) {
  std::string hash;
  const ModelResult result = catch_failures([&] {
    hash = content_hash(split_solid_path(path).file);
    send(hash);
    if (known_keys.contains(content_key(hash, path))) {
      return ModelResult{.is_known = true, .record = {}, .data = {}};
    }
    const std::size_t solids = is_per_solid && is_brep_file(path) ? count_solids(path) : 1;
    if (solids > 1) return ModelResult{.solids = solids, .record = {}, .data = {}};
    return succeeded(describe(path));
  });
  if (hash.empty()) send(std::string(hash_length, '0'));
  std::string bytes;
  json::to_cbor(encode(result), bytes);
  send(bytes);
}

ModelResult read_model_result(const ProcessOutcome& outcome) {
  ModelResult result = read_output(outcome);
  // A file that could not be read may have been cut off while it was hashed.
  const bool has_hash =
      outcome.output.size() >= hash_length && result.record.failure != FailureKind::unreadable;
  if (has_hash) result.record.content_hash = outcome.output.substr(0, hash_length);
  result.record.seconds = outcome.seconds;
  return result;
}

}  // namespace mdbd
