#include "core/files/markup.hpp"

#include <gmock/gmock.h>
#include <tinyxml2.h>

namespace morphe::files {
namespace {

/// Another library reads back what was written.
TEST(Markup, AnXmlReaderFindsTheTextAndTheSize) {
  const std::string name = "a<b> & \"c\" d'e µm";
  const std::string svg = svg_header(640, 480, 12) + "<text id=\"" + escape_xml(name) + "\">" +
                          escape_xml(name) + "</text></svg>\n";
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(svg.c_str()), tinyxml2::XML_SUCCESS);
  const tinyxml2::XMLElement& root = *document.RootElement();
  EXPECT_STREQ(root.Name(), "svg");
  EXPECT_EQ(root.DoubleAttribute("width"), 640);
  EXPECT_EQ(root.DoubleAttribute("height"), 480);
  EXPECT_STREQ(root.Attribute("viewBox"), "0 0 640 480");
  const tinyxml2::XMLElement* text = root.FirstChildElement("text");
  ASSERT_NE(text, nullptr);
  EXPECT_EQ(text->Attribute("id"), name);
  EXPECT_EQ(text->GetText(), name);
}

TEST(Markup, WhatXmlCannotHoldIsLeftOut) {
  EXPECT_EQ(escape_xml("a\x01\x1b"
                       "b\tc\nd"),
            "ab\tc\nd");
}

}  // namespace
}  // namespace morphe::files
