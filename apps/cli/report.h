// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pcl::app {

/** \brief The number of a report that printSummary() gives, if there is one. */
inline const std::string largest_radius = "largest_curved_radius";

/** \brief What an app says about one file, for people and for machines. */
class Report {
public:
  /** \brief A value that is JSON already, such as a list of objects. */
  struct Json {
    std::string text;
  };

  using Value = std::variant<bool, std::uint64_t, double, std::string, Json>;
  using Entries = std::vector<std::pair<std::string, Value>>;

  struct Section {
    std::string name; ///< empty: the report itself; "a/b": b in a
    Entries entries;
  };

  void setText(const std::string& section,
               const std::string& name,
               const std::string& value);

  void setNumber(const std::string& section, const std::string& name, double value);

  void
  setCount(const std::string& section, const std::string& name, std::uint64_t value);

  void setFlag(const std::string& section, const std::string& name, bool value);

  /** \param[in] text valid JSON */
  void
  setJson(const std::string& section, const std::string& name, const std::string& text);

  /** \brief Run a stage and note its duration under "times_ms". */
  template <typename Stage>
  auto
  time(const std::string& name, const Stage& stage)
  {
    const Timer timer{*this, name, Clock::now()};
    return stage();
  }

  /** \brief The sum of the stages, milliseconds. */
  double totalTime() const;

  /** \brief A value that was set. \throws std::out_of_range if it was not */
  std::uint64_t count(const std::string& section, const std::string& name) const;

  double number(const std::string& section, const std::string& name) const;

  std::string text(const std::string& section, const std::string& name) const;

  const std::vector<Section>&
  sections() const
  {
    return sections_;
  }

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

  void set(const std::string& section, const std::string& name, Value value);

  const Value& get(const std::string& section, const std::string& name) const;

  std::vector<Section> sections_;
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

} // namespace pcl::app
