#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "query/answer_query.h"

namespace mdbd {

/// A table of rank, distance and path for people, one line a match below a header line; empty if
/// there are no matches. Paths below `directory` are shown relative to it. Every path is shown on
/// one line, as printable() does.
/// If the hand was asked for, a column has it: "same", "mirrored", "none" or "unclear".
/// @param is_explained whether to show how much of each distance each of its parts makes, in per
///        cent, and below each match the numbers that differ the most, the query's and the match's
std::string format_table(const SearchResult& result, const std::filesystem::path& directory,
                         bool is_explained = false);

/// {"query", "exact", "matches": [{"rank", "id", "path", "distance", "PART_distance"
/// for each part of the distance, "scale"}]}, with a line end; "hand" in each match if it was asked
/// for, and "differences": [{"number", "query", "match"}] if there are any. Bytes of a path that
/// are no UTF-8 become U+FFFD.
std::string format_json(const QueryAnswer& answer);

/// "the answer is exact", or how far it can be trusted.
std::string describe_exactness(const QueryAnswer& answer);

/// An array of objects as in format_json(const QueryAnswer&), in the order of the queries.
std::string format_json(std::span<const QueryAnswer> answers);

/// The fields of a match in format_json but the differences as CSV (RFC 4180 with plain line feeds)
/// below a header line. Numbers read back to the same bits; paths keep their bytes.
std::string format_csv(const SearchResult& result);

/// As format_csv(const SearchResult&) for several queries below one header line, with the query in
/// front of each line; empty if there are no answers.
std::string format_csv(std::span<const QueryAnswer> answers);

}  // namespace mdbd
