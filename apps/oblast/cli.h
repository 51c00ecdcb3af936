// The class of CLI11 that headers here name. Only files that add or read options include CLI11 itself, which costs each
// of them seconds to compile.
#pragma once

namespace CLI {
class App;
}  // namespace CLI
