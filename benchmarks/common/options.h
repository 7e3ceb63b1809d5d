// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Options that all benchmarks have, and running one.

#pragma once

#include <boost/program_options.hpp>

#include <string>

/** \brief What all programs are told: a cloud, read or generated, and how to run. */
struct Options {
  std::string cloud;    ///< a PCD file
  std::string generate; ///< instead of a file: "scene", "sheet" or "laser"
  std::string target;   ///< instruction set; parse() fills in the best one
  unsigned threads = 1;
  unsigned repeat = 3;
  bool shuffle = false;
};

/** \brief The options above, for a program to add its own ones. */
boost::program_options::options_description commonOptions(const std::string& program,
                                                          Options& options);

/** \brief Parse PCL's single-dash options, and clouds wherever they stand.
 * \param[in] options with "help", which is printed if it is asked for
 * \param[in] clouds where file names go, owned from now on; none are allowed without
 * \param[in] most_clouds -1 for any number
 * \return false if help was asked for \throws std::exception for what is not allowed
 */
bool parseCommandLine(int argc,
                      char** argv,
                      const boost::program_options::options_description& options,
                      boost::program_options::value_semantic* clouds = nullptr,
                      int most_clouds = -1);

/** \brief Parse PCL's single-dash options and an optional cloud, and choose the target.
 * Prints the help and exits if that is asked for. \throws std::exception for what is
 * not allowed
 */
void parse(int argc,
           char** argv,
           const boost::program_options::options_description& description,
           Options& options);

/** \brief run(argc, argv), with exit status 2 and one line for an exception. */
int runProgram(const char* name, int (*run)(int, char**), int argc, char** argv);
