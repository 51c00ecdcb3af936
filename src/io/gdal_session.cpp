// Drivers, messages and options of GDAL; see gdal_session.h.
#include "io/gdal_session.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal_priv.h>

#include <mutex>

namespace oblast::io {

struct GdalMessagesAccess {
  static void CPL_STDCALL handle(CPLErr severity, CPLErrorNum, const char* text) {
    auto* messages = static_cast<GdalMessages*>(CPLGetErrorHandlerUserData());
    if (severity >= CE_Failure) {
      if (messages->failure_.empty()) messages->failure_ = text;
    } else if (severity == CE_Warning) {
      messages->warning_ = text;
    }
  }
};

void register_gdal_drivers() {
  static std::once_flag once;
  std::call_once(once, [] { GDALAllRegister(); });
}

GdalMessages::GdalMessages() { CPLPushErrorHandlerEx(&GdalMessagesAccess::handle, this); }

GdalMessages::~GdalMessages() {
  CPLPopErrorHandler();
  CPLErrorReset();
}

std::string GdalMessages::text(const std::string& otherwise) const {
  if (!failure_.empty()) return failure_;
  return warning_.empty() ? otherwise : warning_;
}

void GdalMessages::clear() {
  failure_.clear();
  warning_.clear();
  CPLErrorReset();
}

ThreadOption::ThreadOption(const char* name, const char* value) : name_(name) {
  if (const char* old = CPLGetThreadLocalConfigOption(name, nullptr)) {
    had_value_ = true;
    old_value_ = old;
  }
  CPLSetThreadLocalConfigOption(name, value);
}

ThreadOption::~ThreadOption() { CPLSetThreadLocalConfigOption(name_, had_value_ ? old_value_.c_str() : nullptr); }

}  // namespace oblast::io
