#include "evaluation/write_outputs.h"

#include <cerrno>
#include <cstring>

#include <fmt/format.h>
#include <unistd.h>

#include "features/core/errors.h"
#include "features/shape_io/output_file.h"
#include "report/format_report.h"

namespace fs = std::filesystem;

namespace mdbd {
namespace {

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw IoError(fmt::format("cannot write {}: {}", path.string(), reason));
}

void require_writable(const fs::path& path) {
  if (path.empty()) return;
  std::error_code error;
  const fs::path target = fs::weakly_canonical(fs::absolute(path), error);
  if (error) refuse(path, error.message());
  if (fs::is_directory(target, error)) refuse(path, "it is a folder");
  if (fs::exists(target, error) && !fs::is_regular_file(target, error)) {
    refuse(path, "it exists and is no ordinary file");
  }
  const fs::path folder = target.parent_path();
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    refuse(path, fmt::format("{}: {}", folder.string(), std::strerror(errno)));
  }
}

}  // namespace

void require_writable(const ReportOutputs& outputs) {
  if (!outputs.is_json_printed()) require_writable(outputs.json);
  require_writable(outputs.html);
}

void write_outputs(const Report& report, const ReportOutputs& outputs) {
  if (!outputs.json.empty() && !outputs.is_json_printed()) {
    write_file(outputs.json, format_report_json(report));
  }
  if (!outputs.html.empty()) write_file(outputs.html, format_report_html(report));
}

}  // namespace mdbd
