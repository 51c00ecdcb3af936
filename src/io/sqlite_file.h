// An SQLite database that GDAL has made, opened by SQLite itself.
#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <memory>
#include <string>

namespace oblast::io {

class SqliteFile {
 public:
  enum class Access { read, write };
  /// Messages call the file `name`. For writing no journal is kept and nothing is flushed: the file is not in place
  /// yet, and is thrown away if something fails. Triggers do not fire. Throws IoError, as all functions do.
  SqliteFile(const std::string& path, Access access, const std::string& name);
  ~SqliteFile();
  SqliteFile(const SqliteFile&) = delete;
  SqliteFile& operator=(const SqliteFile&) = delete;

  void execute(const std::string& sql);
  /// Reports what only closing can find.
  void close();
  /// Throws IoError with SQLite's message.
  [[noreturn]] void fail() const;
  sqlite3* handle() const { return database_; }

 private:
  sqlite3* database_ = nullptr;
  std::string name_;
};

/// A prepared statement. Parameters and columns count from 1 and from 0, as in SQLite.
class SqliteStatement {
 public:
  SqliteStatement(SqliteFile& file, const std::string& sql);

  /// Texts and blobs must live until reset().
  void bind_null(int parameter) { check(sqlite3_bind_null(get(), parameter)); }
  void bind(int parameter, std::int64_t value) { check(sqlite3_bind_int64(get(), parameter, value)); }
  void bind(int parameter, double value) { check(sqlite3_bind_double(get(), parameter, value)); }
  void bind_text(int parameter, const char* text) {
    check(sqlite3_bind_text(get(), parameter, text, -1, SQLITE_STATIC));
  }
  void bind_blob(int parameter, const void* bytes, std::size_t size) {
    check(sqlite3_bind_blob64(get(), parameter, bytes, size, SQLITE_STATIC));
  }

  /// True if there is a row.
  bool step();
  void reset() { check(sqlite3_reset(get())); }
  /// One run of a statement that gives no rows.
  void run() {
    step();
    reset();
  }
  sqlite3_stmt* get() const { return statement_.get(); }

 private:
  void check(int code) const {
    if (code != SQLITE_OK) file_.fail();
  }
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  SqliteFile& file_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

/// A name in SQL, with its quotes.
std::string sql_name(const std::string& name);

}  // namespace oblast::io
