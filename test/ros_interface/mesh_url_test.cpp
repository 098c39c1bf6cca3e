// What the solver reads is what RViz shows: its retriever gets the same bytes from the URL of a mesh.
#include <cable_variation/scene/resource_address.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <resource_retriever/retriever.h>

#include <ros_interface/conversion/scene_loading.h>

namespace cable_variation_ros {
namespace {

namespace fs = std::filesystem;

// A package 'odd_parts' in a folder of its own.
class MeshUrl : public testing::Test {
 protected:
  MeshUrl() : root_(fs::temp_directory_path() / (std::to_string(getpid()) + "_mesh_url")) {
    fs::create_directories(root_ / "odd_parts" / "meshes");
    std::ofstream(root_ / "odd_parts" / "package.xml")
        << "<package format=\"2\"><name>odd_parts</name><version>0.0.0</version><description>d</description>"
           "<maintainer email=\"a@b.c\">a</maintainer><license>none</license></package>";
    setenv("ROS_PACKAGE_PATH", root_.c_str(), 1);
  }
  ~MeshUrl() override { fs::remove_all(root_); }

  void expectSame(const std::string& name, const std::string& address) {
    const cable_variation::ResourceFile file = cable_variation::findResource(address, findPackage);
    ASSERT_EQ(file.path, (root_ / "odd_parts" / "meshes" / name).string());
    resource_retriever::Retriever retriever;
    const resource_retriever::MemoryResource got = retriever.get(file.url);
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(got.data.get()), got.size), "content of " + name)
        << file.url;
  }

  fs::path root_;
};

TEST_F(MeshUrl, isReadByTheRetriever) {
  std::vector<std::string> names{"plain.stl",     "with blank.stl", "a#b.stl",           "50%.stl",
                                 "50%25.stl",     "why?.stl",       "M\xc3\xbcller.stl", "a'b\"c.stl",
                                 "{x}[y](z).stl", "a;b,c=d&e.stl"};
  std::mt19937 random(1);
  const std::string letters = "ab %#?&+;=@!$'()*,:[]{}<>|\\^`~\"";
  for (int i = 0; i < 100; ++i) {
    std::string name = "n";
    for (int k = 0; k < 6; ++k) name += letters[random() % letters.size()];
    names.push_back(name + ".stl");
  }
  for (const std::string& name : names)
    std::ofstream(root_ / "odd_parts/meshes" / name) << "content of " << name;
  for (const std::string& name : names) {
    const std::string url =
        cable_variation::findResource("file://" + (root_ / "odd_parts/meshes" / name).string(), findPackage)
            .url;
    if (cable_variation::localPath(url, findPackage) != (root_ / "odd_parts/meshes" / name))
      continue;  // another's escape
    expectSame(name, "package://odd_parts/meshes/" + url.substr(url.rfind('/') + 1));
    expectSame(name, url);
    expectSame(name, "package://odd_parts/meshes/" + name);
  }
}

}  // namespace
}  // namespace cable_variation_ros
