// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Creases as lines in a JSON file beside the output, complete or not at all.

#include "detection/lines_app.h"

#include "cli/files.h"
#include "cli/filter_app.h"
#include "results/result_files.h"

#include <optional>
#include <string>

namespace pcl::app {

int
runFilterWithLines(const Arguments& arguments, const LineFilter& filter)
{
  std::optional<AtomicFile> lines_file;
  if (arguments.has("lines")) {
    arguments.exclude("lines", "input_dir");
    arguments.exclude("lines", "output_dir");
    std::vector<std::string> others = arguments.operands(2);
    if (arguments.has("json"))
      others.push_back(arguments.text("json"));
    checkOutputPath(arguments, "lines", others);
    lines_file.emplace(arguments.text("lines"));
  }
  const int status = runFilter(arguments, [&](CloudFile& file, Report& report) {
    const std::vector<pcl::CreaseLine> lines = filter(file, report);
    if (lines_file)
      lines_file->write(linesToJson(file, lines));
  });
  if (lines_file && status == 0)
    lines_file->commit();
  return status;
}

} // namespace pcl::app
