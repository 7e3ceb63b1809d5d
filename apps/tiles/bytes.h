// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Values as bytes of a file, one after the other.

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <utility>
#include <vector>

namespace pcl::app {

using Bytes = std::vector<std::uint8_t>;

template <typename T>
void
put(const T& value, Bytes& bytes)
{
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof(T));
  std::memcpy(bytes.data() + at, &value, sizeof(T));
}

/** \brief How many there are, and the values. */
template <typename T>
void
putAll(const std::vector<T>& values, Bytes& bytes)
{
  put<std::uint64_t>(values.size(), bytes);
  const auto* const from = reinterpret_cast<const std::uint8_t*>(values.data());
  bytes.insert(bytes.end(), from, from + values.size() * sizeof(T));
}

/** \brief Takes values in the order in which they were put. */
class ByteReader {
public:
  explicit ByteReader(Bytes bytes) : bytes_(std::move(bytes)) {}

  template <typename T>
  T
  take()
  {
    T value;
    copy(&value, sizeof(T));
    return value;
  }

  template <typename T>
  std::vector<T>
  takeAll()
  {
    std::vector<T> values(take<std::uint64_t>());
    copy(values.data(), values.size() * sizeof(T));
    return values;
  }

private:
  void
  copy(void* to, std::size_t size)
  {
    if (size > bytes_.size() - at_)
      throw std::logic_error("a result of a tile is too short");
    if (size > 0)
      std::memcpy(to, bytes_.data() + at_, size);
    at_ += size;
  }

  Bytes bytes_;
  std::size_t at_ = 0;
};

} // namespace pcl::app
