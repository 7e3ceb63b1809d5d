// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Output files that are complete or not there at all.

#include "app_test.h"
#include "io/errors.h"
#include "io/files.h"

#include <csignal>
#include <fcntl.h>
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

TEST_F(AtomicFileTest, ALeftOverOfThisProcessDoesNotBlock)
{
  const std::string number = '.' + std::to_string(getpid()) + ".tmp";
  file("new" + number, "of a process with this number");
  AtomicFile first(path("new")), second(path("new"));
  first.write("first");
  second.write("second");
  first.commit();
  second.commit();
  EXPECT_EQ(readFile(path("new")), "second");
  removeOrphans(path(""));
  EXPECT_EQ(files(), Words{"new"});
}

class EndingSignals : public AtomicFileTest,
                      public ::testing::WithParamInterface<int> {};

TEST_P(EndingSignals, LeaveNothing)
{
  const std::string old = file("old", "as it was");
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const int messages =
        ::open(path("messages").c_str(), O_WRONLY | O_CREAT, S_IRUSR | S_IWUSR);
    ::dup2(messages, STDERR_FILENO);
    removeTemporaryFilesOnSignals();
    AtomicFile output(old);
    output.write("half");
    std::raise(GetParam());
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), GetParam());
  EXPECT_EQ(readFile(old), "as it was");
  EXPECT_EQ(files(), (Words{"messages", "old"}));
  EXPECT_NE(readFile(path("messages")).find("ended by SIG"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    AtomicFile,
    EndingSignals,
    ::testing::Values(SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU, SIGXFSZ));

} // namespace
