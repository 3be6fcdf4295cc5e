// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
// The folder a set goes to: nothing half-done is ever seen, nothing of others is lost.
#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cpl_vsi.h>

#include "sink/directory_sink.h"
#include "sink/tileset_swap.h"
#include "vsi/scratch_folder.h"
#include "vsi/vsi_files.h"

namespace {
/// Renames this process may still make; it is killed at the next one. Negative: no limit.
int renamesLeft = -1;
} // namespace

/// Takes the place of the C library's for the whole program, GDAL included.
extern "C" __attribute__((visibility("default"))) int rename(const char* from, const char* to) {
  if (renamesLeft == 0)
    kill(getpid(), SIGKILL);
  if (renamesLeft > 0)
    --renamesLeft;
  return renameat(AT_FDCWD, from, AT_FDCWD, to);
}

namespace qmesh {
namespace {

namespace fs = std::filesystem;

class DirectorySinkTest : public testing::Test {
 protected:
  DirectorySinkTest() {
    std::string name = (fs::temp_directory_path() / "qmesh-sink-XXXXXX").string();
    base_ = mkdtemp(name.data());
    options_.path = (base_ / "out").string();
  }
  ~DirectorySinkTest() override { fs::remove_all(base_); }

  std::unique_ptr<TileSink> open() {
    auto opened = openDirectorySink(options_);
    EXPECT_TRUE(opened.ok()) << opened.status().message();
    if (!opened.ok())
      return nullptr;
    workFolder_ = opened->workFolder;
    return std::move(opened->sink);
  }
  Status refusal() {
    auto sink = openDirectorySink(options_);
    EXPECT_FALSE(sink.ok());
    EXPECT_EQ(Code::output, sink.status().code()) << sink.status().message();
    return sink.status();
  }

  static std::vector<std::uint8_t> bytes(const std::string& text) {
    return {text.begin(), text.end()};
  }
  void put(const std::string& name, const std::string& text) {
    const fs::path path = fs::path(options_.path) / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }

  /// Every file below the output with its text; folders without files as "name/".
  std::map<std::string, std::string> tree() const { return treeOf(options_.path); }
  static std::map<std::string, std::string> treeOf(const fs::path& top) {
    std::map<std::string, std::string> out;
    if (fs::exists(top))
      for (const auto& entry : fs::recursive_directory_iterator(top)) {
        const std::string name = fs::relative(entry.path(), top).string();
        if (entry.is_directory()) {
          if (fs::is_empty(entry.path()))
            out[name + "/"] = "";
        } else {
          std::ifstream file(entry.path());
          out[name] = std::string(std::istreambuf_iterator<char>(file), {});
        }
      }
    return out;
  }

  /// An older set with files of others in many places.
  void putOldSet() {
    put("layer.json", "old layer");
    put("0/0/0.terrain", "old");
    put("0/1/0.terrain", "old");
    put("1/3/1.terrain", "old");
    put("7/12/34.terrain", "old");
    put("readme.txt", "mine");
    put("1/notes.txt", "mine");
    put("1/3/picture.png", "mine");
    put("7/12/deep/er.txt", "mine");
    put("19/photo.jpg", "mine, not a zoom folder");
    put("2024/0/0.terrain", "mine, no zoom either");
    put("docs/a/b.md", "mine");
    put("index.html", "old page");
  }
  static std::map<std::string, std::string> newSetOverOld() {
    return {{"layer.json", "new layer"},
            {"0/0/0.terrain", "new"},
            {"0/1/0.terrain", "new"},
            {"1/2/0.terrain", "new"},
            {"1/notes.txt", "mine"},
            {"1/3/picture.png", "mine"},
            {"7/12/deep/er.txt", "mine"},
            {"19/photo.jpg", "mine, not a zoom folder"},
            {"2024/0/0.terrain", "mine, no zoom either"},
            {"docs/a/b.md", "mine"},
            {"readme.txt", "mine"},
            {"index.html", "new page"},
            {"Cesium/Build/x.js", "script"}};
  }
  static void writeNewSet(TileSink& sink) {
    for (const TileId tile : {TileId{0, 0, 0}, {0, 1, 0}, {1, 2, 0}})
      ASSERT_TRUE(sink.writeTile(tile, bytes("new")).ok());
    ASSERT_TRUE(sink.writeFile("index.html", "new page").ok());
    ASSERT_TRUE(sink.writeFile("Cesium/Build/x.js", "script").ok());
  }

  fs::path base_;
  OutputOptions options_;
  std::string workFolder_; ///< of the sink opened last
};

TEST_F(DirectorySinkTest, NothingIsVisibleBeforeCommit) {
  auto sink = open();
  ASSERT_TRUE(sink);
  writeNewSet(*sink);
  for (const auto& entry : fs::directory_iterator(options_.path))
    EXPECT_EQ(".qmesh-build", entry.path().filename());
  const auto scratch = ScratchFolder::make(workFolder_);
  ASSERT_TRUE(scratch.ok());
  std::ofstream(scratch->path() + "/work") << "temporary";
  ASSERT_TRUE(sink->commit("new layer").ok());
  EXPECT_EQ((std::map<std::string, std::string>{{"layer.json", "new layer"},
                                                {"0/0/0.terrain", "new"},
                                                {"0/1/0.terrain", "new"},
                                                {"1/2/0.terrain", "new"},
                                                {"index.html", "new page"},
                                                {"Cesium/Build/x.js", "script"}}),
            tree());
  sink->abandon();
  EXPECT_EQ(6u, tree().size()) << "harmless after commit";
}

TEST_F(DirectorySinkTest, RowsFromTheNorthWithXyz) {
  options_.xyz = true;
  auto sink = open();
  ASSERT_TRUE(sink->writeTile({3, 5, 1}, bytes("t")).ok());
  ASSERT_TRUE(sink->commit("{}").ok());
  EXPECT_EQ(1u, tree().count("3/5/6.terrain"));
}

TEST_F(DirectorySinkTest, ABareNameIsAFolderHere) {
  const fs::path before = fs::current_path();
  fs::current_path(base_);
  options_.path = "set/of/tiles";
  {
    auto sink = open();
    ASSERT_TRUE(sink->writeTile({0, 0, 0}, bytes("t")).ok());
    ASSERT_TRUE(sink->commit("{}").ok());
  }
  fs::current_path(before);
  EXPECT_TRUE(fs::exists(base_ / "set/of/tiles/0/0/0.terrain"));
}

TEST_F(DirectorySinkTest, AbandonLeavesNoTrace) {
  {
    auto sink = open();
    writeNewSet(*sink);
    EXPECT_TRUE(ScratchFolder::make(workFolder_).ok());
    sink->abandon();
  }
  EXPECT_TRUE(fs::is_empty(base_)) << "the folder was ours";
  options_.path = (base_ / "a/b/c").string();
  { auto sink = open(); } // the destructor abandons
  EXPECT_TRUE(fs::is_empty(base_));
  fs::create_directories(options_.path);
  { auto sink = open(); }
  EXPECT_TRUE(fs::exists(options_.path)) << "was there before";
  EXPECT_TRUE(fs::is_empty(options_.path));
}

TEST_F(DirectorySinkTest, RefusesBeforeTheWork) {
  put("something", "mine");
  EXPECT_NE(std::string::npos, refusal().message().find("--overwrite"));
  const auto before = tree();
  EXPECT_EQ((std::map<std::string, std::string>{{"something", "mine"}}), before);
  options_.path += "/something";
  EXPECT_NE(std::string::npos, refusal().message().find("is a file"));
  options_.path += "/below";
  EXPECT_NE(std::string::npos, refusal().message().find("is a file"));
  EXPECT_EQ(before, treeOf(base_ / "out"));
  options_.path = "/proc/qmesh-test";
  (void)refusal();
}

TEST_F(DirectorySinkTest, RefusesAFolderThatCannotBeWritten) {
  fs::create_directories(options_.path);
  fs::permissions(base_, fs::perms(0755));
  fs::permissions(options_.path, fs::perms(0555));
  const pid_t child = fork();
  if (child == 0) { // root may write everywhere, so it becomes somebody else
    if (geteuid() == 0 && setuid(65534) != 0)
      _exit(77);
    const auto sink = openDirectorySink(options_);
    const bool named = sink.status().message().find("Permission denied") != std::string::npos;
    _exit(sink.status().code() == Code::output && named ? 0 : 1);
  }
  int state = 0;
  waitpid(child, &state, 0);
  fs::permissions(options_.path, fs::perms(0755));
  if (WIFEXITED(state) && WEXITSTATUS(state) == 77)
    GTEST_SKIP() << "not allowed to become another user";
  EXPECT_TRUE(WIFEXITED(state) && WEXITSTATUS(state) == 0);
  EXPECT_TRUE(fs::is_empty(options_.path));
}

TEST_F(DirectorySinkTest, OverwriteSwapsAndKeepsWhatIsNotOurs) {
  putOldSet();
  const auto before = tree();
  options_.overwrite = true;
  {
    auto sink = open();
    writeNewSet(*sink);
  }
  EXPECT_EQ(before, tree()) << "abandoned";
  auto sink = open();
  writeNewSet(*sink);
  ASSERT_TRUE(sink->commit("new layer").ok());
  EXPECT_EQ(newSetOverOld(), tree());
}

TEST_F(DirectorySinkTest, AFolderInTheWayOfAFileUndoesTheSwap) {
  putOldSet();
  fs::remove(fs::path(options_.path) / "index.html");
  put("index.html/mine.txt", "a folder of that name");
  const auto before = tree();
  options_.overwrite = true;
  {
    auto sink = open();
    writeNewSet(*sink);
    const Status status = sink->commit("new layer");
    EXPECT_EQ(Code::output, status.code());
    EXPECT_NE(std::string::npos, status.message().find("index.html")) << status.message();
  }
  EXPECT_EQ(before, tree());
}

TEST_F(DirectorySinkTest, OneRunAtATime) {
  auto sink = open();
  const Status second = refusal();
  EXPECT_NE(std::string::npos, second.message().find(std::to_string(getpid()))) << second.message();
  options_.overwrite = true;
  (void)refusal();
  ASSERT_TRUE(sink->writeTile({0, 0, 0}, bytes("t")).ok());
  ASSERT_TRUE(sink->commit("{}").ok());
  EXPECT_EQ(2u, tree().size());
}

TEST_F(DirectorySinkTest, WhatAKilledRunLeftIsRemoved) {
  for (bool overwrite : {false, true}) {
    options_.overwrite = overwrite;
    const pid_t child = fork();
    if (child == 0) {
      auto sink = openDirectorySink(options_);
      if (sink.ok())
        (void)sink->sink->writeTile({0, 0, 0}, bytes("half")).ok();
      kill(getpid(), SIGKILL);
    }
    int state = 0;
    waitpid(child, &state, 0);
    EXPECT_TRUE(fs::exists(fs::path(options_.path) / ".qmesh-build/lock"));
    auto sink = open();
    ASSERT_TRUE(sink);
    ASSERT_TRUE(sink->writeTile({1, 0, 0}, bytes("whole")).ok());
    ASSERT_TRUE(sink->commit("{}").ok());
    EXPECT_EQ(
        (std::map<std::string, std::string>{{"layer.json", "{}"}, {"1/0/0.terrain", "whole"}}),
        tree());
    fs::remove_all(options_.path);
  }
}

TEST_F(DirectorySinkTest, AHiddenFolderOfSomebodyElseIsLeftAlone) {
  put(".qmesh-build/mine.txt", "mine");
  options_.overwrite = true;
  (void)refusal();
  EXPECT_EQ((std::map<std::string, std::string>{{".qmesh-build/mine.txt", "mine"}}), tree());
}

/// Kills the swap after each of its renames in turn: the next run finds the old set whole, or the
/// new.
TEST_F(DirectorySinkTest, KilledAtAnyStepOfTheSwap) {
  options_.overwrite = true;
  int steps = 0;
  for (bool finished = false; !finished && steps < 200; ++steps) {
    fs::remove_all(options_.path);
    putOldSet();
    const auto before = tree();
    const pid_t child = fork();
    if (child == 0) {
      auto sink = openDirectorySink(options_);
      if (!sink.ok())
        _exit(3);
      writeNewSet(*sink->sink);
      renamesLeft = steps;
      _exit(sink->sink->commit("new layer").ok() ? 0 : 4);
    }
    int state = 0;
    waitpid(child, &state, 0);
    finished = WIFEXITED(state) && WEXITSTATUS(state) == 0;
    const bool newLayer = tree().count("layer.json") && tree()["layer.json"] == "new layer";
    options_.overwrite = false; // refused, but what was left is put right
    (void)refusal();
    options_.overwrite = true;
    EXPECT_EQ(newLayer ? newSetOverOld() : before, tree()) << "after step " << steps;
    EXPECT_EQ(finished || newLayer, newLayer);
  }
  EXPECT_GT(steps, 10);
}

TEST_F(DirectorySinkTest, ManyThreadsWriteAtOnce) {
  auto sink = open();
  std::vector<std::thread> threads;
  std::atomic<int> failures{0};
  for (unsigned t = 0; t < 8; ++t)
    threads.emplace_back([&, t] {
      for (unsigned k = 0; k < 200; ++k)
        failures += !sink->writeTile({9, k % 40, t * 50 + k / 40}, bytes(std::to_string(k))).ok();
    });
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(0, failures);
  ASSERT_TRUE(sink->commit("{}").ok());
  EXPECT_EQ(1601u, tree().size());
}

// The thread in front makes a folder while the others, which catch up, look whether it is there.
TEST_F(DirectorySinkTest, ManyThreadsMakeTheSameFolders) {
  std::atomic<int> failures{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&] {
      for (int k = 0; k < 2500; ++k)
        failures += !makeFolders((base_ / std::to_string(k)).string()).ok();
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(0, failures);
}

TEST_F(DirectorySinkTest, AFullDiskIsAnErrorThatNamesTheFile) {
  putOldSet();
  const auto before = tree();
  options_.overwrite = true;
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    int result = 1;
    {
      auto sink = openDirectorySink(options_);
      const rlimit limit{10000, 10000};
      setrlimit(RLIMIT_FSIZE, &limit);
      const bool small = sink->sink->writeTile({0, 0, 0}, std::vector<std::uint8_t>(9000)).ok();
      const Status status = sink->sink->writeTile({0, 1, 0}, std::vector<std::uint8_t>(20000));
      const bool named = status.message().find("0/1/0.terrain") != std::string::npos &&
                         status.message().find("too large") != std::string::npos;
      result = small && status.code() == Code::output && named ? 0 : 2;
    }
    _exit(result);
  }
  int state = 0;
  waitpid(child, &state, 0);
  EXPECT_TRUE(WIFEXITED(state) && WEXITSTATUS(state) == 0) << WEXITSTATUS(state);
  EXPECT_EQ(before, tree());
}

TEST_F(DirectorySinkTest, WritesIntoGdalsMemory) {
  options_.path = "/vsimem/gdalio-sink/out";
  auto sink = open();
  ASSERT_TRUE(sink);
  writeNewSet(*sink);
  std::string scratchPath;
  {
    const auto scratch = ScratchFolder::make(workFolder_);
    ASSERT_TRUE(scratch.ok());
    scratchPath = scratch->path();
    EXPECT_TRUE(fs::is_directory(scratchPath)) << "on a local disk";
    ASSERT_TRUE(sink->commit("new layer").ok());
  }
  EXPECT_FALSE(fs::exists(scratchPath));
  VSIStatBufL info;
  for (const char* name : {"layer.json", "0/0/0.terrain", "1/2/0.terrain", "Cesium/Build/x.js"})
    EXPECT_EQ(0, VSIStatL((options_.path + "/" + name).c_str(), &info)) << name;
  EXPECT_NE(0, VSIStatL((options_.path + "/.qmesh-build").c_str(), &info));
  (void)refusal();
}

TEST(ZoomNames, AreTheNumbersZeroToTwentyFour) {
  for (const char* name : {"0", "9", "10", "24"})
    EXPECT_TRUE(isZoomName(name)) << name;
  for (const char* name : {"", "25", "00", "01", "-1", "2024", "1a", "99999999999"})
    EXPECT_FALSE(isZoomName(name)) << name;
}

} // namespace
} // namespace qmesh
