// `oblast generate fires`: writes the passes of fires.h as shapefiles.
#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cctype>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>

#include "io/layer.h"
#include "io/leftovers.h"
#include "io/write.h"
#include "oblast/command.h"
#include "oblast/console.h"
#include "oblast/fires.h"
#include "oblast/generate.h"
#include "oblast/interrupt.h"

namespace oblast::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* footer = R"(
Models the data of the 2013 paper: one shapefile per satellite pass, with contours of
the pixels in which a fire was detected (mostly quadrilaterals), in longitude and
latitude. All months are 3,906 files, 190,915 contours, 1,134,325 vertices. The same seed
gives the same coordinates on every machine. A month does not depend on other months.

Example: April, 470 files
  oblast generate fires --month april -o fires)";

constexpr const char* wgs84 =
    R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563,AUTHORITY["EPSG","7030"]],AUTHORITY["EPSG","6326"]],PRIMEM["Greenwich",0,AUTHORITY["EPSG","8901"]],UNIT["degree",0.0174532925199433,AUTHORITY["EPSG","9122"]],AUTHORITY["EPSG","4326"]])";

struct Arguments {
  std::string folder;
  bool overwrite = false;
  bool quiet = false;
  FiresOptions options;
};

int parse_month(std::string word) {
  static constexpr const char* names[] = {"january", "february", "march",     "april",   "may",      "june",
                                          "july",    "august",   "september", "october", "november", "december"};
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const FireMonth& month : fire_months) {
    if (word == names[month.month - 1] || word == std::to_string(month.month)) return month.month;
  }
  throw CLI::ValidationError(
      fmt::format("'{}' is not a month of the paper; choose from april, may, june, july, september, october", word));
}

bool is_generated(const fs::path& file) { return file.filename().string().rfind("fires-2011-", 0) == 0; }

constexpr const char* stage_name = "fires";

// What a killed run has left is removed. The folder may exist if it is empty, or if its generated files may be
// replaced.
void check_folder(const Arguments& arguments) {
  std::error_code error;
  const fs::path folder = arguments.folder;
  if (!fs::exists(folder, error)) return;
  if (!fs::is_directory(folder, error))
    throw io::IoError(arguments.folder + " exists and is not a folder; choose another name");
  io::remove_leftovers(folder, stage_name);
  if (!fs::is_empty(folder, error) && !arguments.overwrite) {
    throw io::IoError("the folder " + arguments.folder +
                      " is not empty (--overwrite replaces the generated files in it)");
  }
}

// Files are written to a temporary folder and moved at the end. If the work stops early, the folder is removed.
class Stage {
 public:
  explicit Stage(const fs::path& target) : target_(target) {
    fs::create_directories(target_);
    path_ = target_ / fmt::format(".{}.writing-{}", stage_name, io::stage_suffix());
    fs::create_directory(path_);
    lock_ = io::lock_stage(path_.string());
  }
  ~Stage() {
    if (lock_ >= 0) ::close(lock_);
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    fs::remove(target_, ignored);  // removes it only if it is empty
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  const fs::path& path() const { return path_; }

  void commit() {
    for (const fs::directory_entry& old : fs::directory_iterator(target_)) {
      if (is_generated(old.path())) fs::remove(old.path());
    }
    for (const fs::directory_entry& made : fs::directory_iterator(path_))
      fs::rename(made.path(), target_ / made.path().filename());
  }

 private:
  fs::path target_, path_;
  int lock_ = -1;
};

void write_passes(const std::vector<FirePass>& passes, const fs::path& folder, ProgressLine& progress) {
  io::WriteOptions options;
  options.crs_wkt = wgs84;
  std::atomic<std::size_t> done = 0;
  std::mutex mutex;
  tbb::parallel_for(std::size_t{0}, passes.size(), [&](std::size_t k) {
    stop_before_more_output();
    io::write((folder / (passes[k].name + ".shp")).string(), passes[k].contours, options);
    const std::size_t count = ++done;
    if (const std::unique_lock lock(mutex, std::try_to_lock); lock) {
      progress.show("writing", static_cast<double>(count) / static_cast<double>(passes.size()));
    }
  });
}

int run(const Arguments& arguments, bool json) {
  check_folder(arguments);
  const InterruptFlag watch;
  ProgressLine progress(!arguments.quiet);
  progress.show("generating", 0);
  const std::vector<FirePass> passes = generate_fires(arguments.options);
  Stage stage(arguments.folder);
  write_passes(passes, stage.path(), progress);
  stage.commit();
  progress.clear();
  std::size_t contours = 0, vertices = 0;
  for (const FirePass& pass : passes) {
    contours += pass.contours.contour_ends.size();
    vertices += pass.contours.points.size();
  }
  if (json) {
    const nlohmann::ordered_json object{
        {"output", arguments.folder}, {"seed", arguments.options.seed}, {"scale", arguments.options.scale},
        {"files", passes.size()},     {"contours", contours},           {"vertices", vertices}};
    fmt::print("{}\n", object.dump(2));
  } else if (!arguments.quiet) {
    fmt::print(stderr, "{}: {}, {}, {}\n", arguments.folder, counted(passes.size(), "file"),
               counted(contours, "contour"), counted(vertices, "vertex"));
  }
  return exit_done;
}

}  // namespace

void add_generate_fires(CLI::App& generate, Invocation& invocation) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = generate.add_subcommand("fires", "Satellite fire detections as a folder of shapefiles.");
  command->footer(footer);
  command->add_option("-o,--output", arguments->folder, "the folder to write")->required()->type_name("DIR");
  command->add_option("--seed", arguments->options.seed, "seed of the random fires (1)")->type_name("N");
  command->add_option("--scale", arguments->options.scale, "factor for the numbers of files, contours and vertices (1)")
      ->check(CLI::Range(1e-4, 100.0))
      ->type_name("X");
  command
      ->add_option_function<std::vector<std::string>>(
          "--month,--months",
          [arguments](const std::vector<std::string>& words) {
            for (const std::string& word : words) arguments->options.months.push_back(parse_month(word));
          },
          "only these months: april to july, september, october, or 4 to 7, 9, 10 (all six)")
      ->delimiter(',')
      ->type_name("MONTH,...");
  command->add_flag("--overwrite", arguments->overwrite, "replace the generated files in the folder");
  command->add_flag("--json", invocation.json, "print the summary as one JSON object on standard output");
  command->add_flag("-q,--quiet", arguments->quiet, "print no progress and no summary");
  command->callback([arguments, &invocation] {
    invocation.run = [arguments, &invocation] { return run(*arguments, invocation.json); };
  });
}

}  // namespace oblast::app
