#include "provers/report/text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/provers/report/xml_check.h"

namespace tact::provers {
namespace {

TEST(Text, MarkupCharactersAreEscaped) {
  EXPECT_EQ(Escape("a<b & \"c\" > 'd'"), "a&lt;b &amp; &quot;c&quot; &gt; &#39;d&#39;");
  EXPECT_EQ(Escape("&amp;"), "&amp;amp;");
  EXPECT_EQ(Escape("\u2264 \u6574 \U0001F600"), "\u2264 \u6574 \U0001F600");
}

TEST(Text, WhatXmlCannotWriteIsReplaced) {
  const std::string replaced = "\xEF\xBF\xBD";
  EXPECT_EQ(Escape(std::string("a\0b", 3)), "a" + replaced + "b");
  EXPECT_EQ(Escape("\x1b[0m\t\n"), replaced + "[0m\t\n");
  EXPECT_EQ(Escape("\xff"), replaced);
  EXPECT_EQ(Escape("\xC3"), replaced);                                // cut off
  EXPECT_EQ(Escape("\xC0\xAF"), replaced + replaced);                 // overlong
  EXPECT_EQ(Escape("\xED\xA0\x80"), replaced + replaced + replaced);  // a surrogate
  EXPECT_EQ(Escape("\xEF\xBF\xBF"), replaced);                        // U+FFFF
}

RC_GTEST_PROP(TextLaw, AnyBytesSurviveAsOneElement, (const std::string& bytes)) {
  const XmlContents element = ReadXml("<p title=\"" + Escape(bytes) + "\">" + Escape(bytes) + "</p>");
  RC_ASSERT(element.error.empty());
  bool plain = true;
  for (const unsigned char c : bytes) plain = plain && c < 0x7F && (c >= 0x20 || c == '\t' || c == '\n');
  if (plain) RC_ASSERT(element.text == bytes);
}

TEST(Text, NumbersAreReadable) {
  EXPECT_EQ(GroupedDigits(0), "0");
  EXPECT_EQ(GroupedDigits(1234), "1234");
  EXPECT_EQ(GroupedDigits(12345), "12\u202F345");
  EXPECT_EQ(GroupedDigits(-123456), "-123\u202F456");
  EXPECT_EQ(GroupedDigits(123456789), "123\u202F456\u202F789");
  EXPECT_EQ(GroupedDigits(-9223372036854775807LL - 1),
            "-9\u202F223\u202F372\u202F036\u202F854\u202F775\u202F808");
  EXPECT_EQ(ReadableSeconds(0.0002), "under 1 ms");
  EXPECT_EQ(ReadableSeconds(0.0204), "20 ms");
  EXPECT_EQ(ReadableSeconds(0.9999), "1.0 s");
  EXPECT_EQ(ReadableSeconds(59.99), "1 min 0 s");
  EXPECT_EQ(ReadableSeconds(3725), "1 h 2 min");
  EXPECT_EQ(ReadableSize(1), "1 byte");
  EXPECT_EQ(ReadableSize(999), "999 bytes");
  EXPECT_EQ(ReadableSize(12345), "12 kB");
  EXPECT_EQ(ReadableSize(999900), "1.0 MB");
  EXPECT_EQ(ShortDecimal(-0.001), "0");
  EXPECT_EQ(ShortDecimal(12.5), "12.5");
  EXPECT_EQ(ShortDecimal(100), "100");
}

}  // namespace
}  // namespace tact::provers
