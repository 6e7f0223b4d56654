// Compiled kernels kept between runs: what is restored is what was kept.
#include "host/compute/opencl/kernel_store.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "host/base/error.hpp"
#include "host/base/run_folder.hpp"
#include "host/base/whole_file.hpp"

namespace brdftab {
namespace {

namespace fs = std::filesystem;

class KernelStoreTest : public testing::Test {
 protected:
  KernelStoreTest() { fs::create_directories(work("0") / "AB" / "kernel"); }
  ~KernelStoreTest() override { fs::remove_all(folder_); }

  fs::path work(const std::string& name) const { return folder_ / name; }

  // Keeps the content as AB/kernel/kernel.so.
  void keep(const std::string& content) {
    write_whole(work("0") / "AB" / "kernel" / "kernel.so", content);
    store_.keep(work("0"));
  }

  std::vector<fs::path> kept() const {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "kernels"))
      if (entry.is_regular_file()) files.push_back(entry.path());
    return files;
  }

  // Returns the kernel that was restored into a new folder, or nothing if none was.
  std::string restored() {
    const fs::path target = work(std::to_string(++count_));
    damage_ = store_.restore(target);
    const auto file = target / "AB" / "kernel" / "kernel.so";
    return fs::exists(file) ? read_whole(file) : "";
  }

  const fs::path folder_ = fs::temp_directory_path() / fmt::format("kernel-store-{}", getpid());
  const KernelStore store_{folder_ / "kernels"};
  KernelStore::Damage damage_;
  int count_ = 0;
};

TEST_F(KernelStoreTest, RestoresWhatWasKept) {
  EXPECT_EQ(restored(), "");
  EXPECT_EQ(damage_.files, 0u);
  keep("code");
  EXPECT_EQ(restored(), "code");
  EXPECT_EQ(damage_.files, 0u);
}

// The checksum is the CRC-32 of gzip: its check value for "123456789" is cbf43926.
TEST_F(KernelStoreTest, NamesEndInTheChecksum) {
  keep("123456789");
  ASSERT_EQ(kept().size(), 1u);
  EXPECT_EQ(kept().front().filename(), "kernel.so.cbf43926");
}

TEST_F(KernelStoreTest, TemporaryFilesAreNotKept) {
  write_whole(work("0") / "tempfile_x.so", "half");
  write_whole(work("0") / "AB" / "last_accessed", "now");
  write_whole(work("0") / "AB" / "build.log", "log");
  write_whole(work("0") / "AB" / "program.bc_abcdef.temp", "half");
  write_whole(work("0") / "AB" / "program.bc", "");
  store_.keep(work("0"));
  EXPECT_FALSE(fs::exists(folder_ / "kernels"));
}

TEST_F(KernelStoreTest, EveryChangedBitIsFound) {
  const std::string content = "some code";
  for (std::size_t bit = 0; bit < 8 * content.size(); ++bit) {
    keep(content);
    std::string changed = content;
    changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << bit % 8));
    write_whole(kept().front(), changed);
    EXPECT_EQ(restored(), "");
    EXPECT_EQ(damage_.files, 1u);
    EXPECT_TRUE(kept().empty());
  }
}

TEST_F(KernelStoreTest, EveryTruncationIsFound) {
  const std::string content("code\0\0\0", 7);
  for (std::size_t length = 0; length < content.size(); ++length) {
    keep(content);
    fs::resize_file(kept().front(), length);
    EXPECT_EQ(restored(), "") << length;
    EXPECT_EQ(damage_.files, 1u) << length;
  }
}

TEST_F(KernelStoreTest, TheNewestOfSeveralServes) {
  keep("old");
  fs::last_write_time(kept().front(), fs::file_time_type::clock::now() - std::chrono::hours(1));
  keep("new");
  ASSERT_EQ(kept().size(), 2u);
  EXPECT_EQ(restored(), "new");
  EXPECT_EQ(damage_.files, 0u);
  EXPECT_EQ(kept().size(), 1u);
}

TEST_F(KernelStoreTest, TheOldestMakeRoom) {
  const std::string megabyte(1 << 20, 'x');
  for (int k = 0; k < 40; ++k) write_whole(work("0") / "AB" / fmt::format("{}.so", k), megabyte);
  fs::last_write_time(work("0") / "AB" / "7.so", fs::file_time_type::clock::now() - std::chrono::hours(1));
  store_.keep(work("0"));
  EXPECT_EQ(kept().size(), 40u);
  restored();
  EXPECT_EQ(damage_.files, 0u);
  EXPECT_EQ(kept().size(), 32u);
  EXPECT_FALSE(fs::exists(work(std::to_string(count_)) / "AB" / "7.so"));
}

// A death test is a child process, which takes nothing from its parent.
[[noreturn]] void end_in_child(RunFolder& folder) {
  folder.~RunFolder();
  std::exit(0);
}

TEST(RunFolder, IsRemovedWithItsOwnerOnly) {
  const fs::path parent = fs::temp_directory_path() / fmt::format("run-folder-{}", getpid());
  fs::create_directories(parent / "run-killed");
  write_whole(parent / "run-killed" / "lock", "");
  {
    const RunFolder first(parent);
    EXPECT_FALSE(fs::exists(parent / "run-killed"));
    write_whole(first.path() / "kernel.so", "code");
    {
      RunFolder second(parent);
      EXPECT_NE(first.path(), second.path());
      EXPECT_TRUE(fs::exists(first.path() / "kernel.so"));
      EXPECT_EXIT(end_in_child(second), testing::ExitedWithCode(0), "");
      EXPECT_TRUE(fs::exists(second.path()));
    }
    EXPECT_TRUE(fs::exists(first.path() / "kernel.so"));
  }
  EXPECT_TRUE(fs::is_empty(parent));
  fs::remove_all(parent);
}

}  // namespace
}  // namespace brdftab
