#include "indexer/console_observer.h"

#include "cli/terminal.h"

namespace mdbd {

void ConsoleObserver::on_failure(const IndexFailure& failure) {
  console_.warn(printable(failure.path) + ": " + printable(failure.reason));
}

}  // namespace mdbd
