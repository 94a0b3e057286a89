// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "message_filters/subscriber.h"
#include "tf2_ros/transform_broadcaster.h"
#include "tf2_ros/transform_listener.h"

namespace tf2_ros
{
// Lets each message pass: its transform is there.
template<typename M, typename BufferT = Buffer>
class MessageFilter : public message_filters::SimpleFilter<M>
{
public:
  template<typename ... T>
  MessageFilter(message_filters::Filter & filter, BufferT &, const std::string &, uint32_t, const T & ...)
  {
    filter.then([this] { this->pass(); });
  }
};
}  // namespace tf2_ros
