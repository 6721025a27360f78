#include "Scenes.hpp"

#include <filesystem>
#include <fstream>

using namespace Rhegma;
using namespace Rhegma::SceneTests;

namespace
{

/// A file that is removed at the end of the test.
class TemporaryFile
{
public:
  TemporaryFile(const std::string& name, const std::string& content)
      : m_path((std::filesystem::temp_directory_path() / ("rhegma_test_" + name)).string())
  {
    std::ofstream(m_path, std::ios::binary) << content;
  }
  ~TemporaryFile() { std::filesystem::remove(m_path); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return m_path; }

private:
  std::string m_path;
};

std::vector<SceneError> errorsOf(const std::string& xml) { return read(xml).errors; }

} // namespace

TEST(SceneFile, IsRead)
{
  const TemporaryFile file("good.xml", goodScene());
  const auto result = readScene(file.path(), {"Time:Final Time=2"}, coreSchema());
  ASSERT_TRUE(result.errors.empty()) << all(result.errors);
  EXPECT_EQ(result.list->sublist("Time").get<double>("Final Time"), 2.0);
}

TEST(SceneFile, AbsentFolderAndEmpty)
{
  const auto folder = std::filesystem::temp_directory_path().string();
  expectOnly(readScene(folder + "/no_such_scene.xml", {}, coreSchema()).errors, "", {"does not exist"});
  expectOnly(readScene(folder, {}, coreSchema()).errors, "", {"is a folder"});
  const TemporaryFile empty("empty.xml", "");
  const auto result = readScene(empty.path(), {}, coreSchema());
  expectOnly(result.errors, "", {"is empty"});
  EXPECT_TRUE(result.list.is_null());
}

TEST(SceneFile, NotXml)
{
  expectOnly(errorsOf("Domain: 2\n"), "", {"not well-formed XML", "line 1"});
  expectOnly(errorsOf("{\"Domain\": 2}"), "", {"not well-formed XML"});
  expectOnly(errorsOf(std::string("\x7f"
                                  "ELF\0\1\2",
                                  7)),
             "", {"not well-formed XML"});
  expectOnly(errorsOf("   \n"), "", {"no element"});
}

TEST(SceneFile, TruncatedAnywhereIsOneError)
{
  const std::string scene = goodScene();
  const auto end = scene.rfind("</ParameterList>");
  for (std::size_t length = 1; length < end; length += 37)
    expectOnly(errorsOf(scene.substr(0, length)), "", {"not well-formed XML"});
  expectOnly(errorsOf(scene.substr(0, end)), "", {"line 36", "ended before closing"});
}

TEST(SceneFile, WrongClosingTagNamesItsLine)
{
  expectOnly(
      errorsOf(
          "<ParameterList name=\"Rhegma\">\n<ParameterList name=\"Time\">\n</Parameter>\n</ParameterList>"),
      "", {"line 3"});
}

TEST(SceneFile, LessThanSignInAValueSaysWhatToWrite)
{
  expectOnly(errorsOf(with("Pull", parameter("History", "string", "t < 1"))), "", {"&lt;"});
  EXPECT_TRUE(errorsOf(with("Pull", parameter("History", "string", "t &lt; 1"))).empty());
}

TEST(SceneFile, WrongTopList)
{
  expectOnly(errorsOf("<ParameterList name=\"Regma\"/>"), "",
             {"\"Regma\"", "<ParameterList name=\"Rhegma\">"});
  expectOnly(errorsOf("<ParameterList/>"), "", {"no name", "Rhegma"});
  expectOnly(errorsOf("<html/>"), "", {"<html>", "Rhegma"});
}

TEST(SceneFile, DuplicateNames)
{
  expectOnly(errorsOf(with("Time", parameter("Final Time", "double", "2"))), "Time > Final Time", {"twice"});
  expectOnly(errorsOf(with("Rhegma", "<ParameterList name=\"Output\"/><ParameterList name=\"Output\"/>")),
             "Output", {"twice"});
}

TEST(SceneFile, MissingAttributesAndUnknownTags)
{
  expectOnly(errorsOf(with("Time", "<Parameter name=\"CFL\" value=\"0.3\"/>")), "Time > CFL", {"no type"});
  expectOnly(errorsOf(with("Time", "<Parameter name=\"CFL\" type=\"double\"/>")), "Time > CFL", {"no value"});
  expectOnly(errorsOf(with("Time", "<Parameter name=\"CFL\" type=\"double\">0.3</Parameter>")), "Time > CFL",
             {"0.3"});
  expectOnly(errorsOf(with("Time", "<Parameter type=\"double\" value=\"0.3\"/>")), "Time", {"no name"});
  expectOnly(errorsOf(with("Time", "<ParameterList/>")), "Time", {"no name"});
  expectOnly(errorsOf(with("Time", "<Paramter name=\"CFL\" type=\"double\" value=\"0.3\"/>")), "Time",
             {"<Paramter>"});
  expectOnly(errorsOf(with("Time", "0.3")), "Time", {"\"0.3\""});
  expectOnly(errorsOf(with("Time", parameter("CFL", "dobule", "0.3"))), "Time > CFL",
             {"dobule", "\"double\""});
}

TEST(SceneFile, ByteOrderMarkDeclarationAndCommentsAreFine)
{
  EXPECT_TRUE(errorsOf("\xEF\xBB\xBF<?xml version=\"1.0\"?>\n<!-- a scene -->\n" + goodScene()).empty());
}

TEST(SceneFile, DamagedAnywhereNeverThrows)
{
  const std::string scene = goodScene();
  int wrong = 0;
  for (std::size_t i = 0; i < scene.size(); ++i)
    for (const char letter : {'\0', '<', '"', '9', '{', 'e'})
    {
      std::string damaged = scene;
      damaged[i] = letter;
      const auto result = read(damaged);
      EXPECT_TRUE(!result.list.is_null() || !result.errors.empty());
      for (const auto& error : result.errors)
      {
        EXPECT_EQ(error.message.find('\n'), std::string::npos) << error.message;
        EXPECT_EQ(error.message.find("Teuchos"), std::string::npos) << error.message;
      }
      wrong += result.errors.empty() ? 0 : 1;
    }
  EXPECT_GT(wrong, 1000);
}
