#include <iostream>

#include "report/format_report.h"
#include "tests/report/sample_report.h"

int main() { std::cout << mdbd::format_report_html(mdbd::test::make_sample_report()); }
