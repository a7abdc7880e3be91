#pragma once

#include <string_view>

namespace mdbd {

/// What the page of queries adds to page_style(); free of & and <.
std::string_view query_page_style();

}  // namespace mdbd
