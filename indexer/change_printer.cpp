#include "indexer/change_printer.h"

#include <cstdio>

#include <fmt/format.h>

#include "cli/terminal.h"

namespace mdbd {
namespace {

void print_line(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);  // so that whoever reads a pipe sees it at once
}

std::string describe(const IndexChange& change) {
  const std::string path = printable(change.path);
  switch (change.kind) {
    case IndexChange::Kind::indexed:
      return "indexed " + path;
    case IndexChange::Kind::moved:
      return "moved   " + printable(change.old_path) + " -> " + path;
    case IndexChange::Kind::removed:
      return "removed " + path;
    case IndexChange::Kind::gone:
      return "gone    " + path + " (kept; --prune removes it)";
  }
  return path;
}

}  // namespace

void ChangePrinter::on_start(std::size_t models) {
  if (is_first_run_) observer_.on_start(models);
}

void ChangePrinter::on_more_models(std::size_t models) {
  if (is_first_run_) observer_.on_more_models(models);
}

void ChangePrinter::on_model_done(bool has_failed) {
  if (is_first_run_) observer_.on_model_done(has_failed);
}

void ChangePrinter::on_failure(const IndexFailure& failure) { observer_.on_failure(failure); }

void ChangePrinter::on_change(const IndexChange& change) {
  const bool is_gone = change.kind == IndexChange::Kind::gone;
  const bool is_news = is_gone ? gone_.insert(change.path).second : true;
  if (!is_gone) gone_.erase(change.path);
  if (is_news && !is_first_run_ && !is_quiet_) print_line(describe(change));
}

void ChangePrinter::on_first_run_done(const IndexSummary& summary) {
  console_.finish();
  is_first_run_ = false;
  if (is_quiet_) return;
  print_line(fmt::format("watching: {} indexed, {} unchanged, {} failed; Ctrl-C ends",
                         summary.indexed, summary.unchanged + summary.moved,
                         summary.failures.size()));
}

void ChangePrinter::on_limit(const std::string& limit) {
  console_.warn(limit.empty() ? "every change is reported again"
                              : printable(limit) + "; looking at everything again every --rescan");
}

}  // namespace mdbd
