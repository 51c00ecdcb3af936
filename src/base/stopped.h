#pragma once

namespace oblast::internal {

/// Thrown when work ends because its call has failed or was cancelled on another thread. It never leaves a call; the
/// original exception does (call.h). Only Call::attempt catches it.
struct Stopped {};

}  // namespace oblast::internal
