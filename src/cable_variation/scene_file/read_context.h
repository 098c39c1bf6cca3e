#pragma once  // internal to scene_file/

#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include <cable_variation/scene/scene.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/scene_file/yaml_cursor.h>

namespace cable_variation {

/// Names of one kind of thing, in the order of the scene's list of them.
class NameTable {
 public:
  explicit NameTable(std::string kind) : kind_(std::move(kind)) {}
  void setLongest(std::size_t bytes) { longest_ = bytes; }  ///< name

  /// Reads the `name` of an item, to be followed by exactly one entry in the
  /// scene's list. Absence, repetition, characters that a frame or topic
  /// could not hold and names that are too long are faults. Returns the item's cursor, labelled by it.
  YamlCursor add(const YamlCursor& item);

  /// A name that follows from others, likewise to be followed by one entry; a fault at `item` if it is taken.
  void declare(const YamlCursor& item, const std::string& name);

  /// Index of the thing that `cursor` names; a fault and npos if there is none.
  std::size_t find(const YamlCursor& cursor) const;
  /// As find(), of a key that must be there.
  std::size_t find(const YamlCursor& cursor, const std::string& key) const;

  const std::string& name(std::size_t index) const { return names_[index]; }
  int line(std::size_t index) const { return lines_[index]; }
  std::size_t size() const { return names_.size(); }
  const std::vector<std::string>& names() const { return names_; }

  static constexpr std::size_t npos = static_cast<std::size_t>(-1);

 private:
  void append(const std::string& name, int line);

  std::string kind_;
  std::size_t longest_ = InputLimits().name_bytes;
  std::vector<std::string> names_;
  std::vector<int> lines_;
  std::unordered_map<std::string, std::size_t> indices_;  // of each name's first place
};

/// What the readers of a scene file's parts share.
struct ReadContext {
  ReadContext(const std::string& file, PackageFinder finder, InputLimits bounds)
      : limits(std::move(bounds)), faults(file, limits.faults), find_package(std::move(finder)) {
    scene.source = file;
    for (NameTable* table : {&components, &cables, &clips, &joints, &loads, &design_variables, &measures,
                             &tolerance_regions, &motions}) {
      table->setLongest(limits.name_bytes);
    }
  }

  Scene scene;
  InputLimits limits;
  FaultList faults;
  PackageFinder find_package;

  NameTable components{"component"};
  NameTable cables{"cable"};
  NameTable clips{"clip"};
  NameTable joints{"joint"};
  NameTable loads{"load"};
  NameTable design_variables{"design variable"};
  NameTable measures{"measure"};
  NameTable tolerance_regions{"tolerance region"};
  NameTable motions{"motion"};
  std::map<std::string, Material> materials;
  std::map<std::size_t, bool>
      geometric_sections;  ///< by cable: all, or none, given by geometry; absent: mixed
  std::map<std::string, std::shared_ptr<const TriangleMesh>> meshes;  ///< unscaled, by path

  /// Of the cable of this index; NaN for NameTable::npos.
  double cableLength(std::size_t cable) const;
};

/// An arc length on a cable: start, end or a length within it. NaN after a fault.
double readArcLength(const YamlCursor& cursor, double cable_length);

/// Reads a list of named things: `read(item, thing)` what is beside the name.
template <class Thing, class Read>
void readEach(const YamlCursor& list, NameTable& names, std::vector<Thing>& things, const Read& read) {
  for (const YamlCursor& entry : list.items()) {
    const YamlCursor item = names.add(entry);
    Thing thing;
    thing.name = names.names().back();
    read(item, thing);
    things.push_back(std::move(thing));
  }
}

/// Readers of the parts, in the order in which they need each other.
void readMaterials(const YamlCursor& map, ReadContext& context);
void readComponents(const YamlCursor& list, ReadContext& context);
void readCables(const YamlCursor& list, ReadContext& context);
void readClips(const YamlCursor& list, ReadContext& context);
void readJoints(const YamlCursor& list, ReadContext& context);
void readLoads(const YamlCursor& list, ReadContext& context);
void readContacts(const YamlCursor& list, ReadContext& context);
void readDesignVariables(const YamlCursor& list, ReadContext& context);
void readToleranceRegion(const YamlCursor& item, ReadContext& context);  ///< an entry of design_variables
void readCorrelations(const YamlCursor& list, ReadContext& context);
void readMeasures(const YamlCursor& list, ReadContext& context);
void readMotions(const YamlCursor& list, ReadContext& context);
void readAttachments(const YamlCursor& list, ReadContext& context);

}  // namespace cable_variation
