#include <iostream>

#include "evaluation/report/format_report.h"
#include "tests/evaluation/report/sample_report.h"

int main() { std::cout << mdbd::format_report_html(mdbd::test::make_sample_report()); }
