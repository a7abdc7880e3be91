#include "store/shape_record.h"

namespace mdbd {

std::string_view to_string(ShapeStatus status) {
  return status == ShapeStatus::indexed ? "indexed" : "failed";
}

std::string_view to_string(FailureKind kind) {
  switch (kind) {
    case FailureKind::none:
      return "none";
    case FailureKind::content:
      return "content";
    case FailureKind::unreadable:
      return "unreadable";
    case FailureKind::budget:
      return "budget";
    case FailureKind::crash:
      return "crash";
  }
  return "unknown";
}

}  // namespace mdbd
