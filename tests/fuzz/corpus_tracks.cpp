#include <string_view>

#include "tests/fuzz/corpus.h"

namespace prairie::fuzz {

int replay_count() {
  return 30000;
}

std::vector<Input> make_corpus() {
  std::vector<Input> corpus;
  for (const std::string_view text :
       {"time_s,id,x_m,y_m\n0,1,0,0\n0,2,5,5\n0.4,1,0.5,0\n0.4,2,5,5\n0.8,1,1,0.1\n0.8,2,5,4.5\n9,1,3,3\n",
        "time_s,id,x_m,y_m,z_m,heading_rad\r\n0,1,0,0,0,0\r\n1,1,1.25,0,0,0\r\n2,1,0,0,0,3.1\r\n",
        "1 1 -2.8 0 18.9 0 0 -1.3\n11 1 -2.8 0 18.4 0 0 -1.3\n21 1 -2.8 0 17.9 0 0 -1.3\n1 2 1 0 3 0 0 0\n",
        "0 1.0 0 2\n10 1.0 0.5 2\n20 1.0 1 2\n0 2.0 5 5\n10 2.0 5.5 5\n",
        "# framerate: 16.00 fps\n# id frame x/cm y/cm z/cm\n1 0 100 200 175\n1 1 108 200 175\n2 0 300 1 "
        "160\n2 1 309 1 160\n",
        "780 1 0 0 0 1.4 0 0\n786 1 0.56 0 0 1.4 0 0\n792 1 1.12 0 0 1.4 0 0\n798 1 1.68 0 0 1.4 0 0\n804 1 "
        "2.24 0 0 1.4 0 0\n810 1 2.8 0 0 1.4 0 0\n",
        "time_s;id;x_m;y_m\n0,0;1;0,5;2\n0,4;1;1;2\n",
        "<?xml version=\"1.0\"?><gpx version=\"1.1\"><trk><trkseg>"
        "<trkpt lat=\"45.38\" lon=\"14.14\"><ele>7</ele><time>2010-10-03T09:36:30Z</time></trkpt>"
        "<trkpt lat=\"45.3801\" lon=\"14.14\"><time>2010-10-03T09:36:40Z</time></trkpt>"
        "<trkpt lat=\"45.3801\" lon=\"14.1401\"><time>2010-10-03T09:36:52.5+00:00</time></trkpt></trkseg>"
        "<trkseg/><trkseg><trkpt lat=\"45\" lon=\"14\"/><trkpt lat=\"45.0001\" "
        "lon=\"14\"/></trkseg></trk></gpx>"}) {
    corpus.emplace_back(text.begin(), text.end());
  }
  return corpus;
}

}  // namespace prairie::fuzz
