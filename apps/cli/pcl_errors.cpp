// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Catches standard error while PCL computes: PCL_ERROR has no other way out.

#include "cli/pcl_errors.h"

#include "io/errors.h"

#include <pcl/console/print.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <unistd.h>

namespace pcl::app {
namespace {

/** Standard error goes to a file; the destructor puts it back and prints the text. */
class CaughtErrors {
public:
  CaughtErrors() : level_(pcl::console::getVerbosityLevel())
  {
    pcl::console::setVerbosityLevel(std::max(level_, pcl::console::L_ERROR));
    if (file_ && standard_error_ >= 0)
      ::dup2(fileno(file_.get()), STDERR_FILENO);
  }

  ~CaughtErrors()
  {
    restore();
    std::fputs(text.c_str(), stderr);
  }

  CaughtErrors(const CaughtErrors&) = delete;
  CaughtErrors& operator=(const CaughtErrors&) = delete;

  /** Stop catching, and keep in `text` what was printed. */
  void
  restore()
  {
    if (standard_error_ < 0)
      return;
    ::dup2(standard_error_, STDERR_FILENO);
    ::close(standard_error_);
    standard_error_ = -1;
    pcl::console::setVerbosityLevel(level_);
    if (!file_)
      return;
    std::rewind(file_.get());
    for (int c = std::fgetc(file_.get()); c != EOF; c = std::fgetc(file_.get()))
      text.push_back(static_cast<char>(c));
  }

  std::string text;

private:
  pcl::console::VERBOSITY_LEVEL level_;
  std::unique_ptr<FILE, int (*)(FILE*)> file_{std::tmpfile(), std::fclose};
  int standard_error_ = ::dup(STDERR_FILENO);
};

/** The last line without "[pcl::Class::method] " and the full stop, taken off. */
std::string
takeReason(std::string& text)
{
  while (!text.empty() && text.back() == '\n')
    text.pop_back();
  const std::size_t begin = text.find_last_of('\n') + 1; // 0 without one
  std::string reason = text.substr(begin);
  text.resize(begin);
  const std::size_t bracket = reason.find("] ");
  if (reason.rfind("[pcl::", 0) == 0 && bracket != std::string::npos)
    reason.erase(0, bracket + 2);
  if (!reason.empty() && reason.back() == '.')
    reason.pop_back();
  return reason;
}

} // namespace

void
withPclErrors(const std::string& path, const std::function<bool()>& call)
{
  CaughtErrors caught;
  const bool has_result = call();
  caught.restore();
  if (has_result)
    return;
  const std::string reason = takeReason(caught.text);
  throw InputError(path + ": " + (reason.empty() ? "PCL gives no result" : reason));
}

} // namespace pcl::app
