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
std::string format_table(const SearchResult& result, const std::filesystem::path& directory);

/// The same with how much of each distance each of its parts makes, in per cent, and below each
/// match what differs: the numbers that do the most, the lists of mdbd-100 as pictures, and the
/// balls whose radii differ the most, their centres in object units.
/// @pre the answer has its data (QueryOptions::has_data)
std::string format_explained_table(const QueryAnswer& answer,
                                   const std::filesystem::path& directory);

/// {"query", "exact", "matches": [{"rank", "id", "path", "distance", "PART_distance"
/// for each part of the distance, "scale"}]}, with a line end; "hand" in each match if it was asked
/// for, and "differences": [{"number", "query", "match"}] if there are any. Bytes of a path that
/// are no UTF-8 become U+FFFD.
/// @param is_explained whether query and matches have "radii" and "walk_sums", the lists of
///        mdbd-100, and matches "balls": [{"ball", "query": {"radius", "center"}, "match": {…}}],
///        those whose scaled radii differ the most; the answer has its data then
std::string format_json(const QueryAnswer& answer, bool is_explained = false);

/// "the answer is exact", or how far it can be trusted.
std::string describe_exactness(const QueryAnswer& answer);

/// An array of objects as in format_json(const QueryAnswer&), in the order of the queries.
std::string format_json(std::span<const QueryAnswer> answers, bool is_explained = false);

/// The fields of a match in format_json but the differences as CSV (RFC 4180 with plain line feeds)
/// below a header line. Numbers read back to the same bits; paths keep their bytes.
std::string format_csv(const SearchResult& result);

/// As format_csv(const SearchResult&) for several queries below one header line, with the query in
/// front of each line; empty if there are no answers.
std::string format_csv(std::span<const QueryAnswer> answers);

}  // namespace mdbd
