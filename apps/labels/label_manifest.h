// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::app {

/** \brief What is in a directory of labelled clouds and how it was made, as
 * manifest.json there. It is written anew after each cloud, complete or not at all. */
class LabelManifest {
public:
  using Json = nlohmann::ordered_json;

  static constexpr const char* file_name = "manifest.json";

  /** \param[in] directory of the manifest
   * \param[in] parameters all that the labels depend on, besides the cloud
   * \param[in] classes names of the labels from 0 on */
  LabelManifest(const std::string& directory,
                Json parameters,
                const std::vector<std::string>& classes);

  /** \brief Take over the files of the manifest that is there, if there is one.
   * \throws InputError if it is no manifest, or one of other parameters */
  void resume();

  /** \brief Whether a cloud was labelled and its files are still there.
   * \param[in] input name of the file
   * \param[in] contents of the file */
  bool isDone(const std::string& input, std::string_view contents) const;

  /** \param[in] outputs names of files in the directory
   * \param[in] details points, counts and so on */
  void add(const std::string& input,
           std::string_view contents,
           const std::vector<std::string>& outputs,
           const Json& details);

  /** \brief What went wrong in this run; failures of earlier ones are forgotten. */
  void addFailure(const std::string& input, const std::string& error);

  void save() const;

  /** \brief Points of all files by label. */
  std::vector<std::uint64_t> totals() const;

private:
  std::string directory_;
  Json head_; ///< what must be the same to resume
  std::vector<std::string> classes_;
  Json files_ = Json::array(); ///< sorted by input
  Json failures_ = Json::array();
};

/** \brief A checksum, FNV-1a of 64 bits, in hexadecimal. */
std::string checksumOf(std::string_view contents);

} // namespace pcl::app
