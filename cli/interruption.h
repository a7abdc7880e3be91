#pragma once

namespace mdbd {

/// From now on SIGINT and SIGTERM only ask the program to end: see is_interruption_wanted(). A
/// second one, half a second later or more, has its default effect.
void catch_interruptions();

/// Whether SIGINT or SIGTERM has come since catch_interruptions().
bool is_interruption_wanted();

}  // namespace mdbd
