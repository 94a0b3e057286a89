// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace tf2
{
class TransformException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
class LookupException : public TransformException
{
public:
  using TransformException::TransformException;
};
class ConnectivityException : public TransformException
{
public:
  using TransformException::TransformException;
};
class ExtrapolationException : public TransformException
{
public:
  using TransformException::TransformException;
};
}  // namespace tf2
