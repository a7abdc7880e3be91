#include "report/format_report.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "cli/utf8.h"
#include "features/core/errors.h"
#include "report/html_tables.h"
#include "report/markup.h"
#include "report/table_columns.h"
#include "tests/report/sample_report.h"

using namespace mdbd;
using Catch::Matchers::Contains;

namespace {

Report report_with(Table table) {
  Report report;
  report.title = "Title";
  report.sections = {{"Section", {std::move(table)}}};
  return report;
}

std::size_t widest_line(const std::string& text) {
  std::size_t widest = 0;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find('\n', start);
    widest = std::max(widest, display_width(std::string_view(text).substr(start, end - start)));
    start = end + 1;
  }
  return widest;
}

}  // namespace

TEST_CASE("markup is escaped, and what XML forbids is replaced") {
  CHECK(escape_markup("a <b> & \"c\" 'd'") == "a &lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
  CHECK(escape_markup("Stühle/椅子/🪑") == "Stühle/椅子/🪑");
  CHECK(escape_markup("\x1b\xff\xc3") == "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd");
  CHECK(escape_markup(std::string_view("\0", 1)) == "\xef\xbf\xbd");
  CHECK(escape_markup("\xef\xbf\xbf") == "\xef\xbf\xbd");
  CHECK(escape_markup("\xed\xa0\x80") == "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd");
}

TEST_CASE("the page has nothing of a hostile name but its letters") {
  const std::string page = format_report_html(test::make_sample_report());
  CHECK(page.find("<script") == std::string::npos);
  CHECK(page.find('\x1b') == std::string::npos);
  CHECK_THAT(page, Contains("&lt;script&gt;alert(&#39;&amp;&quot;&#39;)"));
  CHECK_THAT(page, Contains("There are no values to show."));
}

TEST_CASE("formatting twice gives the same bytes") {
  const Report report = test::make_sample_report();
  CHECK(format_report_html(report) == format_report_html(report));
  CHECK(format_report_json(report) == format_report_json(report));
  CHECK(format_report_text(report, 80) == format_report_text(report, 80));
}

TEST_CASE("JSON has the report's own members first, then its data") {
  const std::string text = format_report_json(test::make_sample_report());
  CHECK(text.back() == '\n');
  const auto document = nlohmann::ordered_json::parse(text);
  std::vector<std::string> names;
  for (const auto& item : document.items()) names.push_back(item.key());
  CHECK(names == std::vector<std::string>{"title", "summary", "provenance", "notes", "models"});
  CHECK(document["title"].get<std::string>().starts_with("Retrieval on <script>"));
  CHECK(document["models"][0]["distance"].is_null());
  CHECK(nlohmann::json::parse(format_report_json({}))["notes"] == nlohmann::json::array());
}

TEST_CASE("the terminal gets title, summary, summary tables and notes") {
  Report report = test::make_sample_report();
  const std::string text = format_report_text(report, 80);
  CHECK_THAT(text, Contains("Retrieval on") && Contains("Note: 1 model failed"));
  CHECK_THAT(text, Contains("distance\n") && Contains("0.5\n"));
  CHECK(std::ranges::none_of(text, [](char c) { return c == '\x1b' || c == '\xff'; }));
  std::get<Table>(report.sections[0].blocks[1]).is_summary = false;
  CHECK(format_report_text(report, 80).find("distance") == std::string::npos);
}

TEST_CASE("columns are aligned, numbers to the right") {
  const Table table{"Caption", {"name", "value"}, {{"Stühle", "9.5"}, {"椅子", "10.5"}}, true};
  CHECK_THAT(format_report_text(report_with(table), 80), Contains("Caption\n"
                                                                  "name    value\n"
                                                                  "Stühle    9.5\n"
                                                                  "椅子     10.5\n"));
}

TEST_CASE("narrow terminals break titles, then texts, never numbers") {
  const Table table{"Caption",
                    {"model", "nearest neighbour"},
                    {{"a name that is rather long", "12.5 %"}, {"alongwordwithoutblanks", "1 %"}},
                    true};
  const std::string whole = format_report_text(report_with(table), 80);
  CHECK_THAT(whole, Contains("model                       nearest neighbour\n"));
  const std::string titles_broken = format_report_text(report_with(table), 40);
  CHECK_THAT(titles_broken, Contains("  nearest\nmodel") && Contains("neighbour\n"));
  CHECK_THAT(titles_broken, Contains("rather long     12.5 %\n"));
  const std::string texts_broken = format_report_text(report_with(table), 24);
  CHECK_THAT(texts_broken, Contains("a name that       12.5 %\nis rather\nlong\n"));
  CHECK_THAT(texts_broken, Contains("alongwordwit…        1 %\n"));
  CHECK(widest_line(texts_broken) <= 24);
}

TEST_CASE("a percent sign stays with its number") {
  Report report;
  report.summary = "Some words, and then 77.1 % of all";
  CHECK_THAT(format_report_text(report, 26), Contains("Some words, and then\n77.1 % of all\n"));
  CHECK_THAT(format_report_html(report), Contains("77.1\u00a0% of all"));
}

TEST_CASE("what a number is") {
  for (const char* number :
       {"0", "-1.5", "81.2 %", "0.05 ± 0.01", "1e-9", "12/40", "−3", "1,000"}) {
    INFO(number);
    CHECK(is_number(number));
  }
  for (const char* text : {"", "–", "e", "ESF", "chair/12.off", "E1", "3 min", "%", "n/a"}) {
    INFO(text);
    CHECK_FALSE(is_number(text));
  }
  const Table table{"", {"a", "b", "c"}, {{"1", "–", "x"}, {"–", "", "1"}, {"none"}, {"2"}}};
  CHECK(is_number_column(table, 0));
  CHECK_FALSE(is_number_column(table, 1));
  CHECK_FALSE(is_number_column(table, 2));
}

TEST_CASE("a confusion matrix has recall, precision and accuracy") {
  const std::string html = html_confusion_matrix({"c", {"x", "y"}, {{3, 1}, {0, 4}}});
  CHECK_THAT(html, Contains("<td class=\"right strong\" style=\"--share:0.750\">3</td>"));
  CHECK_THAT(html, Contains("<td class=\"sum\">4</td><td class=\"sum\">75.0</td>"));
  CHECK_THAT(html, Contains("<td class=\"sum\">100.0</td><td class=\"sum\">80.0</td>"));
  CHECK_THAT(html, Contains("<strong>87.5</strong>"));
  CHECK_THAT(html_confusion_matrix({"c", {"x"}, {{0}}}), Contains("–"));
  CHECK_THROWS_AS(html_confusion_matrix({"c", {"x"}, {{1, 2}}}), InvalidInput);
  CHECK_THROWS_AS(html_confusion_matrix({"c", {"x", "y"}, {{1, 2}}}), InvalidInput);
}
