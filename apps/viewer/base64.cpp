// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Base64 by the iterators of Boost, which know no padding.

#include "viewer/base64.h"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <array>
#include <cstdint>
#include <cstring>

namespace pcl::app {
namespace {

constexpr std::size_t group = 3; // bytes that make four letters

using Letters = boost::archive::iterators::base64_from_binary<
    boost::archive::iterators::transform_width<const std::uint8_t*, 6, 8>>;

} // namespace

std::string
toBase64(const void* bytes, std::size_t size)
{
  const auto* const begin = static_cast<const std::uint8_t*>(bytes);
  const std::size_t rest = size % group;
  std::string text;
  text.reserve((size + group - 1) / group * 4);
  text.append(Letters(begin), Letters(begin + (size - rest)));
  if (rest == 0)
    return text;
  std::array<std::uint8_t, group> last{};
  std::memcpy(last.data(), begin + (size - rest), rest);
  text.append(Letters(last.data()), Letters(last.data() + group));
  const std::size_t padding = group - rest;
  return text.replace(text.size() - padding, padding, padding, '=');
}

} // namespace pcl::app
