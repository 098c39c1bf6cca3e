#include <ros_interface/context/state_file.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

#include <ros/console.h>

#include <cable_variation/scene/design_slips.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/tracking/saved_design.h>
#include <cable_variation/util/encoded_word.h>
#include <cable_variation/util/output_file.h>
#include <cable_variation/util/regular_file.h>
#include <cable_variation/util/sha256.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/scene_loading.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::Scene;

namespace {

namespace fs = std::filesystem;

constexpr char kTitle[] = "cable_solver state 1";     // the first line: this and no other form
constexpr std::uintmax_t kMostBytes = 1'000'000'000;  // more than any design has
const ros::WallDuration kOften(0.1);                  // between two writings

std::string absolutePath(const std::string& path) {
  std::error_code ignored;
  return fs::absolute(path, ignored).string();
}

/// "KEY VALUE" that a text begins with; it is taken off.
std::string takeLine(std::string& text, const std::string& key) {
  const std::size_t end = text.find('\n');
  if (text.compare(0, key.size() + 1, key + " ") != 0 || end == std::string::npos)
    throw std::invalid_argument("its line '" + key + "' is missing");
  const std::string word = text.substr(key.size() + 1, end - key.size() - 1);
  text.erase(0, end + 1);
  return cable_variation::decodedWord(word);
}

void requireSame(const char* what, const std::string& found, const std::string& wanted) {
  if (found == wanted) return;
  throw std::invalid_argument(std::string("it is of the ") + what + " '" + found + "', expected '" + wanted +
                              "'");
}

}  // namespace

StateFile::StateFile(const ros::NodeHandle& node, std::string path, std::string asked)
    : node_(node), path_(std::move(path)), asked_(std::move(asked)) {}

void StateFile::restore(SolverContext& context) {
  std::error_code ignored;
  if (path_.empty() || fs::symlink_status(path_, ignored).type() == fs::file_type::not_found) return;
  std::string reason;
  bool ours = false;
  try {
    std::string text = cable_variation::readWhole(path_, kMostBytes);
    ours = text.compare(0, sizeof kTitle, std::string(kTitle) + "\n") == 0;
    if (!ours) throw std::invalid_argument("it is no state of a cable_solver");
    restoreFrom(text.erase(0, sizeof kTitle), context);
    written_ = context.designNumber();  // the file has it: the first edit need not wait for its turn
    ROS_INFO("the design is the one in force before, from '%s'; ~reset_design has the scene's",
             path_.c_str());
    return;
  } catch (const std::exception& error) {
    reason = error.what();
  }
  if (ours) {
    fs::rename(path_, path_ + ".old", ignored);
    ROS_WARN("the state in '%s' is not restored: %s; it is kept as '%s.old'", path_.c_str(), reason.c_str(),
             path_.c_str());
  } else {
    ROS_WARN("'%s' is left as it is, and no state is kept: %s", path_.c_str(), reason.c_str());
    path_.clear();
  }
}

void StateFile::restoreFrom(const std::string& text, SolverContext& context) const {
  std::string rest = text;
  requireSame("node", takeLine(rest, "node"), node_.getNamespace());
  requireSame("scene", takeLine(rest, "asked"), asked_);
  const std::string source = takeLine(rest, "scene");
  const std::string hash = takeLine(rest, "sha256");
  const bool edited = takeLine(rest, "edited") == "1";
  const bool other = source != absolutePath(context.loaded().source);
  if (!edited && !other) return;
  Scene loaded = other ? loadScene(source, context.limits()) : context.loaded();
  if (hash != cable_variation::sha256(cable_variation::readSceneFile(source, context.limits())))
    throw std::invalid_argument("'" + source + "' is not what it was");
  if (!edited) {
    context.load(std::move(loaded));
    return;
  }
  cable_variation::SavedDesign saved = cable_variation::readSavedDesign(rest, loaded);
  for (const std::string& slip : cable_variation::newSlips({loaded, {}}, saved.design))
    saved.design.scene.warnings.push_back({kSetDesignService, 0, slip});
  context.restore(std::move(loaded), std::move(saved));
}

void StateFile::contextChanged(const SolverContext& context) {
  if (path_.empty() || written_ == context.designNumber()) return;
  context_ = &context;
  const ros::WallDuration since = ros::WallTime::now() - last_;
  if (since >= kOften || since < ros::WallDuration(0.0)) {
    write();
  } else if (!later_.hasPending()) {
    later_ = node_.createWallTimer(
        kOften - since, [this](const ros::WallTimerEvent&) { write(); }, true);
  }
}

void StateFile::write() {
  written_ = context_->designNumber();
  last_ = ros::WallTime::now();
  const auto line = [](const char* key, const std::string& value) {
    return std::string(key) + " " + cable_variation::encodedWord(value) + "\n";
  };
  std::string text = std::string(kTitle) + "\n";
  text += line("node", node_.getNamespace()) + line("asked", asked_);
  text += line("scene", absolutePath(context_->loaded().source));
  text += line("sha256", context_->origin().source_hash);
  text += line("edited", context_->edited() ? "1" : "0");
  if (context_->edited()) {
    text += cable_variation::savedDesignText(context_->design(), context_->loaded(), context_->lastShape());
  }
  try {
    std::error_code ignored;
    fs::create_directories(fs::path(path_).parent_path(), ignored);
    cable_variation::writeFile(path_, text);
  } catch (const std::exception& error) {
    ROS_ERROR_THROTTLE(60.0, "the state is not kept: %s", error.what());
  }
}

}  // namespace cable_variation_ros
