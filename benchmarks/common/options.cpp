// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The command line of the benchmarks.

#include "options.h"

#include "sweep/portable/targets.h"

#include <iostream>
#include <stdexcept>

namespace po = boost::program_options;

po::options_description
commonOptions(const std::string& program, Options& o)
{
  std::string targets;
  for (const std::string& target : pcl::kernels::availableTargets())
    targets += (targets.empty() ? "of this machine's: " : ", ") + target;
  po::options_description description(program + " [CLOUD.pcd] [options]");
  const auto add = [&](const char* name, auto* value, const std::string& help) {
    description.add_options()(name, po::value(value), help.c_str());
  };
  add("generate", &o.generate, "a cloud instead of a file: scene, sheet or laser");
  add("target", &o.target, targets);
  add("threads", &o.threads, "threads of everything that is compared");
  add("repeat", &o.repeat, "runs of each, in turns");
  description.add_options()("shuffle",
                            po::bool_switch(&o.shuffle),
                            "shuffle the points first")("help", "this");
  return description;
}

bool
parseCommandLine(int argc,
                 char** argv,
                 const po::options_description& options,
                 po::value_semantic* clouds,
                 int most_clouds)
{
  po::options_description all(options);
  po::positional_options_description positional;
  if (clouds) {
    all.add_options()("cloud", clouds);
    positional.add("cloud", most_clouds);
  }
  const int style =
      po::command_line_style::unix_style | po::command_line_style::allow_long_disguise;
  po::variables_map values;
  po::store(po::command_line_parser(argc, argv)
                .options(all)
                .positional(positional)
                .style(style & ~po::command_line_style::allow_guessing)
                .run(),
            values);
  po::notify(values);
  if (values.count("help") > 0) {
    std::cout << options;
    return false;
  }
  return true;
}

void
parse(int argc, char** argv, const po::options_description& description, Options& o)
{
  if (!parseCommandLine(argc, argv, description, po::value(&o.cloud), 1))
    std::exit(0);
  if (o.repeat == 0 || o.threads == 0)
    throw std::invalid_argument("at least 1 thread and 1 run are needed");
  if (!o.cloud.empty() && !o.generate.empty())
    throw std::invalid_argument("expected a file or -generate, not both");
  pcl::kernels::chooseTarget(o.target);
  if (o.target.empty())
    o.target = pcl::kernels::availableTargets().front();
}

int
runProgram(const char* name, int (*run)(int, char**), int argc, char** argv)
{
  try {
    return run(argc, argv);
  }
  catch (const std::exception& e) {
    std::cerr << name << ": " << e.what() << '\n';
    return 2;
  }
}
