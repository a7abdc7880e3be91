#pragma once

#include <string>

#include "report/report.h"

namespace mdbd {

/// One self-contained HTML page: tables, charts as inline SVG, no script, nothing from the network;
/// legible on a screen, dark or light, and on paper.
std::string format_report_html(const Report& report);

/// Title, summary tables and notes for a terminal of so many columns. Texts are made safe to show.
std::string format_report_text(const Report& report, int width);

/// {"title", "summary", "provenance": {…}, "notes": […], …} with the members of Report::data after
/// them, and a line end. Bytes that are no UTF-8 become U+FFFD.
std::string format_report_json(const Report& report);

}  // namespace mdbd
