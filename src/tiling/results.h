// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The results in a directory: which are complete, and how those that are missing are
// computed by a team.

#pragma once

#include "tiling/checked_file.h"
#include "tiling/manifest.h"
#include "tiling/own_directory.h"

#include <pcl/tiling/team.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pcl::tiling {

/** \brief What has a result: tiles, or sections. */
struct Tasks {
  std::string kind;                 ///< for messages
  std::vector<std::uint64_t> sizes; ///< 0 for what needs no result
};

/** \brief Files with a name and a number each, and a manifest that says which of them
 * are complete. All ranks of the team make the same calls; the first one writes the
 * manifest. All methods throw a TilingError. */
class Results {
public:
  using Record = Manifest::Record;

  /** \param[in] directory made if it does not exist
   * \param[in] begin what results depend on: the first record of the manifest, with
   * which that of an earlier run is compared
   * \param[in] names of results that an earlier run may have begun
   * \param[in] team the processes that share the work */
  Results(const std::string& directory,
          const Record& begin,
          const std::set<std::string>& names,
          Team& team);

  /** \brief Compute the files of a name that are missing, the largest tasks first.
   * \param[in] task returns what write() has returned */
  void compute(const std::string& name, const Tasks& tasks, const Team::Work& task);

  /** \brief Takes the bytes of a task. */
  using Write = std::function<void(std::size_t number, const Bytes& bytes)>;

  /** \brief The same in one process, by one function that writes all files. */
  void computeAtOnce(const std::string& name,
                     const Tasks& tasks,
                     const std::function<void(const Write& write)>& function);

  /** \brief Write a file. \return a line: its number, size and checksum */
  std::string write(const std::string& name,
                    std::size_t number,
                    const std::function<void(WholeFile& file)>& fill) const;
  std::string
  write(const std::string& name, std::size_t number, const Bytes& bytes) const;

  bool isMissing(const std::string& name, const Tasks& tasks) const;

  /** \brief Read the files of a name: what is damaged is removed, and an error. */
  void check(const std::string& name, const Tasks& tasks);

  Bytes read(const std::string& name, std::size_t number) const;

  /** \brief The same, some bytes at a time. */
  void
  copyTo(const std::string& name,
         std::size_t number,
         const std::function<void(const void* data, std::size_t size)>& sink) const;

  /** \brief Remove files, in the first process. */
  void remove(const std::string& name);

  /** \brief Remove all files and the directory. */
  void removeAll();

  /** \brief What the first process has found for a name. */
  std::string decide(const std::string& name, const std::function<std::string()>& find);

  /** \brief What was found for a name, in this run or an earlier one. */
  std::optional<std::string> decision(const std::string& name) const;

private:
  /** A file that is complete. */
  struct Complete {
    std::uint64_t bytes = 0;
    std::string check;
  };

  /** Do tasks that return what write() has returned for each file; fail(number, error)
   * for the first failure. */
  template <typename Fail>
  void run(const std::string& name,
           const std::vector<std::size_t>& numbers,
           const Team::Work& work,
           const Fail& fail);
  /** In the first process, unless the manifest has the same already: files may have
   * been made anew. */
  void complete(const std::string& name, const std::string& written);
  void add(const Record& record);
  void makePlaceFor(const std::string& name);
  /** The ranks that do not write the manifest read it again. */
  void refresh();
  void begin(const Record& now);
  void readRecords();
  void take(const Record& record);
  const Complete* find(const std::string& name, std::size_t number) const;
  const Complete& completeAt(const std::string& name, std::size_t number) const;
  std::vector<std::size_t> missingOf(const std::string& name, const Tasks& tasks) const;
  void requireAll(const std::string& name,
                  const Tasks& tasks,
                  const std::string& failure) const;

  std::string directory_;
  Team& team_;
  std::optional<OwnDirectory> own_; ///< of the first process
  std::optional<Manifest> manifest_;
  std::map<std::string, std::map<std::size_t, Complete>> complete_;
  std::set<std::string> names_; ///< of directories
  std::map<std::string, std::string> decisions_;
};

} // namespace pcl::tiling
