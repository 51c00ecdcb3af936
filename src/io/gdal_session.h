// The frame for every use of GDAL: drivers are registered once, messages are caught and not printed, and options are
// set for the calling thread only and restored.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace oblast::io {

/// Registers GDAL's drivers; only the first call does anything.
void register_gdal_drivers();

/// While an object of this class exists, it catches GDAL's messages on this thread.
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

/// While an object of this class exists, a GDAL configuration option has the given value on this thread.
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
