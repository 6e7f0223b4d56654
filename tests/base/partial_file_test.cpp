// A file that appears under its name only when it is complete.
#include "host/base/partial_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <iterator>
#include <string>

#include "host/base/error.hpp"
#include "host/base/whole_file.hpp"

namespace brdftab {
namespace {

class PartialFileTest : public testing::Test {
 protected:
  PartialFileTest() { std::filesystem::create_directories(folder_); }
  ~PartialFileTest() override { std::filesystem::remove_all(folder_); }

  std::size_t files() const {
    const std::filesystem::directory_iterator begin(folder_), end;
    return static_cast<std::size_t>(std::distance(begin, end));
  }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("partial_file_test." + std::to_string(getpid()));
  const std::filesystem::path target_ = folder_ / "table";
};

TEST_F(PartialFileTest, TheModeIsWhatTheUmaskLeaves) {
  for (const mode_t mask : {0022, 0027, 0077}) {
    const mode_t before = umask(mask);
    PartialFile file(target_, true);
    umask(before);
    file.commit();
    struct stat status {};
    ASSERT_EQ(stat(target_.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0666 & ~mask);
  }
}

TEST_F(PartialFileTest, NothingStaysWithoutCommit) {
  {
    const PartialFile first(target_, false), second(target_, false);
    EXPECT_NE(first.path(), second.path());
    EXPECT_EQ(files(), 2u);
    EXPECT_FALSE(std::filesystem::exists(target_));
  }
  EXPECT_EQ(files(), 0u);
}

TEST_F(PartialFileTest, AFileThatAppearedMeanwhileStays) {
  PartialFile file(target_, false);
  write_whole(target_, "mine");
  EXPECT_THROW(file.commit(), FileError);
  EXPECT_EQ(read_whole(target_), "mine");
}

TEST_F(PartialFileTest, AFolderThatCannotBeWrittenIsRefused) {
  EXPECT_THROW(PartialFile("/proc/table", false), FileError);
  EXPECT_THROW(PartialFile(folder_ / "none" / "table", false), FileError);
}

}  // namespace
}  // namespace brdftab
