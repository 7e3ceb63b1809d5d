// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "results/lines_file.h"

#include <nlohmann/json.hpp>

namespace pcl::app {

std::string
linesToJson(const std::string& input, const std::vector<CreaseLine>& lines)
{
  using Json = nlohmann::ordered_json;
  constexpr double degrees_per_radian = 180.0 / 3.14159265358979323846;
  Json json = {{"format", "pcl_shape lines"}, {"version", 1}, {"input", input}};
  json["lines"] = Json::array();
  for (const CreaseLine& line : lines)
    json["lines"].push_back({{"length", line.length},
                             {"angle_degrees", line.angle * degrees_per_radian},
                             {"spacing", line.spacing},
                             {"closed", line.closed},
                             {"points", line.points}});
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace pcl::app
