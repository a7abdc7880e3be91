#pragma once

#include <span>
#include <string>
#include <string_view>

#include "query/answer_query.h"

namespace mdbd {

/// What a page says beside the answers.
struct QueryPageOptions {
  std::string_view signature;  ///< what was compared
  bool is_explained = false;   ///< show what differs
};

/// One self-contained HTML page: a section for each query, with its picture and those of its
/// matches, their distances and, if explained, the lists of mdbd-100 and the numbers that differ.
/// A shape without a thumbnail is shown by its balls. A click on a picture draws its balls, which
/// can be turned, beside those of the query (ball_viewer.h). Well-formed as HTML and as XML, free
/// of the network, legible on a screen, dark or light, and on paper.
/// @pre the answers have their data (QueryOptions::has_data)
std::string format_query_page(std::span<const QueryAnswer> answers,
                              const QueryPageOptions& options);

}  // namespace mdbd
