#pragma once

namespace oblast::internal {

/// Thrown where work ends because its call has failed elsewhere, or was cancelled there. It never leaves a call: what
/// was thrown there does (call.h). Nobody catches it but Call::attempt.
struct Stopped {};

}  // namespace oblast::internal
