// What every use of GDAL here needs: drivers registered once, its messages caught instead of printed,
// its options set for the calling thread only and put back.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace oblast::io {

/// Registers GDAL's drivers; only the first call does anything.
void register_gdal_drivers();

/// While it lives, catches what GDAL has to say on this thread.
class GdalMessages {
 public:
  GdalMessages();
  ~GdalMessages();
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;

  bool failed() const { return !failure_.empty(); }
  /// The first failure, or else the last warning, or else `otherwise`.
  std::string text(const std::string& otherwise) const;
  void clear();

 private:
  friend struct GdalMessagesAccess;
  std::string failure_;
  std::string warning_;
};

/// While it lives, a GDAL configuration option has a value on this thread.
class ThreadOption {
 public:
  ThreadOption(const char* name, const char* value);
  ~ThreadOption();
  ThreadOption(const ThreadOption&) = delete;
  ThreadOption& operator=(const ThreadOption&) = delete;

 private:
  const char* name_;
  bool had_value_ = false;
  std::string old_value_;
};

}  // namespace oblast::io
