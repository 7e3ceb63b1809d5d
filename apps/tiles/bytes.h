// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Values as bytes of a file, one after the other.

#pragma once

#include <array>
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
  const auto* const from = reinterpret_cast<const std::uint8_t*>(&value);
  bytes.insert(bytes.end(), from, from + sizeof(T));
}

/** \brief How many there are, and the values. */
template <typename T>
void
put(const std::vector<T>& values, Bytes& bytes)
{
  put<std::uint64_t>(values.size(), bytes);
  const auto* const from = reinterpret_cast<const std::uint8_t*>(values.data());
  bytes.insert(bytes.end(), from, from + values.size() * sizeof(T));
}

template <typename T, std::size_t size>
void
put(const std::array<std::vector<T>, size>& vectors, Bytes& bytes)
{
  for (const std::vector<T>& values : vectors)
    put(values, bytes);
}

/** \brief Some values and vectors, one after the other. */
template <typename... T>
Bytes
bytesOf(const T&... values)
{
  Bytes bytes;
  (put(values, bytes), ...);
  return bytes;
}

/** \brief Takes values and vectors in the order in which they were put. */
class ByteReader {
public:
  explicit ByteReader(Bytes bytes) : bytes_(std::move(bytes)) {}

  template <typename... T>
  void
  take(T&... values)
  {
    (takeOne(values), ...);
  }

private:
  template <typename T>
  void
  takeOne(T& value)
  {
    copy(&value, sizeof(T));
  }

  template <typename T>
  void
  takeOne(std::vector<T>& values)
  {
    std::uint64_t size = 0;
    takeOne(size);
    values.resize(size);
    copy(values.data(), size * sizeof(T));
  }

  template <typename T, std::size_t size>
  void
  takeOne(std::array<std::vector<T>, size>& vectors)
  {
    for (std::vector<T>& values : vectors)
      takeOne(values);
  }

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

/** \brief The only value or vector of some bytes, or the first one. */
template <typename T>
T
takeFrom(Bytes bytes)
{
  T value{};
  ByteReader(std::move(bytes)).take(value);
  return value;
}

} // namespace pcl::app
