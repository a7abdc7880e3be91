#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "features/core/signature.h"
#include "query/sketches.h"
#include "store/shape_store.h"

/// Vectors and sketches of a collection in a file beside its database, so that a program that has
/// just started can search them without reading them out of SQLite. The database holds the truth:
/// the file is made anew whenever it is missing, stale or damaged, and nothing is lost with it.
///
/// The sections of the file (CheckedFile), little-endian: a header, the axes of the sketches, the
/// corner of their quantiser, the sketches in groups (SketchList), vectors, ids, scales, path ends
/// and paths (VectorArrays).
namespace mdbd {

/// Smaller collections are read from SQLite in no time.
inline constexpr std::size_t least_cached_models = 2000;

/// Where the vectors of a signature are kept: "mdbd.db.mdbd-100.vectors".
std::filesystem::path vector_cache_path(const std::filesystem::path& database,
                                        SignatureKind signature);

/// What a cache is made of.
struct CachedVectors {
  VectorTable table;
  Sketches sketches;
};

/// A name for what a cache was made from: the revision of the store, its recipe and the name of the
/// signature. Empty if the store cannot tell its revision.
std::string vector_cache_key(const ShapeStore& store, SignatureKind signature);

/// Maps a cache. Header and sketches are checked first, the table when it is read: that throws
/// DamagedFile. The file may be replaced or removed meanwhile, but a program that shortens it in
/// place kills this one.
/// @returns nothing if it is not there, was made from something else or by another version, or if
///          what is checked is damaged
std::optional<CachedVectors> read_vector_cache(const std::filesystem::path& path,
                                               std::string_view key);

/// Writes a cache, in place of any there; there is never half of one.
/// @returns whether it worked: not in a read-only folder, while another program writes it, or if
///          less would be left on the disk than the cache takes
bool write_vector_cache(const std::filesystem::path& path, std::string_view key,
                        const VectorTable& table, const Sketches& sketches);

}  // namespace mdbd
