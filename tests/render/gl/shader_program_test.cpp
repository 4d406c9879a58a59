// Shaders are put together from files, and what compilers say of them names these files.
#include "render/gl/shader_program.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "files/error.h"
#include "tests/render/headless_test.h"
#include "tests/temporary_folder.h"

namespace prairie {
namespace {

class ShaderProgramTest : public HeadlessTest {
 protected:
  void SetUp() override {
    HeadlessTest::SetUp();
    std::filesystem::create_directories(folder_ / "lib");
    std::filesystem::create_directories(folder_ / "pass");
  }

  void write(const char* name, const char* text) { std::ofstream(folder_ / name) << text; }

  TemporaryFolder folder_;
};

TEST_F(ShaderProgramTest, IncludesEachFileOnceAndKeepsLines) {
  write("lib/value.glsl", "float value() {\n  return 1.0;\n}\n");
  write("lib/more.glsl", "#include \"shaders/lib/value.glsl\"\nfloat more() { return value() + 1.0; }\n");
  write("pass/all.frag",
        "#version 450 core\n#include \"shaders/lib/value.glsl\"\n#include \"shaders/lib/more.glsl\"\n"
        "layout(location = 0) out vec4 color;\nvoid main() { color = vec4(more()); }\n");
  const ShaderSource source = shader_source(folder_.path(), "pass/all.frag", {"SOME", ""});
  EXPECT_EQ(source.files, (std::vector<std::string>{"pass/all.frag", "lib/value.glsl", "lib/more.glsl"}));
  EXPECT_EQ(source.text,
            "#version 450 core\n#define SOME\n#line 2 0\n"
            "#line 1 1\nfloat value() {\n  return 1.0;\n}\n"
            "#line 3 0\n"
            "#line 1 2\n#line 2 2\nfloat more() { return value() + 1.0; }\n"
            "#line 4 0\nlayout(location = 0) out vec4 color;\nvoid main() { color = vec4(more()); }\n");
}

TEST_F(ShaderProgramTest, AFaultNamesItsFileAndLine) {
  write("lib/broken.glsl", "float value() {\n  return nothing;\n}\n");
  write("pass/broken.comp",
        "#version 450 core\nlayout(local_size_x = 1) in;\n#include \"shaders/lib/broken.glsl\"\n"
        "void main() {}\n");
  try {
    make_program(folder_.path(), {"pass/broken.comp"}, {"SOME"});
    FAIL() << "it compiles";
  } catch (const NoSuitableOpenGl& fault) {
    EXPECT_NE(fault.found.find("lib/broken.glsl:2"), std::string::npos) << fault.found;
  }
  messages().clear();
}

TEST(ShaderLogTest, LinesOfKnownFilesAreNamed) {
  const std::vector<std::string> files{"pass/a.frag", "lib/b.glsl"};
  EXPECT_EQ(log_with_file_names("1:12(3): error: x\n0(7) : error C1\n9:1: y\nno number\n", files),
            "lib/b.glsl:12(3): error: x\npass/a.frag(7) : error C1\n9:1: y\nno number\n");
}

}  // namespace
}  // namespace prairie
