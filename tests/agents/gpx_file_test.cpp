#include "agents/gpx_file.h"

#include <gtest/gtest.h>

#include "files/error.h"

namespace prairie {
namespace {

std::string wrapped(const std::string& points) {
  return "<?xml version=\"1.0\"?>\n<gpx version=\"1.1\" "
         "xmlns=\"http://www.topografix.com/GPX/1/1\">\n<trk><trkseg>\n" +
         points + "\n</trkseg></trk></gpx>\n";
}

BadInput fault_of(const std::string& text) {
  try {
    parse_gpx(text, "walk.gpx");
  } catch (const BadInput& fault) {
    return fault;
  }
  ADD_FAILURE() << "taken: " << text.substr(0, 200);
  return BadInput("", "", "", "");
}

TEST(GpxFile, ReadsPointsTimesAndLines) {
  const auto segments = parse_gpx(
      wrapped("<trkpt lat=\"45.38\" lon=\"14.14\"><ele>733.6</ele><time>2010-10-03T09:36:30Z</time></trkpt>\n"
              "<trkpt lon=\" -14.25 \" lat=\"-45\"/></trkseg><trkseg/><trkseg><trkpt lat=\"1\" "
              "lon=\"2\"></trkpt>"),
      "walk.gpx");
  ASSERT_EQ(segments.size(), 3u);
  ASSERT_EQ(segments[0].size(), 2u);
  EXPECT_TRUE(segments[1].empty());
  EXPECT_EQ(segments[2].size(), 1u);
  EXPECT_EQ(segments[0][0].at.latitude_deg, 45.38);
  EXPECT_EQ(segments[0][0].at.longitude_deg, 14.14);
  EXPECT_EQ(segments[0][0].time_s, 1286098590.0);
  EXPECT_EQ(segments[0][0].line, 4u);
  EXPECT_EQ(segments[0][1].at.longitude_deg, -14.25);
  EXPECT_EQ(segments[0][1].line, 5u);
  EXPECT_FALSE(segments[0][1].time_s);
}

TEST(GpxFile, ReadsTimes) {
  EXPECT_EQ(parse_gpx_time("1970-01-01T00:00:00Z"), 0.0);
  EXPECT_EQ(parse_gpx_time("2010-08-05T14:23:59Z"), 1281018239.0);
  EXPECT_EQ(parse_gpx_time(" 2010-08-05T16:23:59+02:00\n"), 1281018239.0);
  EXPECT_EQ(parse_gpx_time("2010-08-05T10:53:59-0330"), 1281018239.0);
  EXPECT_EQ(parse_gpx_time("2010-08-05T14:23:59"), 1281018239.0);
  EXPECT_NEAR(parse_gpx_time("2010-08-05T14:23:59.125Z").value(), 1281018239.125, 1e-6);
  EXPECT_EQ(parse_gpx_time("2000-02-29T00:00:00Z"), 951782400.0);
  for (const char* text :
       {"", "today", "2010-08-05", "2010-08-05T14:23Z", "2010-13-05T14:23:59Z", "2011-02-29T14:23:59Z",
        "2010-08-05T24:23:59Z", "2010-08-05T14:60:59Z", "2010-08-05T14:23:61Z", "2010-08-05T14:23:59.Z",
        "2010-08-05T14:23:59Zulu", "2010-08-05T14:23:59+25:00", "2010-08-05T14:23:59+1",
        "2010-08-05T14:23:59+", "-010-08-05T14:23:59Z", "2010-08-05T14:23:+9Z"})
    EXPECT_FALSE(parse_gpx_time(text)) << text;
}

TEST(GpxFile, NamesLineAndValueOfWhatIsWrong) {
  const BadInput latitude = fault_of(wrapped("<trkpt lat=\"1\" lon=\"2\"/>\n<trkpt lat=\"91\" lon=\"2\"/>"));
  EXPECT_EQ(latitude.field, "line 5: lat");
  EXPECT_EQ(latitude.found, "\"91\"");
  EXPECT_EQ(fault_of(wrapped("<trkpt lat=\"1\"/>")).field, "line 4: lon");
  EXPECT_EQ(fault_of(wrapped("<trkpt lat=\"1\"/>")).found, "nothing");
  EXPECT_EQ(fault_of(wrapped("<trkpt lat=\"north\" lon=\"2\"/>")).field, "line 4: lat");
  EXPECT_EQ(fault_of(wrapped("<trkpt lat=\"nan\" lon=\"2\"/>")).field, "line 4: lat");
  EXPECT_EQ(fault_of(wrapped("<trkpt lat=\"1\" lon=\"inf\"/>")).field, "line 4: lon");
  const BadInput time = fault_of(wrapped("<trkpt lat=\"1\" lon=\"2\"><time>noon</time></trkpt>"));
  EXPECT_EQ(time.field, "line 4: time");
  EXPECT_EQ(time.found, "\"noon\"");
  EXPECT_EQ(fault_of("<gpx>\n<trk>\n<trkseg>").file, "walk.gpx");
  EXPECT_EQ(fault_of("<html>\n</html>").found, "<html>");
  fault_of("");
  fault_of("hello");
}

TEST(GpxFile, ExpandsNoEntitiesAndTakesDeepNesting) {
  std::string bomb = "<!DOCTYPE gpx [<!ENTITY a0 \"1\">";
  for (int n = 1; n < 30; ++n) {
    const std::string inner = "&a" + std::to_string(n - 1) + ";";
    bomb += "<!ENTITY a" + std::to_string(n) + " \"" + inner + inner + "\">";
  }
  bomb += "]><gpx><trk><trkseg><trkpt lat=\"&a29;\" lon=\"1\"/></trkseg></trk></gpx>";
  EXPECT_EQ(fault_of(bomb).found, "\"&a29;\"");
  std::string deep = "<gpx>";
  for (int n = 0; n < 300'000; ++n) deep += "<a>";
  fault_of(deep);
  for (int n = 0; n < 300'000; ++n) deep += "</a>";
  EXPECT_TRUE(parse_gpx(deep + "</gpx>", "deep.gpx").empty());
  EXPECT_NE(fault_of(std::string(kMostGpxBytes + 1, '<')).expected.find("at most"), std::string::npos);
}

}  // namespace
}  // namespace prairie
