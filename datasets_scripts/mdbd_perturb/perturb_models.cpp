#include "datasets_scripts/mdbd_perturb/perturb_models.h"

#include <array>
#include <chrono>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "collection/discover.h"
#include "features/core/errors.h"
#include "features/shape.h"
#include "features/shape_io/read_mesh.h"
#include "features/shape_io/write_mesh.h"

namespace fs = std::filesystem;

namespace mdbd {
namespace {

constexpr std::chrono::milliseconds wait_interval{100};

// What a job sends first.
constexpr char sent_remark = '+';
constexpr char sent_problem = '-';

void require_apart(const fs::path& input, const fs::path& output) {
  const std::array inputs = {fs::weakly_canonical(input).string()};
  const std::array outputs = {fs::weakly_canonical(output).string()};
  if (is_within(outputs[0], inputs) || is_within(inputs[0], outputs)) {
    throw InvalidInput(
        fmt::format("{} and {}: neither may be or lie within the other, so that no "
                    "copy takes the place of a model",
                    input.string(), output.string()));
  }
}

fs::path with_format(fs::path path, const std::string& format) {
  return format.empty() ? path : path.replace_extension(format);
}

PlannedCopy plan_copy(const fs::path& source, const fs::path& output, const std::string& format) {
  PlannedCopy copy{.source = source.string(),
                   .name = source.filename().string(),
                   .target = output,
                   .problem = {}};
  if (fs::is_directory(output)) copy.target = output / with_format(source.filename(), format);
  if (!has_written_mesh_extension(copy.target) || copy.target != with_format(copy.target, format)) {
    throw InvalidInput(
        fmt::format("{}: the name of a copy ends in {}, unless it is an existing folder",
                    output.string(), format.empty() ? ".off, .obj, .ply or .stl" : "." + format));
  }
  require_apart(source, copy.target);
  return copy;
}

std::string relative_name(const std::string& path, const std::string& folder) {
  return fs::path(path).lexically_relative(folder).string();
}

std::vector<PlannedCopy> plan_folder(const Discovery& found, const fs::path& output,
                                     const std::string& format) {
  const std::string& folder = found.roots.front();
  std::vector<PlannedCopy> copies;
  std::set<fs::path> targets;
  for (const FoundFile& file : found.files) {
    if (!has_mesh_extension(file.path)) continue;  // perturbations are of meshes
    PlannedCopy copy{
        .source = file.path, .name = relative_name(file.path, folder), .target = {}, .problem = {}};
    const fs::path target = output / with_format(copy.name, format);
    if (!has_written_mesh_extension(target)) {
      copy.problem =
          fmt::format("{} is not written; --format names another", target.extension().string());
    } else if (targets.insert(target).second) {
      copy.target = target;
    } else {
      copy.problem = fmt::format("the copy of another model is {}, too", target.string());
    }
    copies.push_back(std::move(copy));
  }
  for (const UnusablePath& unusable : found.unusable) {
    copies.push_back({.source = unusable.path,
                      .name = relative_name(unusable.path, folder),
                      .target = {},
                      .problem = unusable.reason});
  }
  return copies;
}

/// What is to be said of a decimated copy that has more faces than it should.
std::string remark_on(const PlannedCopy& copy, std::size_t faces, double wanted_percent) {
  const std::size_t before = read_mesh(copy.source).mesh.triangles.size();
  const double percent = 100.0 * static_cast<double>(faces) / static_cast<double>(before);
  if (faces <= 4 || percent < wanted_percent + 0.5) return {};
  return fmt::format("{} of {} faces are left, {:.1f} %; no further edge can be collapsed", faces,
                     before, percent);
}

/// @returns a remark
std::string make_copy(const PlannedCopy& copy, const PerturbOptions& options) {
  const TriangleMesh changed = perturb_file(copy.source, options.perturbation, options.seed);
  if (copy.target.has_parent_path()) fs::create_directories(copy.target.parent_path());
  write_mesh(copy.target, changed);
  if (options.wanted_faces == 0) return {};
  return remark_on(copy, changed.triangles.size(), options.wanted_faces);
}

void run_job(const PlannedCopy& copy, const PerturbOptions& options, const SendOutput& send) {
  try {
    send(sent_remark + make_copy(copy, options));
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    send(sent_problem + std::string(error.what()));
  }
}

CopyOutcome read_outcome(const ProcessOutcome& outcome) {
  if (outcome.end != ProcessEnd::finished) return {.problem = outcome.reason, .remark = {}};
  const std::string text = outcome.output.substr(1);
  if (outcome.output.front() == sent_problem) return {.problem = text, .remark = {}};
  return {.problem = {}, .remark = text};
}

}  // namespace

std::vector<PlannedCopy> plan_copies(const fs::path& input, const fs::path& output,
                                     const std::string& format) {
  const Discovery found = discover(std::array{input});
  if (!fs::is_directory(input)) {
    if (found.files.empty()) {
      throw InvalidInput(fmt::format("{}: {}", input.string(), found.unusable.front().reason));
    }
    return {plan_copy(found.files.front().path, output, format)};
  }
  require_apart(input, output);
  std::vector<PlannedCopy> copies = plan_folder(found, output, format);
  if (copies.empty()) {
    throw InvalidInput(
        fmt::format("{}: no models in this folder; their names end in .off, .obj, "
                    ".ply or .stl",
                    input.string()));
  }
  return copies;
}

std::size_t make_copies(const std::vector<PlannedCopy>& copies, const PerturbOptions& options,
                        const PerturbObserver& observer) {
  ProcessPool pool(options.jobs, options.limits);
  std::size_t next = 0;
  while (true) {
    while (next < copies.size() && !pool.is_full() && !observer.is_interrupted()) {
      const PlannedCopy& copy = copies[next];
      if (copy.problem.empty()) {
        preload_reader(copy.source);
        pool.start(next, [&](const SendOutput& send) { run_job(copy, options, send); });
      } else {
        observer.on_done(copy, {.problem = copy.problem, .remark = {}});
      }
      ++next;
    }
    if (pool.is_empty()) return copies.size() - next;
    for (const ProcessOutcome& outcome : pool.wait(wait_interval)) {
      observer.on_done(copies[outcome.job], read_outcome(outcome));
    }
    observer.on_wait();
  }
}

}  // namespace mdbd
