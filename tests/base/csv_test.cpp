// Comma-separated values with quotes, as RFC 4180 has them.
#include "host/base/csv.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "host/base/error.hpp"

namespace brdftab {
namespace {

using Rows = std::vector<std::vector<std::string>>;

// The rows under a header "a,b".
Rows rows(const std::string& text) {
  std::istringstream in("a,b\n" + text);
  Csv csv(in, "data.csv", "a and b");
  Rows result;
  while (const auto* cells = csv.next()) result.emplace_back(cells->begin(), cells->end());
  return result;
}

std::string refusal(const std::string& text) {
  try {
    rows(text);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

TEST(Csv, CellsAreTrimmedUnlessQuoted) {
  EXPECT_EQ(rows("1, 2 \n\" 3 \" ,\t4\r\n"), (Rows{{"1", "2"}, {" 3 ", "4"}}));
}

TEST(Csv, QuotesHoldCommasQuotesAndLineEnds) {
  EXPECT_EQ(rows("\"red, wet\",1\n"), (Rows{{"red, wet", "1"}}));
  EXPECT_EQ(rows("1,\"red, wet\"\n"), (Rows{{"1", "red, wet"}}));
  EXPECT_EQ(rows("\"a \"\"matt\"\" one\",\"\"\n"), (Rows{{"a \"matt\" one", ""}}));
  EXPECT_EQ(rows("\"\"\"\",1\n"), (Rows{{"\"", "1"}}));
  EXPECT_EQ(rows("\"two\n\nlines\",1\n2,3\n"), (Rows{{"two\n\nlines", "1"}, {"2", "3"}}));
  EXPECT_EQ(rows("\"#1\",1\n# a comment, \"not closed\n"), (Rows{{"#1", "1"}}));
}

TEST(Csv, AQuoteWithinACellIsText) { EXPECT_EQ(rows("6\" disk,1\n"), (Rows{{"6\" disk", "1"}})); }

TEST(Csv, LinesAreCountedWithinQuotes) {
  std::istringstream in("a,b\n\"1\n2\",3\n4,5\n");
  Csv csv(in, "data.csv", "a and b");
  csv.next();
  EXPECT_EQ(csv.where(), "data.csv:2");
  csv.next();
  EXPECT_EQ(csv.where(), "data.csv:4");
}

TEST(Csv, RefusalsNameTheRow) {
  EXPECT_EQ(refusal("1,2\n\"3,4\n5,6\n"), "data.csv:3: a quote is not closed");
  EXPECT_EQ(refusal("\"3\" mm,4\n"), "data.csv:2: text follows a closing quote: mm,4");
  EXPECT_EQ(refusal("\"3,4\"\n"), "data.csv:2: has 1 cells where the header has 2");
}

}  // namespace
}  // namespace brdftab
