// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What an app says about one file: the line for people and the -json file.

#pragma once

#include <nlohmann/json_fwd.hpp>

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief The number of a report that printSummary() gives, if there is one. */
inline const std::string largest_radius = "largest_curved_radius";

/** \brief Values by section and name. The section "" is the report itself, "a/b" is b
 * in a; sections appear in the order of their first value. */
class Report {
public:
  Report();
  ~Report();
  Report(Report&& other) noexcept;
  Report& operator=(Report&& other) noexcept;

  void setText(const std::string& section,
               const std::string& name,
               const std::string& value);

  void setNumber(const std::string& section, const std::string& name, double value);

  void
  setCount(const std::string& section, const std::string& name, std::uint64_t value);

  void setFlag(const std::string& section, const std::string& name, bool value);

  void setJson(const std::string& section,
               const std::string& name,
               const nlohmann::ordered_json& value);

  /** \brief Run a stage and note its duration under "times_ms". */
  template <typename Stage>
  auto
  time(const std::string& name, const Stage& stage)
  {
    const Timer timer{*this, name, Clock::now()};
    return stage();
  }

  /** \brief Whether a flag was set to true. */
  bool hasFlag(const std::string& section, const std::string& name) const;

  /** \brief A value that was set. \throws std::exception if it was not */
  std::uint64_t count(const std::string& section, const std::string& name) const;

  double number(const std::string& section, const std::string& name) const;

  std::string text(const std::string& section, const std::string& name) const;

  /** \brief One line: the points, the section "counts", the sum of the times. */
  std::string summary() const;

  /** \brief The values as one object. */
  nlohmann::ordered_json toJson() const;

private:
  using Clock = std::chrono::steady_clock;

  struct Timer {
    Report& report;
    const std::string& name;
    Clock::time_point start;

    ~Timer()
    {
      const std::chrono::duration<double, std::milli> elapsed = Clock::now() - start;
      report.setNumber("times_ms", name, elapsed.count());
    }
  };

  /** An object of values for each section. */
  std::unique_ptr<nlohmann::ordered_json> sections_;
};

/** \brief A file that could not be processed. */
struct Failure {
  std::string input;
  std::string error;
};

/** \brief The contents of the -json file of one run over one file. */
std::string toJson(const std::string& app, const Report& report);

/** \brief The same of a run over a directory. */
std::string toJson(const std::string& app,
                   const std::vector<Report>& reports,
                   const std::vector<Failure>& failures);

/** \brief The text of a JSON file; bytes that are not UTF-8 are replaced.
 * \param[in] indent -1 for one line */
std::string dumpJson(const nlohmann::ordered_json& json, int indent = 2);

/** \brief x, y and z. */
nlohmann::ordered_json vectorToJson(const float* v);

} // namespace pcl::app
