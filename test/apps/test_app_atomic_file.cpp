// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Output files appear as a whole or not at all, also when the process is killed.

#include "app_test.h"
#include "cli/atomic_file.h"
#include "cli/errors.h"

#include <csignal>
#include <filesystem>
#include <unistd.h>

#include <sys/stat.h>
#include <sys/wait.h>

namespace {

using namespace pcl::app;
using namespace pcl_shape_test;
namespace fs = std::filesystem;

class AtomicFileTest : public AppTest {};

TEST_F(AtomicFileTest, AppearsWithCommit)
{
  AtomicFile output(path("new"));
  output.write("contents");
  EXPECT_FALSE(exists(path("new")));
  output.commit();
  EXPECT_EQ(readFile(path("new")), "contents");
  EXPECT_EQ(files(), Words{"new"});
}

TEST_F(AtomicFileTest, LeavesNothingWithoutCommit)
{
  const std::string old = file("old", "as it was");
  {
    AtomicFile output(old);
    output.write("something else");
  }
  EXPECT_EQ(readFile(old), "as it was");
  EXPECT_EQ(files(), Words{"old"});
}

TEST_F(AtomicFileTest, KeepsThePermissionsAndTheLinks)
{
  const std::string old = file("old", "as it was");
  fs::permissions(old, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(old, path("link"));
  AtomicFile output(path("link"));
  output.write("new");
  output.commit();
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(readFile(old), "new");
  EXPECT_EQ(fs::status(old).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(AtomicFileTest, RefusesWhatIsNoFile)
{
  EXPECT_THROW(requireWritable(path("")), InputError);
  EXPECT_THROW(requireWritable(path("missing/new")), InputError);
  EXPECT_THROW(requireWritable("/dev/null"), InputError);
  requireWritable(path("new"));
  EXPECT_TRUE(files().empty());
}

TEST_F(AtomicFileTest, LeavesNothingWhenInterrupted)
{
  const std::string old = file("old", "as it was");
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    removeTemporaryFilesOnSignals();
    AtomicFile output(old);
    output.write("half");
    std::raise(SIGINT);
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGINT);
  EXPECT_EQ(readFile(old), "as it was");
  EXPECT_EQ(files(), Words{"old"});
}

} // namespace
