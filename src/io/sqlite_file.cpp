// Opening, errors, quotes; see sqlite_file.h.
#include "io/sqlite_file.h"

#include "io/layer.h"

namespace oblast::io {

SqliteFile::SqliteFile(const std::string& path, Access access, const std::string& name) : name_(name) {
  const int flags = access == Access::read ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE;
  if (sqlite3_open_v2(path.c_str(), &database_, flags | SQLITE_OPEN_NOMUTEX, nullptr) != SQLITE_OK) {
    const std::string reason = database_ ? sqlite3_errmsg(database_) : "out of memory";
    sqlite3_close(database_);
    throw IoError("cannot write " + name_ + ": " + reason);
  }
  if (access == Access::read) return;
  sqlite3_db_config(database_, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  for (const char* pragma : {"journal_mode = OFF", "synchronous = OFF", "locking_mode = EXCLUSIVE"}) {
    sqlite3_exec(database_, (std::string("PRAGMA ") + pragma).c_str(), nullptr, nullptr, nullptr);  // or it is slower
  }
}

SqliteFile::~SqliteFile() { sqlite3_close(database_); }

void SqliteFile::execute(const std::string& sql) {
  if (sqlite3_exec(database_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

void SqliteFile::close() {
  if (sqlite3_close(database_) != SQLITE_OK) fail();
  database_ = nullptr;
}

void SqliteFile::fail() const { throw IoError("cannot write " + name_ + ": " + sqlite3_errmsg(database_)); }

SqliteStatement::SqliteStatement(SqliteFile& file, const std::string& sql) : file_(file) {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(file.handle(), sql.c_str(), -1, &statement, nullptr) != SQLITE_OK) file.fail();
  statement_.reset(statement);
}

bool SqliteStatement::step() {
  const int code = sqlite3_step(get());
  if (code != SQLITE_ROW && code != SQLITE_DONE) file_.fail();
  return code == SQLITE_ROW;
}

std::string sql_name(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

}  // namespace oblast::io
