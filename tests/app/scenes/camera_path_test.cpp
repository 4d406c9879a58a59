#include "app/scenes/camera_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "files/error.h"

namespace prairie {
namespace {

const std::string kColumns = "time_s,x_m,y_m,z_m,yaw_deg,pitch_deg,fov_deg\n";

TEST(CameraPath, PassesItsRowsAndStandsBeyondThem) {
  const CameraPath path =
      parse_camera_path(kColumns + "1,0,5,+1.7,0,0,60\n2,3,5,+2,40,-10,50\n4,4,9,+1,90,5,40\n", "p");
  for (std::size_t row = 0; row < path.times_s.size(); ++row) {
    const CameraSpec camera = camera_at(path, path.times_s[row]);
    EXPECT_NEAR(camera.position_m.x, path.cameras[row].position_m.x, 1e-12);
    EXPECT_NEAR(camera.yaw_deg, path.cameras[row].yaw_deg, 1e-12);
    EXPECT_NEAR(camera.fov_deg, path.cameras[row].fov_deg, 1e-12);
    EXPECT_TRUE(camera.z_above_ground);
  }
  EXPECT_EQ(camera_at(path, 0.0).position_m.x, 0.0);
  EXPECT_EQ(camera_at(path, 9.0).position_m.y, 9.0);
}

TEST(CameraPath, GoesEvenlyThroughEvenRowsAndWithoutKinks) {
  // A parabola through uneven times is followed exactly between inner rows.
  std::string text = kColumns;
  for (const double t : {0.0, 1.0, 1.5, 3.0, 4.0})
    text += std::to_string(t) + "," + std::to_string(t * t) + "," + std::to_string(2.0 * t) + ",5,0,0,60\n";
  const CameraPath path = parse_camera_path(text, "p");
  for (double t = 1.0; t < 3.0; t += 0.1) {
    EXPECT_NEAR(camera_at(path, t).position_m.x, t * t, 1e-9) << t;
    EXPECT_NEAR(camera_at(path, t).position_m.y, 2.0 * t, 1e-9) << t;
  }
  for (const double row_s : {1.0, 1.5, 3.0}) {
    const auto x = [&](double t) { return camera_at(path, t).position_m.x; };
    constexpr double kStep = 1e-5;
    EXPECT_NEAR((x(row_s) - x(row_s - kStep)) / kStep, (x(row_s + kStep) - x(row_s)) / kStep, 1e-3);
  }
}

TEST(CameraPath, TurnsTheShorterWay) {
  const CameraPath path =
      parse_camera_path(kColumns + "0,0,0,5,350,0,60\n1,0,0,5,10,0,60\n2,0,0,5,-170,0,60\n", "p");
  EXPECT_EQ(path.cameras[1].yaw_deg, 370.0);
  EXPECT_EQ(std::abs(path.cameras[2].yaw_deg - 370.0), 180.0);
  EXPECT_FALSE(path.cameras[0].z_above_ground);
}

TEST(CameraPath, HeightsAboveTheGroundStayBetweenThoseOfTheRows) {
  const CameraPath path = parse_camera_path(
      kColumns + "0,0,0,+3,0,0,60\n1,1,0,+0.1,0,0,60\n2,2,0,+0.1,0,0,60\n3,3,0,+3,0,0,60\n4,4,0,+9,0,0,60\n",
      "p");
  for (int frame = 0; frame <= 400; ++frame) {
    const double time_s = 0.01 * frame;
    const double z_m = camera_at(path, time_s).z_m;
    const auto row = static_cast<std::size_t>(std::min(time_s, 3.999));
    const double a = path.cameras[row].z_m, b = path.cameras[row + 1].z_m;
    EXPECT_GE(z_m, std::min(a, b) - 1e-12) << time_s;
    EXPECT_LE(z_m, std::max(a, b) + 1e-12) << time_s;
  }
}

TEST(CameraPath, OneRowStands) {
  const CameraPath path = parse_camera_path("time_s,yaw_deg,pitch_deg,x_m,y_m,z_m\n3,1,2,4,5,6\n", "p");
  EXPECT_EQ(camera_at(path, 0.0).z_m, 6.0);
  EXPECT_EQ(camera_at(path, 3.0).yaw_deg, 1.0);
  EXPECT_EQ(camera_at(path, 3.0).fov_deg, 60.0);
}

TEST(CameraPath, NamesLineAndColumnOfWhatIsWrong) {
  const auto refused = [](const std::string& rows, const std::string& field, const std::string& found) {
    try {
      parse_camera_path(kColumns + rows, "path.csv");
      ADD_FAILURE() << rows << " was accepted";
    } catch (const BadInput& fault) {
      EXPECT_EQ(fault.file, "path.csv");
      EXPECT_EQ(fault.field, field);
      EXPECT_EQ(fault.found, found);
    }
  };
  const std::string good = "0,1,2,+3,0,0,60\n";
  refused("0,1,2,high,0,0,60\n", "line 2: z_m", "\"high\"");
  refused(good + "1,,2,+3,0,0,60\n", "line 3: x_m", "nothing");
  refused(good + "1,1,2,+3,inf,0,60\n", "line 3: yaw_deg", "\"inf\"");
  refused(good + "1,1,2,+3,0,91,60\n", "line 3: pitch_deg", "\"91\"");
  refused(good + "1,1,2,+3,0,0,0\n", "line 3: fov_deg", "\"0\"");
  refused(good + "0,1,2,+3,0,0,60\n", "line 3: time_s", "\"0\"");
  refused("-1,1,2,+3,0,0,60\n", "line 2: time_s", "\"-1\"");
  refused(good + "1,1,2,3,0,0,60\n", "line 3: z_m", "\"3\"");
  refused(good + "\n1,1,2,+3,0,0,60\n", "line 3", "1 values");
  refused(good + "1,1,2,+3,0,0\n", "line 3", "6 values");
  refused("", "", "no row");
  EXPECT_THROW(parse_camera_path("time_s,x_m,y_m\n0,1,2\n", "path.csv"), BadInput);
  EXPECT_THROW(parse_camera_path(std::string(1000, '\0'), "path.csv"), BadInput);
}

}  // namespace
}  // namespace prairie
