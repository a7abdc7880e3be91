#include "query/run_queries.h"

#include <fmt/format.h>

#include "cli/text_output.h"
#include "collection/discover.h"
#include "collection/isolated.h"
#include "features/core/errors.h"
#include "query/query_output.h"

namespace mdbd {
namespace {

bool is_batch(const QueryArguments& arguments) {
  std::error_code error;
  return arguments.models.size() > 1 ||
         (arguments.models.size() == 1 &&
          std::filesystem::is_directory(arguments.models.front(), error));
}

QueryAnswer answer_file(ShapeSearch& search, const std::filesystem::path& file,
                        const QueryArguments& arguments) {
  const bool has_thumbnail = !arguments.html.empty();
  return search.by_file(file, [&](const std::filesystem::path& path, const Recipe& recipe) {
    return describe_isolated(path, recipe, arguments.limits, has_thumbnail);
  });
}

QueryRun run_batch(const ShapeStore& store, const QueryArguments& arguments) {
  QueryRun run{.is_batch = true, .answers = {}, .failures = {}};
  const Discovery found = discover(arguments.models);
  for (const UnusablePath& path : found.unusable) {
    run.failures.push_back(fmt::format("{}: {}", path.path, path.reason));
  }
  if (found.files.empty() && run.failures.empty()) {
    throw InvalidInput("there are no models to search with");
  }
  ShapeSearch search(store, arguments.options, found.files.size());
  for (const FoundFile& file : found.files) {
    try {
      run.answers.push_back(answer_file(search, file.path, arguments));
    } catch (const InvalidInput& error) {
      run.failures.emplace_back(error.what());
    } catch (const IoError& error) {
      run.failures.emplace_back(error.what());
    }
  }
  return run;
}

std::string format_tables(const QueryRun& run, const QueryArguments& arguments,
                          const std::filesystem::path& directory) {
  std::string text;
  for (const QueryAnswer& answer : run.answers) {
    if (run.is_batch) {
      if (!text.empty()) text += '\n';
      text += shown_path(answer.query, directory) + '\n';
    }
    text += arguments.is_explained ? format_explained_table(answer, directory)
                                   : format_table(answer.result, directory);
  }
  return text;
}

}  // namespace

QueryRun run_queries(const ShapeStore& store, const QueryArguments& arguments) {
  if (is_batch(arguments)) return run_batch(store, arguments);
  ShapeSearch search(store, arguments.options);
  QueryRun run;
  run.answers.push_back(arguments.models.empty()
                            ? search.by_id(arguments.id)
                            : answer_file(search, arguments.models.front(), arguments));
  return run;
}

std::string format_answers(const QueryRun& run, const QueryArguments& arguments,
                           const std::filesystem::path& directory) {
  if (arguments.is_json) {
    const bool is_explained = arguments.is_explained;
    return run.is_batch ? format_json(run.answers, is_explained)
                        : format_json(run.answers.front(), is_explained);
  }
  if (arguments.is_csv) {
    return run.is_batch ? format_csv(run.answers) : format_csv(run.answers.front().result);
  }
  return format_tables(run, arguments, directory);
}

}  // namespace mdbd
